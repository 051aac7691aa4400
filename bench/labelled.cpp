// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/labelled.cpp
#include "labelled.h"

#include <algorithm>

#include "spigolo/core/error.h"
#include "spigolo/io/cloud_file.h"

namespace spigolo::bench {
namespace {

// Red is a sharp edge: (168, 0, 0) or (255, 0, 0).
std::vector<std::uint8_t> red_points(const PointCloud& cloud) {
  const Attribute *red = cloud.find("red"), *green = cloud.find("green"),
                  *blue = cloud.find("blue");
  std::vector<std::uint8_t> labels(cloud.size());
  if (!red || !green || !blue) throw InputError("labelled cloud", "header", "has no colours");
  for (std::size_t i = 0; i < cloud.size(); ++i)
    labels[i] = red->values[i] >= 100 && green->values[i] == 0 && blue->values[i] == 0;
  return labels;
}

}  // namespace

std::vector<LabelledCloud> read_labelled(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".ply") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<LabelledCloud> clouds;
  for (const auto& file : files) {
    const PointCloud cloud = read_cloud(file);
    LabelledCloud labelled{file.stem().string(), cloud.points, {}};
    labelled.truth.feature = red_points(cloud);
    labelled.truth.edge_distance.assign(cloud.size(), infinity);
    clouds.push_back(std::move(labelled));
  }
  return clouds;
}

}  // namespace spigolo::bench
