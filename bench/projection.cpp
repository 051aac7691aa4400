// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/projection.cpp
#include "projection.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "spigolo/core/error.h"
#include "spigolo/detect/detect.h"
#include "spigolo/mls/sharp.h"
#include "spigolo/mls/sharp_neighborhood.h"

namespace spigolo::bench {
namespace {

// A point of the exact surface.
struct Place {
  Vec3 point, normal;
  double to_edge = 0;  // [spacings]
};

// The patch's normal: off the surface, the way to the nearest point runs along it.
Vec3 normal_of(const Patch& patch, const Vec3& p, double step) {
  Vec3 best;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Vec3 off = p;
    off[axis] += step;
    const Vec3 way = off - patch.nearest(off);
    if (squared_norm(way) > squared_norm(best)) best = way;
  }
  return normalized(best);
}

std::vector<Place> sample_places(const Specimen& s, std::size_t count, std::uint64_t seed) {
  Random random(seed);
  const Shape& shape = s.synth.shape;
  const double whole = area(shape);
  std::vector<Place> places;
  while (places.size() < count) {
    double at = random.uniform(0, whole);
    const Patch* patch = &shape.patches.back();
    for (const Patch& candidate : shape.patches)
      if ((at -= candidate.area) < 0) {
        patch = &candidate;
        break;
      }
    const Vec3 p = patch->sample(random);
    if (border_distance(shape, p) < 3 * s.spacing) continue;
    places.push_back(
        {p, normal_of(*patch, p, 1e-4 * s.spacing), edge_distance(shape, p) / s.spacing});
  }
  return places;
}

void measure_distances(const Specimen& s, const Projection& project, std::size_t queries,
                       ProjectionQuality& q) {
  Random random(23);
  double squares = 0, near_squares = 0, angles = 0;
  std::size_t count = 0, near = 0, beside = 0;
  std::vector<double> moved;
  for (const Place& place : sample_places(s, queries, 17)) {
    const SurfacePoint on =
        project(place.point + place.normal * (random.uniform(-0.3, 0.3) * s.spacing));
    if (!on_surface(on.status)) {
      q.lost += 1.0 / static_cast<double>(queries);
      continue;
    }
    const double d = surface_distance(s.synth.shape, on.position) / s.spacing;
    squares += d * d, ++count;
    if (place.to_edge <= 3) near_squares += d * d, ++near, q.max_near = std::max(q.max_near, d);
    if (moved.size() < queries / 6)
      moved.push_back(distance(project(on.position).position, on.position) / s.spacing);
    if (place.to_edge < 0.1 || place.to_edge > 1.5) continue;
    angles += degrees(axial_angle(project(place.point).normal, place.normal)), ++beside;
  }
  const auto mean = [](double sum, std::size_t n) { return n ? sum / static_cast<double>(n) : 0; };
  q.rms = std::sqrt(mean(squares, count)), q.rms_near = std::sqrt(mean(near_squares, near));
  q.normal_error = mean(angles, beside);
  std::sort(moved.begin(), moved.end());
  if (!moved.empty()) q.again = moved[moved.size() * 99 / 100];
}

// Distance across the edge from x to the nearest of the projections of places round about it.
double gap_at(const Specimen& s, const Projection& project, const Vec3& x, const Vec3& along) {
  const Vec3 u = any_perpendicular(along), v = cross(along, u);
  double best = infinity;
  for (const double r : {0.0, 0.05, 0.1, 0.2, 0.3, 0.5})
    for (int turn = 0; turn < 12; ++turn) {
      const double a = 2 * pi * turn / 12;
      const SurfacePoint on = project(x + (u * std::cos(a) + v * std::sin(a)) * (r * s.spacing));
      if (!on_surface(on.status)) continue;
      const Vec3 off = on.position - x;
      const double forth = dot(off, along);
      if (std::abs(forth) < 0.7 * s.spacing) best = std::min(best, norm(off - along * forth));
    }
  return best / s.spacing;
}

void measure_gaps(const Specimen& s, const Projection& project, ProjectionQuality& q) {
  const Shape& shape = s.synth.shape;
  constexpr int per_crease = 12;
  double sum = 0;
  std::size_t count = 0;
  for (const ExactCrease& crease : shape.creases)
    for (int i = 0; i < per_crease; ++i) {
      const double t = (i + 0.5) / per_crease;
      const Vec3 x = crease.curve.at(t);
      if (border_distance(shape, x) < 3 * s.spacing) continue;
      const Vec3 along = normalized(crease.curve.at(t + 1e-5) - crease.curve.at(t - 1e-5));
      const double gap = std::min(gap_at(s, project, x, along), 3.0);
      sum += gap, ++count;
      q.gap_max = std::max(q.gap_max, gap);
    }
  if (count > 0) q.gap = sum / static_cast<double>(count);
}

void measure_corners(const Specimen& s, const Projection& project, ProjectionQuality& q) {
  Random random(29);
  std::size_t count = 0;
  for (const Corner& corner : s.synth.shape.corners) {
    if (border_distance(s.synth.shape, corner.position) < 3 * s.spacing) continue;
    double best = 3;
    for (int i = 0; i < 200; ++i) {
      const double reach = i == 0 ? 0 : s.spacing;
      const SurfacePoint on = project(corner.position + random.in_ball() * reach);
      if (on_surface(on.status))
        best = std::min(best, distance(on.position, corner.position) / s.spacing);
    }
    q.corner += best, ++count;
  }
  if (count > 0) q.corner /= static_cast<double>(count);
}

void measure_smoothing(const Specimen& s, const Projection& project, ProjectionQuality& q) {
  double squares = 0;
  std::size_t count = 0;
  const std::size_t step = std::max<std::size_t>(1, s.synth.cloud.size() / 5000);
  for (std::size_t i = 0; i < s.synth.exact.size(); i += step) {
    const Vec3& exact = s.synth.exact[i];
    if (edge_distance(s.synth.shape, exact) < 6 * s.spacing) continue;
    if (border_distance(s.synth.shape, exact) < 6 * s.spacing) continue;
    const SurfacePoint on = project(s.synth.cloud.points[i]);
    const double d = surface_distance(s.synth.shape, on.position) / s.spacing;
    squares += d * d, ++count;
  }
  if (count > 0) q.smooth_rms = std::sqrt(squares / static_cast<double>(count));
}

Projection plain(const MlsCloud& cloud, std::span<const PointKind>, const MlsOptions& options) {
  const MlsOptions settled = settle(options, cloud.noise());
  return [&cloud, settled, scratch = MlsScratch()](const Vec3& query) mutable {
    return project_plain(cloud, query, settled, scratch);
  };
}

Projection feature_line(const MlsCloud& cloud, std::span<const PointKind> kind,
                        const MlsOptions& options) {
  FeatureLineOptions settled;
  settled.mls = settle(options, cloud.noise());
  const auto features = std::make_shared<FeatureMap>(
      map_features(cloud, ordered_kinds(cloud.ordered(), kind), settled.mls.k));
  return [&cloud, settled, features, scratch = FeatureLineScratch()](const Vec3& query) mutable {
    return project_feature_line(cloud, *features, query, settled, scratch);
  };
}

Projection sheets(const MlsCloud& cloud, std::span<const PointKind>, const MlsOptions& options) {
  std::vector<Vec3> points(cloud.points().begin(), cloud.points().end());
  for (Vec3& p : points) p += cloud.origin();
  const auto surface = std::make_shared<SharpSurface>(points, options);
  return [surface, probe = std::make_shared<SheetProbe>(surface->probe())](const Vec3& query) {
    return project_sharp(*surface, query, *probe);
  };
}

}  // namespace

