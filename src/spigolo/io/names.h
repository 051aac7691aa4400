// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/names.h - attribute names that keep the promises of PointCloud
#pragma once

#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "spigolo/core/point_cloud.h"

namespace spigolo {

/// More columns than this are taken for damage: validate() and every reader stay fast.
inline constexpr std::size_t max_columns = 4096;

/// Hands out names that are not empty, without blanks or control characters, and never twice:
/// a name seen before gets "_2", "_3" ...
class UniqueNames {
 public:
  UniqueNames(std::initializer_list<std::string> taken) : taken_(taken) {}
  std::string operator()(std::string_view wanted);

 private:
  std::unordered_set<std::string> taken_;
};

/// One name an attribute, as files take them: unique, and none of x, y, z.
std::vector<std::string> file_names(const PointCloud& cloud);

}  // namespace spigolo
