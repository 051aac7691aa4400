// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/las_writer.h - LAS 1.2 or 1.4
#pragma once

#include "spigolo/core/point_cloud.h"
#include "spigolo/io/atomic_file.h"
#include "spigolo/io/write_options.h"

namespace spigolo {

/// LAS 1.2 with point format 0 to 3 where that holds everything; LAS 1.4 for extra bytes, and with
/// format 6 to 8 for fields that only those have or more than 2^32 - 1 points. Attributes named as
/// las_fields() has them go there if their values fit (colours of uint8 times 257), all others into
/// extra bytes. Coordinates: options.grid if they fit it, else a grid that keeps them to the last
/// bit if there is one; report.rounding says what was lost.
/// Throws UsageError if a coordinate is not finite.
void write_las(AtomicFile& out, const PointCloud& cloud, const WriteOptions& options,
               WriteReport& report);

}  // namespace spigolo
