// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/local_sheets.h - the sheets near one place, and which part of each is surface
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "spigolo/sheets/crease.h"
#include "spigolo/sheets/sheet.h"

namespace spigolo {

/// Up to six sheets. Each one ends where it crosses others; which side of them is surface is told
/// by its own data, so that no sheet needs an orientation, and convex, concave and saddle corners
/// are alike.
struct LocalSheets {
  static constexpr std::size_t most = 6;
  std::array<Sheet, most> sheet;
  std::size_t count = 0;
  double tolerance = 0;  // [spacings] so close to another sheet a place is on both of its sides

  /// Bit c of a place's sides tells whether it is above sheet c (height > 0). data_sides[s] has bit
  /// b set if data of sheet s lie where the sides (without bit s) are b.
  std::array<std::uint64_t, most> data_sides{};
  /// Of the data of sheet s: the share above sheet c, of those clearly on one of its sides.
  std::array<std::array<float, most>, most> share_above{};

  /// Whether x, a place on sheet s, is where the data of s are; sheets named in `free` (a bit each)
  /// do not count.
  bool is_surface(std::size_t s, const Vec3& x, std::uint32_t free = 0) const;
  /// The same for a place above the sheets of `above` and too close to those of `open` to say.
  bool has_data(std::size_t s, std::uint32_t above, std::uint32_t open) const;
};

enum class FootKind : std::uint8_t { sheet = 0, crease = 1, corner = 2, none = 3 };

/// The place of the surface nearest to a query.
struct Foot {
  FootKind kind = FootKind::none;
  Vec3 position;
  std::array<std::uint8_t, 3> sheets{};  // the one, two or three it lies on
};

/// Orthogonal foot on one sheet, extended as far as need be. Nothing beyond four spacings from the
/// sheet's origin, or where the iteration does not settle (inside the evolute).
std::optional<Vec3> find_foot(const Sheet& sheet, const Vec3& query);

/// The nearest of: feet on the parts of the sheets that are surface, creases between them, corners.
/// If none is valid, the nearest foot on any sheet.
Foot find_nearest_foot(const LocalSheets& sheets, const Vec3& query);

/// The nearest foot on any of the sheets, wherever their data are.
Foot find_nearest_sheet(const LocalSheets& sheets, const Vec3& query);

/// A place on a crease of the surface.
struct CreasePlace {
  Crease crease;                       // point, direction, normals of the two sheets
  std::array<std::uint8_t, 2> sheets;  // which two
  std::array<Vec3, 2> into;            // unit, square to the direction: from the crease into each
  double deviation = 0;                // [rad] from flat, 0 to pi
  std::optional<Vec3> corner;          // common point with a third sheet that ends it, if near
};

/// The nearest place of any crease between two sheets that both end there.
std::optional<CreasePlace> find_nearest_crease(const LocalSheets& sheets, const Vec3& query);

}  // namespace spigolo
