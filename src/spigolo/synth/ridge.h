// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/ridge.h - two ruled sheets along a straight edge whose angle changes
#pragma once

#include <string>

#include "spigolo/synth/shape.h"

namespace spigolo {

/// The edge runs along x from the origin; both sheets go up from it, left and right of z.
struct Ridge {
  double length = 1, width = 1;         // of the edge, of each sheet
  double from = half_pi, to = half_pi;  // [rad] interior angle at its two ends, up to pi
};

/// Unit direction in which sheet `side` (-1 or 1) leaves the edge at the share u of its length.
Vec3 ridge_direction(const Ridge& ridge, double u, int side);

/// The angle changes linearly. Where it reaches pi the edge fades out.
Shape ridge_shape(const std::string& name, const Ridge& ridge);

}  // namespace spigolo
