// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/sampling.cpp
#include "spigolo/render/sampling.h"

#include <array>
#include <cstdint>

#include "spigolo/core/parallel.h"

namespace spigolo {
namespace {

constexpr std::size_t probes = 48;        // points whose neighbors are searched in full
constexpr std::size_t neighbors = 6;      // of a surface point: one ring
constexpr double cell_in_spacings = 3.0;  // about nine points a cell
constexpr double least = 0.35, most = 4;  // of the typical spacing

// Distance to the sixth nearest point that is not at the same place; 0 if there is none.
double ring_radius(std::span<const Vec3> points, const Vec3& p) {
  std::array<double, neighbors> nearest;
  nearest.fill(infinity);
  for (const Vec3& q : points) {
    const double d = squared_distance(p, q);
    if (!(d > 0 && d < nearest.back())) continue;
    std::size_t i = neighbors - 1;
    for (; i > 0 && nearest[i - 1] > d; --i) nearest[i] = nearest[i - 1];
    nearest[i] = d;
  }
  for (std::size_t i = neighbors; i-- > 0;)
    if (nearest[i] < infinity) return std::sqrt(nearest[i]);
  return 0;
}

// Median over probes spread over the cloud: a disc of this radius holds about seven points.
double typical_spacing(std::span<const Vec3> points, const Job& job) {
  const std::size_t count = std::min(probes, points.size());
  std::vector<double> radii(count);
  parallel_for(job, "", count, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vec3& p = points[points.size() * i / count];
      if (is_finite(p)) radii[i] = ring_radius(points, p);
    }
  });
  std::erase_if(radii, [](double r) { return !(r > 0); });
  if (radii.empty()) return 0;
  const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
  std::nth_element(radii.begin(), middle, radii.end());
  return *middle * std::sqrt(pi / (neighbors + 1));
}

// The occupied cells of an endless grid; open addressing.
struct Cell {
  std::uint64_t key = 0;
  std::uint32_t count = 0;
  float spacing = 0;
};

class CellTable {
 public:
  explicit CellTable(std::size_t points) {
    std::size_t size = 64;
    while (size < 2 * points) size *= 2;
    cells_.resize(size);
  }
  void add(std::uint64_t key) {
    Cell& cell = cells_[find(key)];
    cell.key = key, ++cell.count;
  }
  const Cell& at(std::uint64_t key) const { return cells_[find(key)]; }
  std::span<Cell> cells() { return cells_; }

 private:
  std::size_t find(std::uint64_t key) const {
    std::size_t i = (key * 0x9e3779b97f4a7c15u >> 20) & (cells_.size() - 1);
    while (cells_[i].count > 0 && cells_[i].key != key) i = (i + 1) & (cells_.size() - 1);
    return i;
  }
  std::vector<Cell> cells_;
};

constexpr std::uint64_t axis_bits = 21;
constexpr std::uint64_t axis_mask = (std::uint64_t{1} << axis_bits) - 1;

struct CellGrid {
  Vec3 origin;
  double size;

  // Cells are counted from 1, so that each has neighbors on both sides.
  std::uint64_t key(const Vec3& p) const {
    const auto along = [&](double v, double low) {
      return static_cast<std::uint64_t>(std::min((v - low) / size, 2e6)) + 1;
    };
    return along(p.x, origin.x) << 2 * axis_bits | along(p.y, origin.y) << axis_bits |
           along(p.z, origin.z);
  }
};

// Root of area per point over the 27 cells round a cell; an occupied one counts as its face area.
double spacing_round(const CellTable& table, const CellGrid& grid, std::uint64_t key) {
  double points = 0, cells = 0;
  for (std::uint64_t k = 0; k < 27; ++k) {
    const std::uint64_t x = (key >> 2 * axis_bits) + k % 3 - 1,
                        y = (key >> axis_bits & axis_mask) + k / 3 % 3 - 1,
                        z = (key & axis_mask) + k / 9 - 1;
    const auto n = table.at(x << 2 * axis_bits | y << axis_bits | z).count;
    points += n, cells += n > 0 ? 1 : 0;
  }
  return grid.size * std::sqrt(std::min(cells, 14.0) / points);
}

}  // namespace

std::vector<float> local_spacings(std::span<const Vec3> points, const Job& job) {
  const double typical = typical_spacing(points, job);
  if (!(typical > 0)) return {0.0f};
  const CellGrid grid{bounding_box(points).min, cell_in_spacings * typical};
  CellTable table(points.size());
  for (const Vec3& p : points)
    if (is_finite(p)) table.add(grid.key(p));
  const std::span<Cell> cells = table.cells();
  parallel_for(job, "", cells.size(), 16384, [&](std::size_t begin, std::size_t end) {
    for (Cell& cell : cells.subspan(begin, end - begin))
      if (cell.count > 0)
        cell.spacing = static_cast<float>(
            std::clamp(spacing_round(table, grid, cell.key), least * typical, most * typical));
  });
  std::vector<float> spacings(points.size());
  parallel_for(job, "", points.size(), 16384, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (is_finite(points[i])) spacings[i] = table.at(grid.key(points[i])).spacing;
  });
  return spacings;
}

}  // namespace spigolo
