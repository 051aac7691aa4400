// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/las_plan.h - which attribute of a cloud goes where in a LAS file
#pragma once

#include <cstdint>
#include <vector>

#include "spigolo/core/point_cloud.h"
#include "spigolo/io/las_layout.h"
#include "spigolo/io/write_options.h"

namespace spigolo {

/// An attribute and its place in the record; stored = value * factor.
struct LasColumn {
  const Attribute* attribute = nullptr;
  LasField field;
  double factor = 1;
};

struct LasPlan {
  int minor = 2;
  std::uint8_t format = 0;
  std::size_t record = 0;          // bytes of a point
  std::vector<LasColumn> columns;  // in standard fields
  std::vector<LasColumn> extras;   // in extra bytes; at most 341, the rest is dropped
};

/// The smallest version and point format that keep everything.
LasPlan plan_las(const PointCloud& cloud, WriteReport& report);

}  // namespace spigolo
