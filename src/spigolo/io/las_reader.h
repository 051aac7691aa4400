// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/las_reader.h - LAS 1.0 to 1.4, not compressed, all point formats
#pragma once

#include "spigolo/core/point_cloud.h"
#include "spigolo/io/input_bytes.h"
#include "spigolo/io/read_report.h"

namespace spigolo {

/// Coordinates as GridAxis decodes them. The standard fields become attributes by the names of
/// las_fields(), those that are zero at every point are left out; extra bytes become attributes by
/// their own names, scaled where they say so. Colours keep their 16 bits. Wave packets are skipped.
/// report.grid is the file's grid. Throws InputError.
PointCloud read_las(const InputBytes& input, ReadReport& report);

}  // namespace spigolo
