// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/whole_fit.h - one quadric to each whole neighborhood, several points at once
#pragma once

#include <cstddef>
#include <span>

#include "spigolo/index/neighborhoods.h"
#include "spigolo/index/spacing.h"
#include "spigolo/sheets/sheet.h"

namespace spigolo {

/// The neighborhoods to fit: each point and the first k of its neighbors, k at most that of the
/// rows.
struct WholeFits {
  std::span<const Vec3> points;
  const Neighborhoods& neighborhoods;
  const Spacing& spacing;
  std::size_t k = 0;
};

/// out[i - begin] = fit_sheet of the neighborhood of point i, all points used, for i in
/// [begin, end): to the last bit what one call a point gives, since every point keeps to a lane of
/// its own and each lane adds in the same order.
void fit_whole_sheets(const WholeFits& fits, std::size_t begin, std::size_t end, Sheet* out);

}  // namespace spigolo
