// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/sheet_cloud.cpp
#include "spigolo/sheets/sheet_cloud.h"

#include <algorithm>

namespace spigolo {

std::vector<std::uint32_t> second_ring(const SheetCloud& cloud, std::uint32_t i) {
  std::vector<std::uint32_t> found(1, i);
  for (const std::uint32_t j : cloud.neighborhoods.of(i)) {
    const auto row = cloud.neighborhoods.of(j);
    found.push_back(j);
    found.insert(found.end(), row.begin(), row.end());
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace spigolo
