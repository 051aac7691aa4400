// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/cad/nurbs_surface.h - NURBS surfaces as plain data (thesis §2.4, (5.1))
#pragma once

#include "spigolo/cad/nurbs_curve.h"

namespace spigolo {

/// (2.24). Pole (i, j) is poles[i * poles_v + j]. Any number of threads may evaluate one surface.
struct NurbsSurface {
  int degree_u = 3, degree_v = 3;
  std::vector<double> knots_u, knots_v;
  std::size_t poles_u = 0, poles_v = 0;
  std::vector<Vec3> poles;      // poles_u * poles_v
  std::vector<double> weights;  // as many, positive; empty: all 1
  // Where a parameter may run on past its range and comes round; 0: it may not.
  double period_u = 0, period_v = 0;
};

/// Throws Error unless the arrays match, knots ascend, weights are positive and all is finite.
void validate(const NurbsSurface& surface);

struct NurbsPoint {
  Vec3 point, du, dv;  // position and first derivatives
};

/// Parameters outside the range come round where the surface is periodic, else go to the border.
NurbsPoint evaluate(const NurbsSurface& surface, double u, double v);
Vec3 point_at(const NurbsSurface& surface, double u, double v);

/// Unit normal, du x dv. Where the two vanish or agree, as at the tip of a cone or the pole of a
/// sphere, that of a place nearby; zero if there is none there either.
Vec3 normal_at(const NurbsSurface& surface, double u, double v);

}  // namespace spigolo
