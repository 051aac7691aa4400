// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/pcd_writer.h - PCD 0.7: ascii, binary and compressed
#pragma once

#include "spigolo/core/point_cloud.h"
#include "spigolo/io/atomic_file.h"
#include "spigolo/io/write_options.h"

namespace spigolo {

/// All attributes are kept, in order and type; red, green, blue of uint8 are packed into one field
/// rgb, as PCL has it (alpha stays a field of its own). x y z are floats if every coordinate is one
/// exactly, doubles if not. options.compressed falls back to binary beyond 4 GiB.
void write_pcd(AtomicFile& out, const PointCloud& cloud, const WriteOptions& options);

}  // namespace spigolo
