// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/shares.h - how likely a noisy point is of one sheet or of another
#pragma once

#include <array>

#include "spigolo/sheets/local_sheets.h"

namespace spigolo {

/// One number a sheet; they sum to 1. A sheet that ends at another one has points beyond its end
/// only as far as noise carries them. Where no sheet is within reach all are 0. noise: [spacings].
std::array<double, LocalSheets::most> shares_of(const LocalSheets& sheets, const Vec3& p,
                                                double noise);

}  // namespace spigolo
