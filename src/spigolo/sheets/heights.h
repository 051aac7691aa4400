// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/heights.h - how far many points are from one sheet
#pragma once

#include <span>

#include "spigolo/sheets/sheet.h"

namespace spigolo {

/// out[i] = height(sheet, points[i]), to the last bit, several points at once.
void heights(const Sheet& sheet, std::span<const Vec3> points, double* out);

/// How near a point must lie to a sheet to be explained by it, in spacings: `limit`, and
/// growth * d^2 more at a distance d beyond `known` from the sheet's origin.
struct SheetTrust {
  double limit, growth, known;
  double spacing;  // in the units of the points
};

/// out[i]: 1 where the sheet passes points[i], down to 0 where it passes it by: max(0, 1 - q^2), q
/// the height by what is allowed. The same bits on every instruction set.
void explained(const Sheet& sheet, std::span<const Vec3> points, const SheetTrust& trust,
               double* out);

}  // namespace spigolo
