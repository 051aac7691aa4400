// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/fill.h - even samples of the kept part of the face and of the collars: S and C
#pragma once

#include "spigolo/blend/collar.h"
#include "spigolo/blend/loops.h"

namespace spigolo {

/// The numbers of `scalar_source` in files.
enum class BlendSource : std::uint8_t { cloud = 0, nurbs = 1, collar = 2 };

struct FilledPoint {
  Vec3 point, normal;  // relative to the cloud's origin; the normal points to the free side
  BlendSource source = BlendSource::nurbs;
  std::uint32_t border = 0;  // number of the start it belongs to
};

/// Samples of face and collars at the density of the cloud: six times as many random ones, then
/// elimination of all together, with the kept samples of the cloud (removed: by canonical order)
/// in their places. Returned by start, face before collar.
std::vector<FilledPoint> fill_blend(const CloudSide& cloud, const std::vector<char>& removed,
                                    const std::vector<TracedStart>& traced,
                                    const std::vector<Collar>& collars, std::uint64_t seed,
                                    const Job& job);

}  // namespace spigolo
