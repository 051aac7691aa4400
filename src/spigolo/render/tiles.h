// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/tiles.h - the picture in square tiles, and which item touches which tile
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "spigolo/core/job.h"

namespace spigolo {

/// Pixels [x0, x1) x [y0, y1).
struct PixelBox {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  bool empty() const { return x0 >= x1 || y0 >= y1; }
};

PixelBox intersection(const PixelBox& a, const PixelBox& b);

/// The pixels whose middles can lie within `reach` of (x, y); empty if not finite.
PixelBox box_around(double x, double y, double reach);

struct TileGrid {
  static constexpr int side = 64;
  int width = 0, height = 0;

  int columns() const { return (width + side - 1) / side; }
  int rows() const { return (height + side - 1) / side; }
  std::size_t count() const {
    return static_cast<std::size_t>(columns()) * static_cast<std::size_t>(rows());
  }
  PixelBox box(std::size_t tile) const;
};

/// The items of each tile in rising order, so that drawing tile by tile gives the picture of
/// drawing item by item, whatever the threads.
class TileBins {
 public:
  /// box_of(i): the pixels item i may touch; it may reach outside the picture. count < 2^32.
  TileBins(const TileGrid& grid, std::size_t count,
           const std::function<PixelBox(std::size_t)>& box_of, const Job& job);
  std::span<const std::uint32_t> items(std::size_t tile) const {
    return {items_.data() + start_[tile], start_[tile + 1] - start_[tile]};
  }

 private:
  std::vector<std::size_t> start_;
  std::vector<std::uint32_t> items_;
};

/// draw(tile, box) for every tile.
void for_each_tile(const TileGrid& grid, std::string_view stage, const Job& job,
                   const std::function<void(std::size_t tile, const PixelBox& box)>& draw);

}  // namespace spigolo
