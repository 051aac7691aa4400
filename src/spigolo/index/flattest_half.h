// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/index/flattest_half.h - how flat the flatter half of a neighborhood is
#pragma once

#include <array>

#include "spigolo/core/geometry.h"

namespace spigolo {

inline constexpr std::size_t half_of = 16;  // neighbors

/// neighbors: relative to the point. Median of their distances from the plane through the point and
/// two of them that has the smallest one: half of them may lie on other sheets. Infinite if all
/// lie on one line. The same bits on every instruction set.
double flattest_half(const std::array<Vec3, half_of>& neighbors);

}  // namespace spigolo
