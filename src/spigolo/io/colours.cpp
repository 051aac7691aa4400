// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/colours.cpp
#include "spigolo/io/colours.h"

#include <algorithm>
#include <array>
#include <utility>

#include "spigolo/io/scalar.h"

namespace spigolo {

void add_colours(PointCloud& cloud, std::vector<std::vector<double>> channels, bool whole) {
  constexpr std::array names = {"red", "green", "blue", "alpha"};
  const bool shares = !whole && std::all_of(channels.begin(), channels.end(), [](const auto& c) {
    return std::all_of(c.begin(), c.end(), [](double v) { return !(v > 1); });
  });
  for (std::size_t c = 0; c < channels.size() && c < names.size(); ++c) {
    for (double& v : channels[c]) v = narrow<std::uint8_t>(shares ? v * 255 : v);
    cloud.set(names[c], ScalarType::uint8, std::move(channels[c]));
  }
}

std::vector<const Attribute*> find_colours(const PointCloud& cloud) {
  std::vector<const Attribute*> colours;
  for (const char* name : {"red", "green", "blue"}) {
    const Attribute* a = cloud.find(name);
    if (a == nullptr || a->type != ScalarType::uint8) return {};
    colours.push_back(a);
  }
  return colours;
}

}  // namespace spigolo
