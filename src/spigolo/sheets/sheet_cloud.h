// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/sheet_cloud.h - what every step between own sheets and verdicts looks at
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "spigolo/index/neighborhoods.h"
#include "spigolo/index/spacing.h"
#include "spigolo/sheets/sheet.h"

namespace spigolo {

/// A view: places in canonical order, their neighbors, their spacing, their own sheets.
struct SheetCloud {
  std::span<const Vec3> points;
  const Neighborhoods& neighborhoods;
  const Spacing& spacing;
  std::span<const Sheet> sheets;

  std::size_t size() const { return points.size(); }
};

/// i, its neighbors and theirs, ascending, each once.
std::vector<std::uint32_t> second_ring(const SheetCloud& cloud, std::uint32_t i);

}  // namespace spigolo
