// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/detect/detect.cpp - order, neighbors, spacing, verdicts, back to the order of the input
#include "spigolo/detect/detect.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "spigolo/core/error.h"
#include "spigolo/gauss_map/adapt.h"
#include "spigolo/index/neighborhoods.h"
#include "spigolo/index/noise.h"
#include "spigolo/index/order.h"
#include "spigolo/index/spacing.h"

namespace spigolo {
namespace {

constexpr std::size_t smallest_k = 8;  // fewer neighbors say nothing (thesis §3.5.1)
constexpr std::size_t noise_k = 16;    // neighbors that the noise estimate looks at

// Written so that a NaN fails it too.
void require(bool sound, const char* message) {
  if (!sound) throw UsageError(message);
}

void check(const DetectOptions& o) {
  require(o.k >= 4 && o.k <= 64, "k must be between 4 and 64 neighbors");
  require(o.sigma == from_noise || (o.sigma > 0 && o.sigma <= half_pi),
          "sigma must be above 0 and at most pi/2 = 1.5708 rad");
  require(o.flatness >= 0 && o.flatness <= 1, "flatness must be between 0 and 1");
  require(o.min_cluster == from_noise || (o.min_cluster >= 0 && o.min_cluster <= 0.5),
          "min-cluster must be between 0 and 0.5");
}

// The thesis starts with sigma 0.1 rad, which holds without noise; with noise the normals of one
// sheet spread wider than that and neither it nor the smallest cluster can stay
// (docs/detection.md).
FeatureTestOptions for_noise(double noise, const DetectOptions& given) {
  struct Row {
    double up_to, sigma, min_cluster;  // [spacings], [rad], share
  };
  constexpr Row rows[] = {{0.03, 0.1, 0.15}, {0.1, 0.6, 0.18}, {infinity, 0.9, 0.22}};
  const Row& row = *std::find_if(std::begin(rows), std::end(rows),
                                 [&](const Row& r) { return noise <= r.up_to; });
  FeatureTestOptions test;
  test.sigma = given.sigma == from_noise ? row.sigma : given.sigma;
  test.min_cluster = given.min_cluster == from_noise ? row.min_cluster : given.min_cluster;
  test.flatness = given.flatness;
  return test;
}

// Whether all points lie within a billionth of the cloud's size of one line.
bool all_on_a_line(std::span<const Vec3> points) {
  const auto from_first = [&](const Vec3& p) { return squared_distance(p, points.front()); };
  const Vec3 far = *std::max_element(
      points.begin(), points.end(),
      [&](const Vec3& a, const Vec3& b) { return from_first(a) < from_first(b); });
  const Vec3 along = normalized(far - points.front());
  const double tolerance = 1e-9 * distance(far, points.front());
  return std::all_of(points.begin(), points.end(), [&](const Vec3& p) {
    return norm(cross(p - points.front(), along)) <= tolerance;
  });
}

void check(const OrderedCloud& cloud) {
  if (cloud.size() == 0) throw NoResultError("the cloud has no point with finite coordinates");
  if (cloud.size() < smallest_k + 1)
    throw NoResultError("the cloud has only " + std::to_string(cloud.size()) +
                        " different places; at least " + std::to_string(smallest_k + 1) +
                        " are needed to find features");
  if (all_on_a_line(cloud.points))
    throw NoResultError("all points lie on one line: there is no surface to find features on");
}

Features in_canonical_order(const OrderedCloud& cloud, const Neighborhoods& neighborhoods,
                            std::size_t k, const GaussMapFeatures& found) {
  Features features;
  features.assign_surface(cloud.size());
  std::vector<Vec3> neighbors;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const FeatureTest& test = found.test[i];
    if (test.verdict != FeatureVerdict::sharp) continue;
    neighbors.clear();
    for (const std::uint32_t j : neighborhoods.of(i).first(k)) neighbors.push_back(cloud.points[j]);
    features.kind[i] = test.clusters == 2 ? PointKind::edge : PointKind::corner;
    features.angle[i] = edge_deviation(cloud.points[i], neighbors, test.normal);
    // A point right on an edge has a quarter of its triangles in each sheet.
    features.strength[i] = static_cast<float>(std::clamp(test.second_share / 0.25, 0.01, 1.0));
    features.crease_point[i] = cloud.points[i] + cloud.origin;  // every triangle holds the point
  }
  return features;
}

Features in_input_order(const OrderedCloud& cloud, std::span<const Vec3> points,
                        const Features& ordered) {
  Features features;
  features.assign_surface(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::uint32_t r = cloud.rank[i];
    if (r == no_point || ordered.kind[r] == PointKind::surface) continue;
    features.kind[i] = ordered.kind[r];
    features.angle[i] = ordered.angle[r];
    features.strength[i] = ordered.strength[r];
    features.crease_point[i] = points[i];
  }
  return features;
}

void warn(const OrderedCloud& cloud, const DetectOptions& options, Detection& result) {
  const auto say = [&](std::string text) { result.warnings.push_back(std::move(text)); };
  if (cloud.non_finite > 0)
    say(std::to_string(cloud.non_finite) +
        " points have a NaN or infinite coordinate; labelled surface");
  if (cloud.duplicates > 0)
    say(std::to_string(cloud.duplicates) +
        " points repeat the place of another; they share its label");
  if (result.k < options.k)
    say("the cloud has only " + std::to_string(cloud.size()) + " different places; k is cut from " +
        std::to_string(options.k) + " to " + std::to_string(result.k));
  if (result.degenerate > 0)
    say(std::to_string(result.degenerate) +
        " places have all their neighbors on one line; labelled surface");
}

class Stopwatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    return std::chrono::duration<double>(now - std::exchange(last_, now)).count();
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace

Detection detect(std::span<const Vec3> points, const DetectOptions& options, const Job& job) {
  check(options);
  Stopwatch watch;
  const OrderedCloud cloud = order_cloud(points, job);
  check(cloud);
  const KdTree tree(cloud);
  const Neighborhoods neighborhoods = find_neighborhoods(tree, std::max(options.k, noise_k), job);

  Detection result;
  result.k = std::min(options.k, neighborhoods.k);
  result.duplicates = cloud.duplicates;
  result.non_finite = cloud.non_finite;
  const Spacing spacing = estimate_spacing(cloud.points, neighborhoods, job);
  result.spacing = spacing.of_cloud;
  result.noise = estimate_noise(cloud.points, neighborhoods, spacing, job);
  result.seconds_index = watch.lap();

  const FeatureTestOptions test = for_noise(result.noise, options);
  result.sigma = test.sigma;
  result.min_cluster = test.min_cluster;
  AdaptOptions adapt;
  adapt.k = result.k;
  adapt.test = test;
  const GaussMapFeatures found =
      options.method == DetectMethod::gauss_map
          ? detect_adaptive(cloud.points, neighborhoods, adapt, job)
          : detect_global(cloud.points, neighborhoods, result.k, test, job);
  result.candidates = found.candidates;
  result.degenerate = found.degenerate;
  result.features =
      in_input_order(cloud, points, in_canonical_order(cloud, neighborhoods, result.k, found));
  warn(cloud, options, result);
  result.seconds_detect = watch.lap();
  return result;
}

}  // namespace spigolo
