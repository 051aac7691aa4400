// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// A program that has nothing but the installed package: a roof has one edge.
#include <spigolo/spigolo.h>

#include <cstdio>
#include <vector>

int main() {
  std::vector<spigolo::Vec3> roof;
  for (int i = -20; i <= 20; ++i)
    for (int j = 0; j <= 40; ++j) roof.push_back({1.0 * i, 1.0 * j, i < 0 ? 1.0 * i : -1.0 * i});
  const auto counts = spigolo::detect(roof).features.counts();
  std::printf("%zu surface, %zu edge points\n", counts[0], counts[1]);
  return counts[1] >= 30 && counts[1] < 200 ? 0 : 1;
}
