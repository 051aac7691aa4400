// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/intersect.h - where the isolines of the face meet the cloud's surface
#pragma once

#include "spigolo/blend/cloud_side.h"
#include "spigolo/blend/strand.h"

namespace spigolo {

/// Follows the line from its start to the first place where the sign of the distance to the MLS
/// surface changes, found to a millionth of the spacing. The sign is carried along the line: the
/// cloud needs no orientation. Sets `crosses` and, if so, at, x, face_normal, cloud_normal.
void find_crossing(const Isolines& isolines, const CloudSide& cloud, Strand& strand,
                   MlsScratch& scratch);

/// All lines of a start, more of them where X, seen from line to line, is farther apart than the
/// spacing. If some lines miss the cloud, what is left is the longest run of lines that meet it: an
/// open curve.
/// missed: receives the number of lines that do not meet the cloud. Throws NoResultError if no line
/// meets it, or if X jumps from one line to the next.
BorderLoop find_intersection(const Isolines& isolines, const CloudSide& cloud, std::size_t& missed,
                             const Job& job);

/// Puts a line between strands i and i + 1 (the first one after the last) for each i in `gaps`
/// (ascending) and finds its crossing. Lines that miss the cloud are not put in.
void insert_lines(const Isolines& isolines, const CloudSide& cloud,
                  const std::vector<std::size_t>& gaps, BorderLoop& loop, const Job& job);

}  // namespace spigolo
