// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/pcd_reader.h - PCD 0.5 to 0.7: ascii, binary and compressed
#pragma once

#include "spigolo/core/point_cloud.h"
#include "spigolo/io/input_bytes.h"
#include "spigolo/io/read_report.h"

namespace spigolo {

/// All fields become attributes: a field of several numbers NAME_0, NAME_1 ...; the packed rgb and
/// rgba red, green, blue (and alpha) as uint8; integers of 8 bytes float64. Padding ("_") is
/// skipped. Points that are NaN are kept.
/// Throws InputError if header or body is damaged or the points are not all there. A compressed
/// body may grow 88 times, never more.
PointCloud read_pcd(const InputBytes& input, ReadReport& report);

}  // namespace spigolo
