// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/collar.cpp
#include "spigolo/blend/collar.h"

namespace spigolo {

StripPoles tangent_strip(const Strand& s) {
  return {s.alpha, s.alpha + s.alpha_handle, s.beta + s.beta_handle, s.beta};
}

Collar build_collar(const BorderLoop& loop) {
  std::vector<StripPoles> strips;
  for (const Strand& s : loop.strands) strips.push_back(tangent_strip(s));
  Collar collar;
  collar.surface = surface_through(strips, loop.closed, &collar.station);
  double agreement = 0;
  for (std::size_t i = 0; i < strips.size(); ++i) {
    const NurbsPoint p = evaluate(collar.surface, collar.station[i], 0);
    const Vec3 out = loop.strands[i].alpha_normal * loop.side;
    agreement += dot(normalized(cross(p.du, p.dv)), out);
  }
  collar.outward = agreement > 0;
  return collar;
}

Vec3 collar_normal(const Collar& collar, double u, double v) {
  const Vec3 n = normal_at(collar.surface, u, v);
  return collar.outward ? n : -n;
}

}  // namespace spigolo
