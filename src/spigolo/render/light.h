// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/light.h - from depths, normals and colours to a lit picture
#pragma once

#include "spigolo/core/job.h"
#include "spigolo/render/camera.h"
#include "spigolo/render/gbuffer.h"
#include "spigolo/render/image.h"

namespace spigolo {

/// Gives every surface pixel without a normal the one its surrounding depths tell. Creases stay
/// sharp: each difference is taken on the side that continues straight.
void find_normals(GBuffer& buffer, const Camera& camera, const Job& job);

/// Lights the buffer and averages blocks of samples x samples pixels into `image`, over what is
/// there; where nothing is seen the image shows through. image: buffer size / samples.
void light(Image& image, const GBuffer& buffer, const Camera& camera, int samples, const Job& job);

}  // namespace spigolo
