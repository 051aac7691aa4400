// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// examples/01_detect.cpp - reads a cloud, labels its points, prints how many there are of each kind
//
// usage: example_01_detect CLOUD
#include <spigolo/spigolo.h>

#include <cstdio>

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s CLOUD\n", argv[0]);
    return 2;
  }
  try {
    const spigolo::PointCloud cloud = spigolo::read_cloud(argv[1]);
    const spigolo::Detection found = spigolo::detect(cloud.points);
    for (const std::string& warning : found.warnings)
      std::fprintf(stderr, "warning: %s\n", warning.c_str());

    std::printf("%zu points, spacing %g, noise %g spacings\n", cloud.size(), found.spacing,
                found.noise);
    const auto counts = found.features.counts();
    for (std::size_t kind = 0; kind < spigolo::point_kinds; ++kind)
      std::printf("%-8s %zu\n", spigolo::point_kind_names[kind], counts[kind]);
    return 0;
  } catch (const spigolo::Error& error) {  // the base of everything that is thrown
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
