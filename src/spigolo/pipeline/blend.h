// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/pipeline/blend.h - a scan and a CAD face made one cloud, sharp where it is sharp
#pragma once

#include "spigolo/blend/blend.h"
#include "spigolo/core/features.h"

namespace spigolo {

struct SharpBlend {
  Blend blend;        // the samples of the cloud projected onto its sharp surface
  Features features;  // one entry per point of the blend
};

/// Thesis §5.4.3: first the blend, then the labels of chapter 3, then the projection of chapter 4,
/// for the samples of the cloud: face and collar are smooth already.
/// The collar is never a feature; samples near it are one only if they are in the scan alone, so
/// that the collar is no false side to them. Throws as blend() does.
SharpBlend blend_sharp(std::span<const Vec3> cloud, const NurbsFace& face,
                       const BlendOptions& options = {}, const Job& job = {});

/// The labels alone; result: of blend() for this cloud.
Features label_blend(std::span<const Vec3> cloud, const Blend& result, const Job& job = {});

}  // namespace spigolo
