// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/triangles.h - filled triangles into the depth buffer
#pragma once

#include "spigolo/core/job.h"
#include "spigolo/render/camera.h"
#include "spigolo/render/gbuffer.h"
#include "spigolo/render/scene.h"

namespace spigolo {

/// Both sides are drawn and lit. line_width: of the wireframe [pixel of the buffer].
void draw_mesh(GBuffer& buffer, const MeshLayer& mesh, const Camera& camera, double line_width,
               const Job& job);

}  // namespace spigolo
