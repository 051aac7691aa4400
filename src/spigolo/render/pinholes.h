// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/pinholes.h - gaps between the discs of a surface
#pragma once

#include <span>
#include <vector>

#include "spigolo/render/camera.h"
#include "spigolo/render/splats.h"

namespace spigolo {

/// The median radius [pixel] of the drawn splats, found from a sample; 0 if there are none.
float typical_radius(std::span<const Splat> splats);

/// A pixel that something nearer surrounds on all eight sides within `radius` pixels is a gap
/// between discs: it gets the farthest of those depths. True holes are wider and stay.
void close_pinholes(std::vector<float>& front, const TileGrid& grid, float radius,
                    const Camera& camera, const Job& job);

}  // namespace spigolo
