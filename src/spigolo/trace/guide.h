// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/guide.h - the rough course of a curve, and the samples that lie along it
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "spigolo/trace/crease_samples.h"
#include "spigolo/trace/junctions.h"

namespace spigolo {

/// A polyline with its arc length: first and last place are the junctions, where there are some.
/// A closed one repeats its first place at the end. Lengths in spacings.
struct Guide {
  std::vector<Vec3> places;
  std::vector<double> arc;
  bool closed = false;

  double length() const { return arc.back(); }
  Vec3 at(double s) const;
  Vec3 direction(double s) const;  // unit
};

/// Sets the arc lengths from the places.
void measure(Guide& guide);

Guide guide_of(const RawCurve& curve, std::span<const Vec3> junctions);

/// A sample of a crease, at its place along the curve.
struct Member {
  double arc = 0;
  std::uint32_t sample = 0;
};

/// The samples that belong to each guide, along it: each to the nearest one within reach that runs
/// its way.
std::vector<std::vector<Member>> assign_members(std::span<const Guide> guides,
                                                std::span<const CreaseSample> samples,
                                                double reach);

/// About one place a spacing along the guide, where robust local fits of the members see the curve;
/// on the guide itself where there are none. window: [spacings] to both sides.
struct Station {
  double arc = 0;
  Vec3 place;
  double angle = 0;  // [rad] median deviation from flat of the members there
};
std::vector<Station> smooth_along(const Guide& guide, std::span<const Member> members,
                                  std::span<const CreaseSample> samples, double window);

}  // namespace spigolo
