// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/tiles.cpp
#include "spigolo/render/tiles.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "spigolo/core/parallel.h"

namespace spigolo {
namespace {

constexpr std::size_t most_chunks = 32;  // bounds the memory of the counts

// Calls visit(tile) for every tile the box touches.
template <class Visit>
void visit_tiles(const TileGrid& grid, const PixelBox& box, const Visit& visit) {
  const PixelBox b = intersection(box, {0, 0, grid.width, grid.height});
  if (b.empty()) return;
  for (int row = b.y0 / TileGrid::side; row <= (b.y1 - 1) / TileGrid::side; ++row)
    for (int column = b.x0 / TileGrid::side; column <= (b.x1 - 1) / TileGrid::side; ++column)
      visit(static_cast<std::size_t>(row * grid.columns() + column));
}

}  // namespace

PixelBox intersection(const PixelBox& a, const PixelBox& b) {
  return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

PixelBox box_around(double x, double y, double reach) {
  if (!(std::abs(x) < 1e8 && std::abs(y) < 1e8 && reach < 1e8)) return {};
  const auto low = [&](double v) { return static_cast<int>(std::floor(v - reach)); };
  const auto high = [&](double v) { return static_cast<int>(std::floor(v + reach)) + 1; };
  return {low(x), low(y), high(x), high(y)};
}

PixelBox TileGrid::box(std::size_t tile) const {
  const int x = static_cast<int>(tile) % columns() * side,
            y = static_cast<int>(tile) / columns() * side;
  return {x, y, std::min(x + side, width), std::min(y + side, height)};
}

TileBins::TileBins(const TileGrid& grid, std::size_t count,
                   const std::function<PixelBox(std::size_t)>& box_of, const Job& job) {
  const std::size_t tiles = grid.count();
  const std::size_t grain = std::max<std::size_t>(4096, (count + most_chunks - 1) / most_chunks);
  const std::size_t chunks = (count + grain - 1) / grain;
  std::vector<std::size_t> next(chunks * tiles);  // first counts, then where to write
  parallel_for(job, "", count, grain, [&](std::size_t begin, std::size_t end) {
    std::size_t* counts = next.data() + begin / grain * tiles;
    for (std::size_t i = begin; i < end; ++i)
      visit_tiles(grid, box_of(i), [&](std::size_t tile) { ++counts[tile]; });
  });
  start_.resize(tiles + 1);
  std::size_t total = 0;
  for (std::size_t tile = 0; tile < tiles; ++tile) {
    start_[tile] = total;
    for (std::size_t chunk = 0; chunk < chunks; ++chunk)
      total += std::exchange(next[chunk * tiles + tile], total);
  }
  start_[tiles] = total;
  items_.resize(total);
  parallel_for(job, "", count, grain, [&](std::size_t begin, std::size_t end) {
    std::size_t* at = next.data() + begin / grain * tiles;
    for (std::size_t i = begin; i < end; ++i)
      visit_tiles(grid, box_of(i),
                  [&](std::size_t tile) { items_[at[tile]++] = static_cast<std::uint32_t>(i); });
  });
}

void for_each_tile(const TileGrid& grid, std::string_view stage, const Job& job,
                   const std::function<void(std::size_t, const PixelBox&)>& draw) {
  parallel_for(job, stage, grid.count(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t tile = begin; tile < end; ++tile) draw(tile, grid.box(tile));
  });
}

}  // namespace spigolo
