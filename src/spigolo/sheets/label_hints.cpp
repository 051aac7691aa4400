// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/label_hints.cpp
#include "spigolo/sheets/label_hints.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "spigolo/sheets/crease.h"

namespace spigolo {
namespace {

constexpr double enough_noise = 0.3;        // [spacings]
constexpr double least_strength = 0.3;      // of a label whose planes are tried
constexpr double strength_per_step = 0.1;   // a label one spacing farther must be so much surer
constexpr double alike_cosine = 0.85;       // of normals: the same plane if it also passes near,
constexpr double look = 3, alike_away = 2;  // [spacings] so far from the crease, so near
constexpr double side_noise = 0.3;          // [standard deviations] as the separator starts
constexpr double same_way = 0.8;            // cosine of a label's direction and a crossing
constexpr double pin_reach = 1.5;           // [spacings] of a label from its crossing
constexpr double surest = 0.1;  // [spacings] standard deviation of a label of strength 1
// Labels near each other err together, so an unsure one counts as little as one of many.
constexpr double unsure_share = 40;

bool is_usable(const SheetVerdict& label) {
  return label.kind == PointKind::edge && squared_norm(label.direction) > 0;
}

Sheet plane_of(const SheetVerdict& label, const Vec3& into, double spacing, double noise) {
  Sheet plane;
  plane.origin = label.crease_point;
  plane.u = label.direction;
  plane.n = normalized(cross(plane.u, into));
  plane.v = cross(plane.n, plane.u);
  plane.spacing = spacing;
  plane.deviation = noise;
  plane.support = 1;
  return plane;
}

void add_if_new(const Sheet& plane, const Vec3& inside, LocalSheets& sheets) {
  for (std::size_t s = 0; s < sheets.count; ++s)
    if (std::abs(dot(sheets.sheet[s].n, plane.n)) > alike_cosine &&
        std::abs(height(sheets.sheet[s], inside)) < alike_away)
      return;
  if (sheets.count < LocalSheets::most) sheets.sheet[sheets.count++] = plane;
}

// The sheets whose crossing is nearest to the label's place.
std::optional<CreasePin> pin_of(const SheetVerdict& label, const LocalSheets& sheets,
                                double spacing) {
  CreasePin pin{label.crease_point, {}, 0};
  double best = pin_reach * spacing;
  for (std::size_t a = 0; a < sheets.count; ++a) {
    for (std::size_t b = a + 1; b < sheets.count; ++b) {
      const auto crease = find_crease(sheets.sheet[a], sheets.sheet[b], pin.place);
      if (!crease || std::abs(dot(crease->direction, label.direction)) < same_way) continue;
      const double off = distance(crease->point, pin.place);
      if (off < best) best = off, pin.sheets = {a, b};
    }
  }
  if (pin.sheets[0] == pin.sheets[1]) return std::nullopt;
  return pin;
}

}  // namespace

bool labels_help(double noise) { return noise > enough_noise; }

LocalSheets sheets_of_labels(const SheetModel& model, const SheetRegion& region) {
  std::vector<std::pair<double, std::uint32_t>> order;
  for (const Neighbor& n : region.found) {
    const SheetVerdict& label = model.verdicts[n.index];
    if (!is_usable(label) || label.strength < least_strength) continue;
    const double steps = std::sqrt(n.squared_distance) / region.spacing;
    order.emplace_back(strength_per_step * steps - label.strength, n.index);
  }
  std::sort(order.begin(), order.end());
  const double noise = model.tolerances.noise;
  LocalSheets sheets;
  sheets.tolerance = side_noise * noise;
  sheets.data_sides.fill(~std::uint64_t{0});
  for (const auto& [_, i] : order) {
    const SheetVerdict& label = model.verdicts[i];
    for (const Vec3& into : label.into)
      if (squared_norm(cross(label.direction, into)) > 0.5)  // zero: not known
        add_if_new(plane_of(label, into, region.spacing, noise),
                   label.crease_point + into * (look * region.spacing), sheets);
  }
  return sheets;
}

std::vector<CreasePin> pin_creases(const SheetModel& model, const SheetRegion& region,
                                   double noise) {
  std::vector<CreasePin> pins;
  if (!model.labels_given || !labels_help(noise) || region.sheets.count < 2) return pins;
  for (const Neighbor& n : region.found) {
    const SheetVerdict& label = model.verdicts[n.index];
    if (!is_usable(label)) continue;
    std::optional<CreasePin> pin = pin_of(label, region.sheets, region.spacing);
    if (!pin) continue;
    const double unsure = unsure_share * (1 - label.strength);
    pin->weight = noise * noise / (surest * surest + unsure * noise * noise);
    pins.push_back(*pin);
  }
  return pins;
}

}  // namespace spigolo
