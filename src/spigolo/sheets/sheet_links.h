// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/sheet_links.h - points that lie side by side on one sheet, and how it is turned
#pragma once

#include <span>
#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/core/parity_sets.h"
#include "spigolo/sheets/sheet_cloud.h"

namespace spigolo {

/// The normals of the own sheets below their points; zero where there is no sheet.
std::vector<Vec3> own_normals(const SheetCloud& cloud, const Job& job = {});

inline constexpr double one_sheet_cosine = 0.9;  // of normals on one sheet, side by side

/// Joins each point with those of its nearest neighbors that lie on its sheet, both within `near`
/// [spacings] of the other's; two of a set differ if their normals look to opposite sides. Links
/// are believed in the order of their angle (three classes), then of the points.
ParitySets link_along_sheets(const SheetCloud& cloud, std::span<const Vec3> normal, double near,
                             const Job& job = {});

}  // namespace spigolo
