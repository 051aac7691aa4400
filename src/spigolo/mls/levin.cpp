// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mls/levin.cpp - plane (4.2), weight (4.3), polynomial (4.4)
#include "spigolo/mls/levin.h"

#include <algorithm>
#include <cmath>

#include "spigolo/core/error.h"
#include "spigolo/core/symmetric3.h"
#include "spigolo/mls/quadratic.h"

namespace spigolo {
namespace {

constexpr std::size_t plane_points = 3;
constexpr int most_steps = 30;       // of the search for q; three to eight are usual
constexpr double settled_at = 1e-7;  // [h] q moves less: it has been found
// The h-th part of the weights: so many neighbors keep so much of the largest weight.
constexpr std::size_t weighty_points = 9;
const double weighty_log = std::log(1e4);
// A neighborhood thinner than this share of its length is a line.
constexpr double line_share = 1e-10;

constexpr std::size_t least_k = 9, usual_k = 20;
constexpr double h_without_noise = 1, h_per_noise = 8, largest_h = 5;
constexpr double usual_reach = 6, reach_per_h = 3;

bool in_range(double x, double low, double high) { return x >= low && x <= high; }

struct Plane {
  Vec3 q, n;
  bool found = false;
};

// The smallest h^2 that leaves enough neighbors with some weight.
double least_squared_h(const Vec3& p, std::span<const Vec3> neighbors, MlsScratch& scratch) {
  std::vector<double>& d = scratch.distance;
  d.resize(neighbors.size());
  for (std::size_t i = 0; i < d.size(); ++i) d[i] = squared_distance(neighbors[i], p);
  const std::size_t rank = std::min(weighty_points, d.size()) - 1;
  std::nth_element(d.begin(), d.begin() + static_cast<std::ptrdiff_t>(rank), d.end());
  const double last = d[rank];
  const auto first = std::min_element(d.begin(), d.begin() + static_cast<std::ptrdiff_t>(rank) + 1);
  return (last - *first) / weighty_log;
}

// (4.3), all divided by the largest.
void weigh(const Vec3& q, std::span<const Vec3> neighbors, double squared_h, MlsScratch& scratch) {
  std::vector<double>&w = scratch.weight, &d = scratch.distance;
  w.resize(neighbors.size()), d.resize(neighbors.size());
  for (std::size_t i = 0; i < d.size(); ++i) d[i] = squared_distance(neighbors[i], q);
  const double nearest = *std::min_element(d.begin(), d.end());
  for (std::size_t i = 0; i < d.size(); ++i) w[i] = std::exp((nearest - d[i]) / squared_h);
}

// The plane that minimizes (4.2) for these weights, and the foot of p on it.
Plane weighted_plane(const Vec3& p, std::span<const Vec3> neighbors,
                     const std::vector<double>& weight) {
  Vec3 mean;
  double sum = 0;
  for (std::size_t i = 0; i < neighbors.size(); ++i)
    mean += (neighbors[i] - p) * weight[i], sum += weight[i];
  mean = p + mean / sum;
  Symmetric3 scatter;
  for (std::size_t i = 0; i < neighbors.size(); ++i)
    scatter.add((neighbors[i] - mean) * std::sqrt(weight[i]));
  const PrincipalAxis thin = smallest_axis(scatter), longest = largest_axis(scatter);
  const double middle = scatter.xx + scatter.yy + scatter.zz - thin.value - longest.value;
  if (!(middle > line_share * longest.value)) return {};
  return {p - thin.axis * dot(p - mean, thin.axis), thin.axis, true};
}

Plane reference_plane(const Vec3& p, std::span<const Vec3> neighbors, double squared_h,
                      MlsScratch& scratch) {
  Plane plane{p, {}, false};
  for (int step = 0; step < most_steps; ++step) {
    weigh(plane.q, neighbors, squared_h, scratch);
    const Plane next = weighted_plane(p, neighbors, scratch.weight);
    if (!next.found) return next;
    const double moved = squared_distance(next.q, plane.q);
    plane = next;
    if (moved <= settled_at * settled_at * squared_h) break;
  }
  return plane;
}

}  // namespace

MlsOptions settle(const MlsOptions& options, double noise) {
  MlsOptions o = options;
  if (o.smoothing == 0) o.smoothing = std::min(h_without_noise + h_per_noise * noise, largest_h);
  if (!in_range(o.smoothing, 0.01, 100))
    throw UsageError("smoothing must be between 0.01 and 100 spacings");
  // exp(-3) = 0.05 at r = sqrt(3) h, which holds pi r^2 = 9.4 h^2 samples.
  if (o.k == 0) o.k = std::max(usual_k, static_cast<std::size_t>(9.4 * o.smoothing * o.smoothing));
  if (o.k < least_k || o.k > 100000)
    throw UsageError("k must be between 9 and 100000 neighbors for the projection");
  if (o.reach == 0) o.reach = std::max(usual_reach, reach_per_h * o.smoothing);
  if (!(o.reach > 0)) throw UsageError("reach must be above 0 spacings");
  return o;
}

SurfacePoint project_levin(const Vec3& p, std::span<const Vec3> neighbors, double h,
                           MlsScratch& scratch) {
  SurfacePoint result{p, {}, {}, SurfaceStatus::too_few};
  if (neighbors.size() < plane_points) return result;
  result.status = SurfaceStatus::degenerate;
  const double squared_h = std::max(h * h, least_squared_h(p, neighbors, scratch));
  if (!(squared_h > 0)) return result;
  const Plane plane = reference_plane(p, neighbors, squared_h, scratch);
  if (!plane.found) return result;
  weigh(plane.q, neighbors, squared_h, scratch);
  const TangentFrame frame = tangent_frame(plane.q, plane.n, std::sqrt(squared_h));
  const Quadratic g = fit_quadratic(frame, neighbors, scratch.weight);  // (4.4)
  result.position = plane.q + plane.n * (g.a[0] * frame.unit);
  result.normal = normal_of(g, frame);
  result.curvature = curvatures_of(g, frame);
  result.status = SurfaceStatus::sheet;
  return result;
}

Surroundings look_around(const MlsCloud& cloud, const Vec3& query, const MlsOptions& options,
                         MlsScratch& scratch) {
  if (!is_finite(query)) return {SurfaceStatus::degenerate, 0};
  cloud.tree().nearest(query, options.k, scratch.found);
  if (scratch.found.size() < plane_points) return {SurfaceStatus::too_few, 0};
  const double spacing = cloud.spacing_at(scratch.found);
  const double reach = options.reach * spacing;
  if (!(scratch.found.front().squared_distance <= reach * reach))
    return {SurfaceStatus::too_far, spacing};
  return {SurfaceStatus::sheet, spacing};
}

SurfacePoint project_plain(const MlsCloud& cloud, const Vec3& query, const MlsOptions& options,
                           MlsScratch& scratch) {
  const Vec3 p = query - cloud.origin();
  const Surroundings around = look_around(cloud, p, options, scratch);
  if (around.status != SurfaceStatus::sheet) return {query, {}, {}, around.status};
  scratch.neighbors.clear();
  for (const Neighbor& n : scratch.found) scratch.neighbors.push_back(cloud.points()[n.index]);
  SurfacePoint result =
      project_levin(p, scratch.neighbors, options.smoothing * around.spacing, scratch);
  result.position = on_surface(result.status) ? result.position + cloud.origin() : query;
  return result;
}

}  // namespace spigolo
