// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/index/neighborhoods.cpp - points that lie together share one walk through the tree
#include "spigolo/index/neighborhoods.h"

#include <algorithm>
#include <numeric>

#include "spigolo/core/error.h"
#include "spigolo/core/parallel.h"
#include "spigolo/index/row_search.h"

namespace spigolo {
namespace {

constexpr std::uint32_t group_size = 16;  // queries that share their candidates
constexpr std::size_t grain = 128;        // groups handed to a thread at a time

struct Group {
  std::uint32_t node, begin, end;
};

// The largest cells of the tree with at most group_size points.
std::vector<Group> make_groups(const KdTree& tree) {
  std::vector<Group> groups;
  const auto nodes = tree.nodes();
  for (std::uint32_t id = 0; id < nodes.size();) {
    const KdTree::Node& node = nodes[id];
    if (node.end - node.begin > group_size && node.right != 0) {
      ++id;  // its left child follows, the right one after that
      continue;
    }
    groups.push_back({id, node.begin, node.end});
    while (id < nodes.size() && nodes[id].begin < node.end) ++id;  // over all its children
  }
  return groups;
}

}  // namespace

Neighborhoods find_neighborhoods(const KdTree& tree, std::size_t k, const Job& job) {
  Neighborhoods result;
  const std::size_t n = tree.points().size();
  result.k = n == 0 ? 0 : std::min(k, n - 1);
  if (result.k == 0) return result;
  result.index = parallel_array<std::uint32_t>(job, n * result.k);
  const std::vector<Group> groups = make_groups(tree);
  parallel_for(job, "neighbors", groups.size(), grain, [&](std::size_t begin, std::size_t end) {
    RowSearch search(tree, result.k);
    std::vector<std::uint32_t> queries;
    for (const Group& group : std::span(groups).subspan(begin, end - begin)) {
      queries.resize(group.end - group.begin);
      std::iota(queries.begin(), queries.end(), group.begin);
      search.find(queries, &result.index[group.begin * result.k]);
    }
  });
  return result;
}

void validate(const Neighborhoods& neighborhoods, std::span<const Vec3> points) {
  if (neighborhoods.size() != points.size() && neighborhoods.k != 0)
    throw Error("neighborhoods: one row a point is needed");
  std::vector<std::uint32_t> sorted;
  for (std::size_t i = 0; i < neighborhoods.size(); ++i) {
    const auto row = neighborhoods.of(i);
    sorted.assign(row.begin(), row.end());
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
      throw Error("neighborhoods: a neighbor stands twice");
    double last = 0;
    for (const std::uint32_t j : row) {
      if (j >= points.size() || j == i) throw Error("neighborhoods: not a neighbor");
      const double d = squared_distance(points[i], points[j]);
      if (d < last) throw Error("neighborhoods: not nearest first");
      last = d;
    }
  }
}

}  // namespace spigolo
