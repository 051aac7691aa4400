// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/index/order.h - the points of a cloud in one canonical order
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "spigolo/core/geometry.h"
#include "spigolo/core/job.h"

namespace spigolo {

inline constexpr std::uint32_t no_point = 0xffffffffu;

/// A cloud made ready for searching: its distinct finite points, shifted to their own origin, along
/// a space-filling (Morton) curve through their bounding cube; points of one cell by their
/// coordinates. The order depends on the set of points alone, never on the order of the input.
struct OrderedCloud {
  std::vector<Vec3> points;          // relative to origin
  std::vector<std::uint64_t> codes;  // position on the curve, ascending; 21 bits an axis
  std::vector<std::uint32_t> rank;   // per input point: its place in points; no_point if not finite
  Vec3 origin;                       // center of the bounding box, in input coordinates
  std::size_t duplicates = 0;        // input points that repeat an earlier place
  std::size_t non_finite = 0;        // input points with a NaN or infinite coordinate

  std::size_t size() const { return points.size(); }
};

/// Throws UsageError for more than 2^32 - 2 points, NoResultError for a cloud so small or large
/// (not 1e-70 to 1e70 across) that powers of its lengths are no numbers.
OrderedCloud order_cloud(std::span<const Vec3> points, const Job& job = {});

/// Throws Error unless codes ascend, points are finite and distinct, and every rank exists.
void validate(const OrderedCloud& cloud);

}  // namespace spigolo
