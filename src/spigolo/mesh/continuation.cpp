// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/continuation.cpp
#include "spigolo/mesh/continuation.h"

#include <algorithm>

#include "spigolo/mesh/edges.h"

namespace spigolo {
namespace {

constexpr double reach = 2;             // [spacings] to the points that are asked
constexpr double alike = 0.6;           // cosine between the normals of one surface
constexpr double nearest_of_all = 0.1;  // [squared spacings] keeps the weights finite

}  // namespace

std::array<Continuation::Witness, Continuation::most> Continuation::find_witnesses(
    const Vec3& place, const Vec3& normal) const {
  std::array<Witness, most> nearest;
  nearest.fill({infinity, no_index});
  cloud_.any_within(place, reach * surface_.spacing, [&](std::uint32_t j, double squared) {
    const SurfaceFoot& foot = surface_.points[j];
    if (!foot.valid() || std::abs(dot(foot.normal, normal)) < alike) return false;
    Witness entry{squared, j};
    for (Witness& rank : nearest)
      if (entry < rank) std::swap(entry, rank);
    return false;
  });
  return nearest;
}

double Continuation::weight_of(const Witness& witness) const {
  return 1 / (witness.first + nearest_of_all * surface_.spacing * surface_.spacing);
}

SurfaceFoot Continuation::at(const Vec3& place, const Vec3& normal) const {
  const auto nearest = find_witnesses(place, normal);
  const auto last = std::find_if(nearest.begin(), nearest.end(),
                                 [](const Witness& w) { return w.second == no_index; });
  if (last - nearest.begin() < 2) return {};
  const std::span<const Witness> found(nearest.begin(), last);
  const SurfaceFoot foot =
      surface_.continued ? by_sheets(found, place, normal) : by_arcs(found, place, normal);
  return foot.valid() && distance(foot.position, place) > farthest_ ? SurfaceFoot{} : foot;
}

SurfaceFoot Continuation::by_sheets(std::span<const Witness> nearest, const Vec3& place,
                                    const Vec3& normal) const {
  std::array<SurfaceFoot, most> feet;
  SurfaceFoot mean;
  double weight = 0;
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    feet[i] = surface_.continued(nearest[i].second, place);
    if (!feet[i].valid()) return {};
    const double w = weight_of(nearest[i]);
    mean.position += w * feet[i].position;
    mean.normal += (dot(feet[i].normal, normal) < 0 ? -w : w) * feet[i].normal;
    mean.curvature += w * feet[i].curvature;
    weight += w;
  }
  mean = {mean.position / weight, normalized(mean.normal), mean.curvature / weight};
  for (std::size_t i = 0; i < nearest.size(); ++i)
    if (distance(feet[i].position, mean.position) > surface_.disagreement) return {};
  return mean;
}

// From each surface point an arc that leaves it along its sheet and comes in along the mean of
// them.
SurfaceFoot Continuation::by_arcs(std::span<const Witness> nearest, const Vec3& place,
                                  const Vec3& normal) const {
  SurfaceFoot mean;
  double weight = 0, height = 0;
  for (const Witness& witness : nearest) {
    const SurfaceFoot& foot = surface_.points[witness.second];
    const double w = weight_of(witness);
    mean.normal += (dot(foot.normal, normal) < 0 ? -w : w) * foot.normal;
    mean.curvature += w * foot.curvature;
    weight += w;
  }
  mean.normal = normalized(mean.normal);
  mean.curvature /= weight;
  for (const Witness& witness : nearest)
    height += weight_of(witness) / weight * arc_height(witness, place, mean.normal);
  for (const Witness& witness : nearest)
    if (std::abs(arc_height(witness, place, mean.normal) - height) > surface_.disagreement)
      return {};
  mean.position = place + height * mean.normal;
  return mean;
}

// Over a place, along the normal there, of an arc from a surface point: its chord is square to the
// mean of both normals.
double Continuation::arc_height(const Witness& from, const Vec3& place, const Vec3& normal) const {
  const SurfaceFoot& foot = surface_.points[from.second];
  const Vec3 own = dot(foot.normal, normal) < 0 ? -foot.normal : foot.normal;
  return dot(foot.position - place, own + normal) / (1 + dot(own, normal));
}

}  // namespace spigolo
