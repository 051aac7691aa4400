// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/core/symmetric3.h - symmetric 3 x 3 matrices and their principal directions
#pragma once

#include "spigolo/core/geometry.h"

namespace spigolo {

/// Also the scatter matrix of directions or points: sums of products of coordinates.
struct Symmetric3 {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

  /// Adds the outer product of v with itself.
  constexpr void add(const Vec3& v) {
    xx += v.x * v.x, xy += v.x * v.y, xz += v.x * v.z;
    yy += v.y * v.y, yz += v.y * v.z, zz += v.z * v.z;
  }
};

/// An eigenvalue with its unit eigenvector, sign arbitrary; of a multiple eigenvalue any one.
struct PrincipalAxis {
  Vec3 axis;
  double value = 0;
};

PrincipalAxis largest_axis(const Symmetric3& m);
PrincipalAxis smallest_axis(const Symmetric3& m);

}  // namespace spigolo
