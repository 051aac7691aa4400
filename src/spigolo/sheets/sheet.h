// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/sheet.h - one smooth piece of the surface, as it is near one place
#pragma once

#include <array>
#include <span>

#include "spigolo/core/geometry.h"

namespace spigolo {

/// A quadric height field over a plane: w = a0 + a1 u + a2 v + a3 uu + a4 uv + a5 vv, where u, v, w
/// are the coordinates of a point in the frame, in units of `spacing`. The sign of n is arbitrary.
struct Sheet {
  Vec3 origin;
  Vec3 u, v, n;        // right-handed orthonormal frame
  double spacing = 1;  // in the units of the points
  std::array<double, 6> a{};
  double deviation = infinity;  // [spacings] rms residual, corrected for the coefficients fitted
  int support = 0;              // points it was fitted to; 0: there is no sheet
  bool whole = false;           // of an own sheet: all the neighbors lie on it

  bool fitted() const { return support > 0; }
  bool is_curved() const { return a[3] != 0 || a[4] != 0 || a[5] != 0; }
};

/// Signed distance of p to the sheet, to first order, in spacings.
double height(const Sheet& sheet, const Vec3& p);

/// Unit normal of the sheet below p.
Vec3 normal_at(const Sheet& sheet, const Vec3& p);

/// Both principal curvatures below p, the larger one first, positive where the sheet bends towards
/// its normal: eigenvalues of the shape operator (do Carmo 1976, §3.3). In 1 / unit of the points.
std::array<double, 2> curvatures_at(const Sheet& sheet, const Vec3& p);

inline constexpr int quadric_points = 9;  // with fewer, six coefficients say nothing

enum class SheetOrder { plane, quadric };

/// Least squares through the points with `use` set (all points if `use` is empty), in a frame at
/// points[0]. A quadric needs quadric_points, a plane three: with fewer, a plane, then no sheet.
Sheet fit_sheet(std::span<const Vec3> points, std::span<const char> use, double spacing,
                SheetOrder order);

/// Least squares with a weight a point (none negative), over the plane through `origin` with the
/// unit normal `normal`. `ridge` draws curvature to zero, as a share of the total weight. Fewer
/// than quadric_points of weight: a plane; fewer than three or all on a line: no sheet. deviation
/// is the weighted rms residual [spacings].
Sheet fit_weighted_sheet(std::span<const Vec3> points, std::span<const double> weights,
                         const Vec3& origin, const Vec3& normal, double spacing, double ridge,
                         double plane_gain = 0);

}  // namespace spigolo
