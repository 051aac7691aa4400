// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/collar.h - the strip of surface between alpha and beta (thesis §5.4.2.4): C
#pragma once

#include "spigolo/blend/strand.h"
#include "spigolo/cad/spline_rows.h"

namespace spigolo {

/// The cubic from alpha to beta that leaves the face and meets the cloud without a kink.
StripPoles tangent_strip(const Strand& strand);

/// The collar as one surface: v in [0, 1] from alpha to beta, u in [0, 1] along the loop.
struct Collar {
  NurbsSurface surface;
  std::vector<double> station;  // u of each strand
  bool outward = true;          // du x dv points to the free side
};

Collar build_collar(const BorderLoop& loop);

/// Normal of the collar, to the free side.
Vec3 collar_normal(const Collar& collar, double u, double v);

}  // namespace spigolo
