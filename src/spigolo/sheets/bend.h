// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/bend.h - a crease of little bend looks like one bent sheet: where would it be?
#pragma once

#include <optional>

#include "spigolo/sheets/sheet_region.h"

namespace spigolo {

/// The two half planes that explain the points of a region best of those that meet in a line
/// across the largest curvature of `bent`, one sheet of all of them. Nothing where it is flat.
std::optional<LocalSheets> fold_at_bend(const SheetRegion& region, const Sheet& bent);

}  // namespace spigolo
