// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/cad/nurbs_face.h - a face: the part of a NURBS surface that its trimming curves leave
#pragma once

#include <cstdint>
#include <vector>

#include "spigolo/cad/nurbs_surface.h"

namespace spigolo {

struct Interval {
  double begin = 0, end = 0;

  double length() const { return end - begin; }
  double at(double share) const { return begin + (end - begin) * share; }
};

struct ParamPoint {
  double u = 0, v = 0;
};

/// Part of a trimming curve in the parameter plane. Only all of a face's together are closed loops.
using TrimCurve = std::vector<ParamPoint>;

enum class Parameter : std::uint8_t { u, v };

struct NurbsFace {
  NurbsSurface surface;
  Interval u, v;  // of the face; on a periodic surface it may run past the seam
  bool closed_u = false, closed_v = false;  // it comes back to where it began
  bool reversed = false;                    // its outside is against du x dv
  std::vector<TrimCurve> trims;             // empty: the whole rectangle u x v
};

/// Throws Error unless the surface is valid and the ranges are not empty.
void validate(const NurbsFace& face);

/// Outside normal of the face.
Vec3 outward_normal(const NurbsFace& face, double u, double v);

/// Which parts of the isoline `fixed` = value lie on the face, ascending in the other parameter.
/// At the two ends of the range of `fixed`: those right inside.
std::vector<Interval> inside(const NurbsFace& face, Parameter fixed, double value);

/// Sets closed_u and closed_v from the surface: the face spans it all round, and its two borders
/// agree within a millionth of its size.
void find_seams(NurbsFace& face);

}  // namespace spigolo
