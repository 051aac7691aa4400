// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/tubes.h - polylines as round tubes into the depth buffer
#pragma once

#include "spigolo/core/job.h"
#include "spigolo/render/camera.h"
#include "spigolo/render/gbuffer.h"
#include "spigolo/render/scene.h"

namespace spigolo {

/// width: of the tubes [pixel of the buffer]. A tube on a surface stands out of it.
void draw_lines(GBuffer& buffer, const LineLayer& layer, const Camera& camera, double width,
                const Job& job);

}  // namespace spigolo
