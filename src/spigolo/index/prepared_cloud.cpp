// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/index/prepared_cloud.cpp
#include "spigolo/index/prepared_cloud.h"

#include <algorithm>
#include <string>

#include "spigolo/core/error.h"
#include "spigolo/index/noise.h"

namespace spigolo {
namespace {

constexpr std::size_t smallest_k = 8;  // fewer neighbors say nothing (thesis §3.5.1)
constexpr std::size_t noise_k = 16;    // neighbors that the noise estimate looks at

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

}  // namespace

PreparedCloud prepare_cloud(std::span<const Vec3> points, std::size_t k, const Job& job) {
  PreparedCloud prepared;
  prepared.cloud = order_cloud(points, job);
  check(prepared.cloud);
  const std::span<const Vec3> places = prepared.cloud.points;
  const KdTree tree(prepared.cloud);
  prepared.neighborhoods = find_neighborhoods(tree, std::max(k, noise_k), job);
  prepared.spacing = estimate_spacing(places, prepared.neighborhoods, job);
  if (prepared.spacing.of_cloud == 0)
    throw NoResultError("most points crowd in single places: there is no surface");
  prepared.noise = estimate_noise(places, prepared.neighborhoods, prepared.spacing, tree, job);
  return prepared;
}

void widen_neighborhoods(PreparedCloud& prepared, std::size_t k, const Job& job) {
  if (std::min(k, prepared.cloud.size() - 1) > prepared.neighborhoods.k)
    prepared.neighborhoods = find_neighborhoods(KdTree(prepared.cloud), k, job);
}

std::size_t neighbors_at_hand(const PreparedCloud& prepared, std::size_t wanted,
                              std::vector<std::string>& warnings) {
  const std::size_t k = std::min(wanted, prepared.neighborhoods.k);
  if (k < wanted)
    warnings.push_back("the cloud has only " + std::to_string(prepared.cloud.size()) +
                       " different places; k is cut from " + std::to_string(wanted) + " to " +
                       std::to_string(k));
  return k;
}

}  // namespace spigolo