const std::vector<ProjectionMethod>& projection_methods() {
  static const std::vector<ProjectionMethod> methods = {
      {"plain", plain}, {"feature-line", feature_line}, {"sheets", sheets}};
  return methods;
}

const ProjectionMethod& projection_method(const std::string& name) {
  for (const ProjectionMethod& method : projection_methods())
    if (name == method.name) return method;
  throw UsageError("there is no projection '" + name + "'");
}

Specimen make_specimen(std::string name, SynthOptions options) {
  const double noise = std::exchange(options.noise, 0.0);
  Specimen s;
  s.synth = make_cloud(options);
  s.spacing = std::sqrt(area(s.synth.shape) / static_cast<double>(s.synth.exact.size()));
  if (noise > 0) {
    options.noise = noise * s.spacing / s.synth.spacing;
    s.synth = make_cloud(options);
  }
  s.name = std::move(name), s.noise = noise;
  s.kind = detect(s.synth.cloud.points).features.kind;
  return s;
}

ProjectionQuality measure_projection(const Specimen& specimen, const Projection& project,
                                     std::size_t queries) {
  ProjectionQuality q;
  measure_distances(specimen, project, queries, q);
  measure_gaps(specimen, project, q);
  measure_corners(specimen, project, q);
  measure_smoothing(specimen, project, q);
  return q;
}

}  // namespace spigolo::bench
