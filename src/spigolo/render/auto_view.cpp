// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/auto_view.cpp
#include "spigolo/render/auto_view.h"

#include <array>

#include "spigolo/core/random.h"
#include "spigolo/render/camera.h"

namespace spigolo {
namespace {

constexpr std::size_t most_samples = 20000;  // of surface and of features each
constexpr double feature_weight = 0.8;       // a view of all features against one of all surface
constexpr double spread_weight = 0.4;        // against a picture filled by the projection
constexpr double least_gain = 1.02;          // a later candidate must be this much better

struct Samples {
  std::vector<Vec3> surface, features;
};

void thin_out(std::vector<Vec3>& out, std::span<const Vec3> points, std::size_t limit) {
  const std::size_t count = std::min(points.size(), limit);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3& p = points[points.size() * i / count];
    if (is_finite(p)) out.push_back(p);
  }
}

// Points on the triangles, as many as their area deserves.
void sample_mesh(std::vector<Vec3>& out, const MeshLayer& mesh) {
  std::vector<double> areas;  // running sums
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    const double a =
        norm(cross(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]]));
    areas.push_back(sum += std::isfinite(a) ? a : 0);
  }
  if (!(sum > 0)) return;
  Random random(1);
  for (std::size_t i = 0; i < most_samples; ++i) {
    const auto at = std::upper_bound(areas.begin(), areas.end(), random.uniform(0, sum));
    const auto& t =
        mesh.triangles[static_cast<std::size_t>(std::min(at, areas.end() - 1) - areas.begin())];
    double u = random.uniform(), v = random.uniform();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const Vec3& a = mesh.points[t[0]];
    const Vec3 p = a + u * (mesh.points[t[1]] - a) + v * (mesh.points[t[2]] - a);
    if (is_finite(p)) out.push_back(p);
  }
}

Samples sample(const Scene& scene) {
  Samples samples;
  for (const PointLayer& layer : scene.points)
    thin_out(layer.style == PointStyle::surface ? samples.surface : samples.features, layer.points,
             most_samples);
  for (const MeshLayer& layer : scene.meshes) sample_mesh(samples.surface, layer);
  std::vector<Vec3> vertices;
  for (const LineLayer& layer : scene.lines)
    for (const auto& line : layer.lines) vertices.insert(vertices.end(), line.begin(), line.end());
  thin_out(samples.features, vertices, most_samples);
  return samples;
}

// A picture so coarse that each of its cells is hit by some sample of a surface that faces the eye.
class CoarseDepth {
 public:
  CoarseDepth(const Samples& samples, const Vec3& direction, const View& view) {
    const double n = static_cast<double>(samples.surface.size() + samples.features.size());
    side_ = static_cast<int>(std::clamp(std::sqrt(n / 5), 4.0, 60.0));
    const std::array<std::span<const Vec3>, 2> all = {samples.surface, samples.features};
    View plain;
    plain.up = view.up, plain.perspective = view.perspective;
    const double s = side_;
    camera_ = fit_camera(all, plain, direction, {0, 0, s, s}, {});
    depth_.assign(static_cast<std::size_t>(side_ * side_), infinity);
    for (const Vec3& p : samples.surface) {
      double& d = depth_[cell(p)];
      d = std::min(d, camera_.project(p).z);
    }
  }
  /// The share of the points that nothing nearer hides.
  double visible(std::span<const Vec3> points) const {
    std::size_t seen = 0;
    for (const Vec3& p : points) {
      const double z = camera_.project(p).z;
      seen += z <= depth_[cell(p)] + 2.5 * camera_.pixel_size(z) ? 1 : 0;
    }
    return points.empty() ? 0 : static_cast<double>(seen) / static_cast<double>(points.size());
  }
  double filled() const {
    const auto hit = [](double d) { return d < infinity; };
    return static_cast<double>(std::count_if(depth_.begin(), depth_.end(), hit)) /
           static_cast<double>(depth_.size());
  }

 private:
  std::size_t cell(const Vec3& p) const {
    const Projected q = camera_.project(p);
    const auto clip = [&](double v) { return std::clamp(static_cast<int>(v), 0, side_ - 1); };
    return static_cast<std::size_t>(clip(q.y) * side_ + clip(q.x));
  }
  int side_ = 1;
  Camera camera_;
  std::vector<double> depth_;
};

}  // namespace

Vec3 best_direction(const Scene& scene, const View& view) {
  const Samples samples = sample(scene);
  Vec3 best = view_direction(radians(30), radians(28));
  double best_score = 0;
  for (const double elevation : {28.0, 58.0, -28.0})
    for (const double azimuth : {30.0, 60.0, 330.0, 300.0, 120.0, 150.0, 210.0, 240.0}) {
      const Vec3 direction = view_direction(radians(azimuth), radians(elevation));
      const CoarseDepth depth(samples, direction, view);
      const double score = depth.visible(samples.surface) +
                           feature_weight * depth.visible(samples.features) +
                           spread_weight * depth.filled();
      if (score > least_gain * best_score) best_score = score, best = direction;
    }
  return best;
}

}  // namespace spigolo
