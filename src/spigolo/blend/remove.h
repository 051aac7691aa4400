// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/remove.h - the samples of the cloud that the face encloses (thesis §5.4.2.3): X
#pragma once

#include <optional>

#include "spigolo/blend/border.h"

namespace spigolo {

/// On which side of the face the cloud stays: where its normal points (1) or against it (-1). With
/// a direction to keep it decides, if it says anything; else the smaller of the two parts that the
/// intersection cuts the cloud into goes. Throws NoResultError if the intersection does not cut the
/// cloud in two and no direction is given.
int choose_side(const CloudSide& cloud, const BorderLoop& loop, const std::optional<Vec3>& keep);

/// Marks the samples (canonical order) inside the curve of the betas: those of the connected band
/// along it that lie on the collar's side, and all that is reached from there. Adds to `removed`.
/// Throws NoResultError if that comes round to the other side: the intersection does not enclose
/// anything.
void remove_enclosed(const CloudSide& cloud, const BorderLoop& loop, std::vector<char>& removed);

}  // namespace spigolo
