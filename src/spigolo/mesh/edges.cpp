// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/edges.cpp
#include "spigolo/mesh/edges.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "spigolo/core/error.h"
#include "spigolo/core/parallel.h"
#include "spigolo/core/parity_sets.h"

namespace spigolo {
namespace {

constexpr std::size_t grain = 4096;

struct Entry {
  std::uint32_t high, half;
};

// The half-edges of every vertex that is the lower end, begin[v] to begin[v + 1].
struct ByLowerEnd {
  std::vector<std::uint32_t> begin;
  std::vector<Entry> entries;
};

ByLowerEnd sort_by_lower_end(std::size_t vertices, std::span<const Triangle> triangles) {
  ByLowerEnd by{std::vector<std::uint32_t>(vertices + 1, 0), {}};
  for (const Triangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) ++by.begin[std::min(t[i], t[(i + 1) % 3]) + std::size_t{1}];
  std::partial_sum(by.begin.begin(), by.begin.end(), by.begin.begin());
  by.entries.resize(3 * triangles.size());
  std::vector<std::uint32_t> next(by.begin.begin(), by.begin.end() - 1);
  std::uint32_t half = 0;
  for (const Triangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i, ++half) {
      const auto [low, high] = std::minmax(t[i], t[(i + 1) % 3]);
      by.entries[next[low]++] = {high, half};
    }
  return by;
}

}  // namespace

const MeshEdge* EdgeTable::find(std::uint32_t a, std::uint32_t b) const {
  const auto [low, high] = std::minmax(a, b);
  if (std::size_t{low} + 1 >= first.size()) return nullptr;
  const auto begin = edges.begin() + first[low], end = edges.begin() + first[low + 1];
  const auto at = std::lower_bound(
      begin, end, high, [](const MeshEdge& edge, std::uint32_t h) { return edge.high < h; });
  return at != end && at->high == high ? &*at : nullptr;
}

EdgeTable find_edges(std::size_t vertices, std::span<const Triangle> triangles, const Job& job) {
  if (triangles.size() > std::numeric_limits<std::uint32_t>::max() / 3)
    throw UsageError("a mesh of more than 1.4 billion triangles is too large");
  ByLowerEnd by = sort_by_lower_end(vertices, triangles);
  parallel_for(job, "", vertices, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v)
      std::sort(by.entries.begin() + by.begin[v], by.entries.begin() + by.begin[v + 1],
                [](const Entry& a, const Entry& b) {
                  return a.high != b.high ? a.high < b.high : a.half < b.half;
                });
  });
  EdgeTable table;
  table.halves.resize(by.entries.size());
  table.edges.reserve(by.entries.size() / 2 + 1);
  table.first.reserve(vertices + 1);
  for (std::uint32_t v = 0; v < vertices; ++v) {
    table.first.push_back(static_cast<std::uint32_t>(table.edges.size()));
    for (std::uint32_t i = by.begin[v]; i < by.begin[v + 1]; ++i) {
      const auto [high, half] = by.entries[i];
      table.halves[i] = half;
      if (i == by.begin[v] || table.edges.back().high != high)
        table.edges.push_back({v, high, i, 0});
      ++table.edges.back().count;
    }
  }
  table.first.push_back(static_cast<std::uint32_t>(table.edges.size()));
  return table;
}

std::vector<std::uint32_t> find_twins(const EdgeTable& table, std::size_t triangles) {
  std::vector<std::uint32_t> twin(3 * triangles, no_index);
  for (const MeshEdge& edge : table.edges) {
    if (edge.count != 2) continue;
    const auto halves = table.of(edge);
    twin[halves[0]] = halves[1];
    twin[halves[1]] = halves[0];
  }
  return twin;
}

std::vector<std::uint32_t> find_fans(std::span<const Triangle> triangles, const EdgeTable& table) {
  ParitySets corners(3 * triangles.size());
  const auto corner_at = [&](std::uint32_t half, std::uint32_t v) {
    return triangles[half / 3][half % 3] == v ? half : next_half(half);
  };
  for (const MeshEdge& edge : table.edges) {
    const auto halves = table.of(edge);
    for (std::size_t i = 1; i < halves.size(); ++i)
      for (const std::uint32_t v : {edge.low, edge.high})
        corners.join(corner_at(halves[0], v), corner_at(halves[i], v));
  }
  std::vector<std::uint32_t> fan(3 * triangles.size());
  for (std::uint32_t corner = 0; corner < fan.size(); ++corner)
    fan[corner] = corners.find(corner).set;
  return fan;
}

std::vector<std::uint32_t> find_fan_vertices(std::size_t vertices,
                                             std::span<const Triangle> triangles,
                                             const EdgeTable& table) {
  const std::vector<std::uint32_t> fan = find_fans(triangles, table);
  std::vector<std::uint32_t> fans(vertices, 0);
  for (std::uint32_t corner = 0; corner < fan.size(); ++corner)
    if (fan[corner] == corner) ++fans[triangles[corner / 3][corner % 3]];
  std::vector<std::uint32_t> several;
  for (std::uint32_t v = 0; v < vertices; ++v)
    if (fans[v] > 1) several.push_back(v);
  return several;
}

}  // namespace spigolo
