// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/crease_samples.h - what detection says of creases, made ready for linking
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "spigolo/core/features.h"
#include "spigolo/core/geometry.h"
#include "spigolo/core/job.h"

namespace spigolo {

/// One place on a crease, as one point of the cloud saw it. Lengths in spacings.
struct CreaseSample {
  Vec3 place;
  Vec3 direction;          // unit, along the crease; sign arbitrary
  double angle = 0;        // [rad] deviation from flat
  double weight = 1;       // strength times how many neighbors agree
  std::int8_t convex = 0;  // as in Features
  bool sure = false;       // seen in a section whose sheets fit far better than strays do
};

/// In a canonical order; positions relative to `origin`, in units of `unit`.
struct CreaseSamples {
  std::vector<CreaseSample> edges, borders;
  std::vector<Vec3> corners;        // where single points saw three sheets meet
  std::vector<CreaseSample> marks;  // edges and corners as they were marked, all of them
  Vec3 origin;                      // [input units]
  double unit = 1;                  // [input units] one spacing

  Vec3 inside(const Vec3& p) const { return (p - origin) / unit; }
  Vec3 outside(const Vec3& p) const { return p * unit + origin; }
};

/// Gathers edges, corners and borders; gives a direction to those without one (from the samples
/// round them), and drops those that few others agree with. scatter: [spacings] how far samples lie
/// off their crease; above a few hundredths they are moved onto the crease their neighbors make.
CreaseSamples gather_samples(std::span<const Vec3> points, const Features& features, double spacing,
                             double scatter, const Job& job = {});

}  // namespace spigolo
