// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/text_writer.h - tables of numbers: .xyz .txt .csv .pts
#pragma once

#include "spigolo/core/point_cloud.h"
#include "spigolo/io/atomic_file.h"
#include "spigolo/io/write_options.h"

namespace spigolo {

enum class TextDialect { xyz, csv, pts };

/// Numbers are written so that they read back equal to the last bit. xyz: blanks between, and if
/// there are attributes a first line `# x y z NAME ...`. csv: commas and a line of names. pts: the
/// count, then x y z, intensity and red green blue as far as there are; other attributes are
/// dropped and reported.
void write_text(AtomicFile& out, const PointCloud& cloud, TextDialect dialect, WriteReport& report);

}  // namespace spigolo
