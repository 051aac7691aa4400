// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mls/sharp_neighborhood.cpp
#include "spigolo/mls/sharp_neighborhood.h"

#include <algorithm>
#include <cmath>

#include "spigolo/core/error.h"

namespace spigolo {
namespace {

// Closer to the line than this share of the spacing, (4.5) compares what is mostly chance.
constexpr double on_line_share = 0.1;

// In noise the normals of one sheet spread as in the feature test of chapter 3.
ConnectOptions connect_options(double noise, std::size_t k) {
  ConnectOptions options;
  options.k = k;
  options.sigma = noise <= 0.03 ? 0.3 : noise <= 0.1 ? 0.5 : 0.7;
  return options;
}

// The feature points of the edge that is nearest to the query: its nearest feature point and those
// of the neighborhood that this one is connected to (§4.3.6).
void gather_line_points(const MlsCloud& cloud, const FeatureMap& features, bool connected,
                        FeatureLineScratch& s) {
  s.line_points.clear();
  s.on_line.assign(s.mls.found.size(), 0);
  std::span<const std::uint32_t> edge;
  std::uint32_t nearest = no_point;
  for (std::size_t i = 0; i < s.mls.found.size(); ++i) {
    const std::uint32_t f = s.mls.found[i].index;
    if (!features.is_feature[f]) continue;
    if (nearest == no_point) nearest = f, edge = features.connected.of(f);
    if (connected && f != nearest && !std::binary_search(edge.begin(), edge.end(), f)) continue;
    s.on_line[i] = 1;
    s.line_points.push_back(cloud.points()[f]);
  }
}

// For a query on the line, which is on no side: the vector of its nearest neighbor off the line.
Vec3 side_vector(const MlsCloud& cloud, const LineFoot& foot, double least,
                 const FeatureLineScratch& s) {
  for (std::size_t i = 0; i < s.mls.found.size(); ++i) {
    const Vec3& x = cloud.points()[s.mls.found[i].index];
    const Vec3 v = foot.nearest(x) - x;
    if (!s.on_line[i] && norm(v) > least) return v;
  }
  return {};
}

// Keeps the neighbors whose way to the line is like `to_line`, the query's, and those the line is
// made of; returns the number of the others.
std::size_t cut(const MlsCloud& cloud, const Vec3& to_line, const LineFoot& foot, double side_angle,
                FeatureLineScratch& s) {
  const double least = std::cos(side_angle) * norm(to_line);
  s.mls.neighbors.clear();
  for (std::size_t i = 0; i < s.mls.found.size(); ++i) {
    const Vec3& x = cloud.points()[s.mls.found[i].index];
    const Vec3 v = foot.nearest(x) - x;
    // (4.5), with the scalar product of unit vectors; a neighbor on the line is on both sides
    if (s.on_line[i] || dot(to_line, v) >= least * norm(v)) s.mls.neighbors.push_back(x);
  }
  return s.mls.found.size() - s.mls.neighbors.size();
}

// §4.3.5: as many samples of the line as neighbors were removed, evenly from end to end.
void refill(const FeatureLine& line, std::size_t count, std::vector<Vec3>& neighbors) {
  for (std::size_t i = 0; i < count; ++i)
    neighbors.push_back(
        point_at(line, (static_cast<double>(i) + 0.5) / static_cast<double>(count)));
}

SurfacePoint in_input_coordinates(const MlsCloud& cloud, SurfacePoint s, const Vec3& query) {
  s.position = on_surface(s.status) ? s.position + cloud.origin() : query;
  return s;
}

}  // namespace

FeatureMap map_features(const MlsCloud& cloud, std::span<const PointKind> kind, std::size_t k,
                        const Job& job) {
  if (kind.size() != cloud.points().size())
    throw UsageError("there are labels for " + std::to_string(kind.size()) + " places, but " +
                     std::to_string(cloud.points().size()) + " places: they are of another cloud");
  FeatureMap map;
  map.is_feature.resize(kind.size());
  for (std::size_t i = 0; i < kind.size(); ++i)
    map.is_feature[i] = kind[i] != PointKind::surface && kind[i] != PointKind::border;
  map.connected =
      connect_features(cloud.tree(), map.is_feature, connect_options(cloud.noise(), k), job);
  return map;
}

std::vector<PointKind> ordered_kinds(const OrderedCloud& cloud,
                                     std::span<const PointKind> kind_of_input) {
  if (kind_of_input.size() != cloud.rank.size())
    throw UsageError("there are labels for " + std::to_string(kind_of_input.size()) +
                     " points, but " + std::to_string(cloud.rank.size()) +
                     " points: the labels are of another cloud");
  std::vector<PointKind> kind(cloud.size(), PointKind::surface);
  for (std::size_t i = 0; i < kind_of_input.size(); ++i)
    if (cloud.rank[i] != no_point) kind[cloud.rank[i]] = kind_of_input[i];
  return kind;
}

std::optional<FeatureLine> local_feature_line(const MlsCloud& cloud, const FeatureMap& features,
                                              const FeatureLineOptions& options,
                                              FeatureLineScratch& scratch) {
  gather_line_points(cloud, features, options.connected, scratch);
  return make_feature_line(scratch.line_points);
}

SurfacePoint project_feature_line(const MlsCloud& cloud, const FeatureMap& features,
                                  const Vec3& query, const FeatureLineOptions& options,
                                  FeatureLineScratch& scratch) {
  const Vec3 p = query - cloud.origin();
  MlsScratch& mls = scratch.mls;
  const Surroundings around = look_around(cloud, p, options.mls, mls);
  if (around.status != SurfaceStatus::sheet) return {query, {}, {}, around.status};
  const double h = options.mls.smoothing * around.spacing;
  const auto line = local_feature_line(cloud, features, options, scratch);
  if (!line) {
    mls.neighbors.clear();
    for (const Neighbor& n : mls.found) mls.neighbors.push_back(cloud.points()[n.index]);
    return in_input_coordinates(cloud, project_levin(p, mls.neighbors, h, mls), query);
  }
  const LineFoot foot(*line);
  const Vec3 nearest = foot.nearest(p);
  const double to_line = distance(p, nearest), least = on_line_share * around.spacing;
  const Vec3 side = to_line <= least ? side_vector(cloud, foot, least, scratch) : nearest - p;
  refill(*line, cut(cloud, side, foot, options.side_angle, scratch), mls.neighbors);
  SurfacePoint result = project_levin(p, mls.neighbors, h, mls);
  // The line is on the surface, too: nothing farther away than it is the nearest place.
  const bool on_line = to_line <= least || distance(p, result.position) > to_line;
  if (on_surface(result.status) && on_line)
    result.position = nearest, result.status = SurfaceStatus::crease;
  return in_input_coordinates(cloud, result, query);
}

}  // namespace spigolo
