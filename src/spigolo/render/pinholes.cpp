// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/pinholes.cpp
#include "spigolo/render/pinholes.h"

#include <algorithm>
#include <array>

namespace spigolo {
namespace {

constexpr float gap_depth = 1.5f;  // in radii: a step this deep is a gap, not a slope
constexpr int most_steps = 5;      // along each of the eight ways
constexpr std::array<std::array<int, 2>, 8> ways = {
    {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}}};

struct Search {
  const std::vector<float>& front;
  const TileGrid& grid;
  float radius;
  const Camera& camera;

  float depth(int x, int y) const {
    if (x < 0 || y < 0 || x >= grid.width || y >= grid.height) return no_depth;
    return front[static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.width) +
                 static_cast<std::size_t>(x)];
  }

  // The first depth on the way that is clearly nearer than z; no_depth if there is none.
  float nearer(int x, int y, const std::array<int, 2>& way, float z) const {
    const float length = way[0] != 0 && way[1] != 0 ? 0.7f * radius : radius;
    const int steps = std::clamp(static_cast<int>(length), 1, most_steps);
    for (int step = 1; step <= steps; ++step) {
      const int reach = std::max(
          step,
          static_cast<int>(length * static_cast<float>(step) / static_cast<float>(steps) + 0.5f));
      const float d = depth(x + way[0] * reach, y + way[1] * reach);
      if (d == no_depth) continue;
      const auto unit = static_cast<float>(camera.pixel_size(static_cast<double>(d)));
      if (d < z - gap_depth * std::max(radius, 1.0f) * unit) return d;
    }
    return no_depth;
  }

  float closed(int x, int y) const {
    const float z = depth(x, y);
    float farthest = 0;
    for (const auto& way : ways) {
      const float d = nearer(x, y, way, z);
      if (d == no_depth) return z;
      farthest = std::max(farthest, d);
    }
    return farthest;
  }
};

}  // namespace

float typical_radius(std::span<const Splat> splats) {
  std::vector<float> radii;
  const std::size_t stride = std::max<std::size_t>(1, splats.size() / 4096);
  for (std::size_t i = 0; i < splats.size(); i += stride)
    if (splats[i].radius > 0) radii.push_back(splats[i].radius);
  if (radii.empty()) return 0;
  const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
  std::nth_element(radii.begin(), middle, radii.end());
  return *middle;
}

void close_pinholes(std::vector<float>& front, const TileGrid& grid, float radius,
                    const Camera& camera, const Job& job) {
  std::vector<float> closed(front.size());
  const Search search{front, grid, std::max(1.25f * radius, 1.0f), camera};
  for_each_tile(grid, "", job, [&](std::size_t, const PixelBox& box) {
    for (int y = box.y0; y < box.y1; ++y)
      for (int x = box.x0; x < box.x1; ++x)
        closed[static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.width) +
               static_cast<std::size_t>(x)] = search.closed(x, y);
  });
  front.swap(closed);
}

}  // namespace spigolo
