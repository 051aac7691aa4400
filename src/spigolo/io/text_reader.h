// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/text_reader.h - tables of numbers: .xyz .txt .csv .pts
#pragma once

#include "spigolo/core/point_cloud.h"
#include "spigolo/io/input_bytes.h"
#include "spigolo/io/read_report.h"

namespace spigolo {

/// One point a line, at least three numbers, as many on every line; separated by blanks, tabs, or
/// one comma or semicolon. An empty field is NaN. `#` and `//` begin a comment, `;` does so as the
/// first character of a line; blank lines are skipped.
/// Names of the columns: a first line that is no number, or a comment just before the first point
/// that begins with x, y, z; columns x, y, z are then the position wherever they stand, and r, g, b
/// together become red, green, blue. Without names, columns 4 and up are scalar_3, scalar_4 ...;
/// but three last columns of whole numbers in 0..255 in a file of six or seven columns are red,
/// green, blue (uint8), and the fourth of a .pts file is intensity. A line with one whole number
/// before points is a count, as .pts has it; the points must be there. All values are double but
/// for colours (uint8 if all fit). Throws InputError with the number of the line for a missing or
/// surplus column, for what is not a number, for decimal commas; and if there is no point at all. A
/// file cut inside the last number of its last line cannot be told from a whole one.
PointCloud read_text(const InputBytes& input, bool is_pts, ReadReport& report);

}  // namespace spigolo
