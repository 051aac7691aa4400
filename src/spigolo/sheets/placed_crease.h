// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/placed_crease.h - a crease that samples were put on
#pragma once

#include <optional>
#include <span>

#include "spigolo/sheets/verdict.h"

namespace spigolo {

/// Whether members[0] lies on two exact sheets at once, and two more of its neighbors on the same
/// two, so that their crossing is no chance; one of the sheets ends there. The other may go on, as
/// a floor does behind a rib or a wall behind a groove, which find_edge cannot allow for samples
/// that lie beside their creases. Or whether an exact sheet ends here in a row of samples, and what
/// goes on from there is too narrow for a sheet, as the crest of such a rib. At most 128 members.
/// least_deviation [rad].
std::optional<SheetVerdict> find_placed_crease(std::span<const Vec3> points,
                                               std::span<const Sheet> sheets,
                                               std::span<const std::uint32_t> members,
                                               double least_deviation);

}  // namespace spigolo
