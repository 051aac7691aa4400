// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/mesh/min_cut_test.cpp - the cheapest labels, against all of them tried
#include "spigolo/mesh/min_cut.h"

#include <gtest/gtest.h>

#include <array>
#include <stop_token>

#include "spigolo/core/random.h"

namespace spigolo {
namespace {

struct Edge {
  std::uint32_t a, b;
  std::int32_t price;
};
struct Problem {
  std::vector<std::array<std::int32_t, 2>> nodes;
  std::vector<Edge> edges;
};

Problem random_problem(std::uint32_t nodes, std::size_t edges, Random& random) {
  Problem p;
  for (std::uint32_t i = 0; i < nodes; ++i)
    p.nodes.push_back(
        {static_cast<std::int32_t>(random.below(20)), static_cast<std::int32_t>(random.below(20))});
  for (std::size_t e = 0; e < edges; ++e) {
    const auto a = static_cast<std::uint32_t>(random.below(nodes)),
               b = static_cast<std::uint32_t>(random.below(nodes));
    if (a != b) p.edges.push_back({a, b, static_cast<std::int32_t>(random.below(15))});
  }
  return p;
}

template <class Label>
long long price(const Problem& p, const Label& label) {
  long long sum = 0;
  for (std::size_t i = 0; i < p.nodes.size(); ++i) sum += p.nodes[i][label(i)];
  for (const auto& [a, b, cost] : p.edges) sum += label(a) != label(b) ? cost : 0;
  return sum;
}

std::vector<std::uint8_t> solve(const Problem& p) {
  MinCut cut(p.nodes.size());
  for (std::uint32_t i = 0; i < p.nodes.size(); ++i)
    cut.add_node_price(i, p.nodes[i][0], p.nodes[i][1]);
  for (const auto& [a, b, cost] : p.edges) cut.add_edge_price(a, b, cost);
  return cut.solve();
}

TEST(MinCut, NoLabellingIsCheaper) {
  Random random(5);
  for (int run = 0; run < 300; ++run) {
    const Problem p = random_problem(10, 5 + static_cast<std::size_t>(run % 30), random);
    const auto found = solve(p);
    long long least = 1 << 30;
    for (std::size_t bits = 0; bits < 1024; ++bits)
      least = std::min(least, price(p, [&](std::size_t i) { return bits >> i & 1; }));
    ASSERT_EQ(price(p, [&](std::size_t i) { return std::size_t{found[i]}; }), least) << run;
  }
}

TEST(MinCut, CanBeCancelled) {
  MinCut cut(2);
  cut.add_node_price(0, 0, 5);
  cut.add_edge_price(0, 1, 3);
  std::stop_source source;
  source.request_stop();
  Job job;
  job.stop = source.get_token();
  EXPECT_THROW(cut.solve(job), Cancelled);
}

// A field of 60 x 60 nodes: no single node nor pair of neighbors can change to a better label.
TEST(MinCut, LargeFieldsAreSettled) {
  constexpr std::uint32_t side = 60;
  Random random(7);
  Problem p = random_problem(side * side, 0, random);
  for (std::uint32_t i = 0; i < side * side; ++i) {
    if (i % side + 1 < side) p.edges.push_back({i, i + 1, 6});
    if (i + side < side * side) p.edges.push_back({i, i + side, 6});
  }
  const auto found = solve(p);
  const long long best = price(p, [&](std::size_t i) { return std::size_t{found[i]}; });
  for (const Edge& e : p.edges)
    EXPECT_GE(price(p,
                    [&](std::size_t i) {
                      return std::size_t{found[i]} ^ (i == e.a || i == e.b ? 1U : 0U);
                    }),
              best);
}

}  // namespace
}  // namespace spigolo
