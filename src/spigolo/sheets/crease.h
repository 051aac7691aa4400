// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/crease.h - where two sheets cross, and where three meet
#pragma once

#include <array>
#include <optional>
#include <span>

#include "spigolo/sheets/sheet.h"

namespace spigolo {

/// The point of two sheets' crossing curve that is nearest to a query.
struct Crease {
  Vec3 point;
  Vec3 direction;              // unit, along the curve; sign arbitrary
  std::array<Vec3, 2> normal;  // unit, of the two sheets there; signs arbitrary
};

/// Newton's method on both heights, kept at the query's place along the curve. Nothing if the
/// sheets are within about six degrees of parallel there, or the crossing is farther than three
/// spacings.
std::optional<Crease> find_crease(const Sheet& a, const Sheet& b, const Vec3& query);

/// Where three sheets meet near the query; nothing if that is farther than three spacings or their
/// normals are close to one plane.
std::optional<Vec3> find_corner(const std::array<const Sheet*, 3>& sheets, const Vec3& query);

}  // namespace spigolo
