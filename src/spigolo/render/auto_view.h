// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/auto_view.h - the direction a scene is best seen from
#pragma once

#include "spigolo/render/scene.h"
#include "spigolo/render/view.h"

namespace spigolo {

/// The three-quarter direction (of 24 round the z axis) from which the most surface and the most
/// features are in sight, as far as a coarse picture of some thousand samples tells; from above if
/// that is about as good. Depends on the scene only.
Vec3 best_direction(const Scene& scene, const View& view);

}  // namespace spigolo
