// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/catalogue.h - the makers of all shapes (inside synth only)
#pragma once

#include <functional>
#include <vector>

#include "spigolo/synth/synth.h"

namespace spigolo {

/// A shape and how it is sampled by default.
struct Construction {
  Shape shape;
  std::function<std::vector<Vec3>()> lattice;  // empty if it has none
  std::size_t points = 10000;  // of a sampling off the lattice, if none were asked for
};

/// The shape that options.shape names; throws UsageError if there is none.
Construction construct(const SynthOptions& options);

// thesis_shapes.cpp
Construction make_cube(const SynthOptions& options);
Construction make_planes(const SynthOptions& options);
Construction make_hole(const SynthOptions& options);
Construction make_hole17k(const SynthOptions& options);
Construction make_wedge(const SynthOptions& options);

// flat_shapes.cpp
Construction make_box(const SynthOptions& options);
Construction make_plate(const SynthOptions& options);
Construction make_slot(const SynthOptions& options);
Construction make_fillet_box(const SynthOptions& options);
Construction make_chamfer_box(const SynthOptions& options);
Construction make_l_prism(const SynthOptions& options);
Construction make_steps(const SynthOptions& options);
Construction make_star(const SynthOptions& options);
Construction make_pyramid(const SynthOptions& options);
Construction make_fade(const SynthOptions& options);

// round_shapes.cpp
Construction make_boxhole(const SynthOptions& options);
Construction make_cylinder(const SynthOptions& options);
Construction make_cylinder_hole(const SynthOptions& options);
Construction make_cylinders(const SynthOptions& options);
Construction make_cone(const SynthOptions& options);
Construction make_spike(const SynthOptions& options);
Construction make_sphere(const SynthOptions& options);
Construction make_torus(const SynthOptions& options);
Construction make_cap(const SynthOptions& options);
Construction make_lens(const SynthOptions& options);
Construction make_patch(const SynthOptions& options);
Construction make_dome(const SynthOptions& options);

/// Throws UsageError unless options.angle lies in [5, 175] degrees.
void check_angle(const SynthOptions& options);

/// The smallest n in [first, last] whose count(n), growing with n, comes nearest to `wanted`;
/// `usual` if nothing is wanted (0).
std::size_t nearest_count(std::size_t wanted, std::size_t usual,
                          const std::function<std::size_t(std::size_t n)>& count);

}  // namespace spigolo
