// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/gauss_map/gauss_map.cpp - spread of the normals around their principal direction
#include "spigolo/gauss_map/gauss_map.h"

#include <algorithm>
#include <cmath>

#include "spigolo/core/symmetric3.h"

namespace spigolo {
NormalSpread normal_spread(const GaussMap& map) {
  if (map.size == 0) return {{0, 0, 1}, 0};
  Symmetric3 m;
  for (std::size_t t = 0; t < map.size; ++t) m.add(map.normal(t));
  const PrincipalAxis principal = largest_axis(m);
  // The eigenvalue sums the squared cosines, what is missing are the squared sines.
  const double squared_sine = 1 - principal.value / (m.xx + m.yy + m.zz);
  return {principal.axis, std::asin(std::sqrt(std::clamp(squared_sine, 0.0, 1.0)))};
}

}  // namespace spigolo
