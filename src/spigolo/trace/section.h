// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/section.h - the two sheets beside one place of a crease, and where they cross
#pragma once

#include <optional>
#include <span>

#include "spigolo/core/geometry.h"

namespace spigolo {

/// A crease near `place` that runs about along `direction`. Lengths in spacings.
struct SectionQuery {
  Vec3 place, direction;  // direction unit
  Vec3 bend;              // [1 / spacing] second derivative along the crease, across direction
  double angle = 0;       // [rad] deviation from flat it is known to have, within 25 degrees
  double noise = 0;
  double behind = 3, ahead = 3;  // how far along the crease points may be looked at
};

struct SectionFit {
  Vec3 place;        // on both sheets, in the plane through the query's place across its direction
  Vec3 direction;    // unit, along both sheets, the query's way
  double angle = 0;  // [rad] deviation from flat
  double rms = 0;    // of the points on the worse fitted side
  std::size_t support = 0;  // points on the side that has fewer
};

/// How far across the crease the sheets are looked at.
double section_radius(double noise);

/// Takes the half planes beside the crease that most points lie on, fits a plane or quadric to the
/// points of each that are farther from the crease than noise can carry them over it, and crosses
/// the two. Nothing if a side has too few points, stays away from the crease or goes on beyond it.
/// points: all within section_radius across and the query's reach along; others do no harm.
std::optional<SectionFit> fit_section(std::span<const Vec3> points, const SectionQuery& query);

}  // namespace spigolo
