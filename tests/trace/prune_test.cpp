// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// trace: what joining and pruning make of chains, and of networks that were cut to pieces
#include <gtest/gtest.h>

#include "spigolo/trace/guide.h"
#include "spigolo/trace/junctions.h"

namespace spigolo {
namespace {

constexpr double least = 4;  // [spacings] of a curve that stays

// Pieces of six places along the x axis, with a junction of two ends between each and the next.
// Every second one runs backwards.
RawNetwork line_in_pieces(int count) {
  RawNetwork network;
  for (int i = 0; i < count; ++i) {
    RawCurve curve;
    for (int k = 1; k <= 6; ++k) curve.chain.places.push_back({7.0 * i + k, 0, 0});
    curve.junction = {i == 0 ? no_junction : i - 1, i + 1 == count ? no_junction : i};
    if (i % 2 == 1) {
      std::swap(curve.junction[0], curve.junction[1]);
      std::swap(curve.chain.places.front(), curve.chain.places.back());
      std::swap(curve.chain.places[1], curve.chain.places[4]);
      std::swap(curve.chain.places[2], curve.chain.places[3]);
    }
    network.curves.push_back(std::move(curve));
    if (i + 1 < count) network.junctions.push_back({7.0 * (i + 1), 0, 0});
  }
  return network;
}

TEST(Prune, aLineInThousandsOfPiecesIsOneCurve) {
  for (const int count : {2, 3, 1500}) {
    const RawNetwork network = prune(line_in_pieces(count), least);
    ASSERT_EQ(network.curves.size(), 1u) << count;
    EXPECT_TRUE(network.junctions.empty());
    EXPECT_EQ(network.curves[0].chain.places.size(), static_cast<std::size_t>(6 * count));
    EXPECT_NEAR(network.curves[0].chain.length(), 7.0 * count - 2, 1e-9);
  }
}

TEST(Prune, aRingInPiecesIsClosed) {
  RawNetwork network;
  for (int i = 0; i < 12; ++i) {
    RawCurve curve;
    for (int k = 1; k <= 6; ++k) {
      const double angle = 2 * pi * (7 * i + k) / 84;
      curve.chain.places.push_back({14 * std::cos(angle), 14 * std::sin(angle), 0});
    }
    curve.junction = {i, (i + 1) % 12};
    network.curves.push_back(curve);
    const double angle = 2 * pi * 7 * i / 84;
    network.junctions.push_back({14 * std::cos(angle), 14 * std::sin(angle), 0});
  }
  network = prune(std::move(network), least);
  ASSERT_EQ(network.curves.size(), 1u);
  EXPECT_TRUE(network.curves[0].chain.closed);
  EXPECT_EQ(network.curves[0].chain.places.size(), 72u);
}

// One of three chains runs past the corner they meet in, on and a little to the side.
TEST(Join, anEndThatRunsPastItsCornerDoesNotDoubleBack) {
  std::vector<Chain> chains(3);
  for (int k = 1; k <= 15; ++k) {
    chains[0].places.push_back({1.0 * k, 0, 0});
    chains[1].places.push_back({0, 1.0 * k, 0});
  }
  for (int k = -1; k <= 15; ++k) chains[2].places.push_back({0.1, 0.1, k + 0.2});
  const RawNetwork network = join_chains(chains, {}, 0);
  ASSERT_EQ(network.curves.size(), 3u);
  ASSERT_EQ(network.junctions.size(), 1u);
  for (const RawCurve& curve : network.curves) {
    const Guide guide = guide_of(curve, network.junctions);
    EXPECT_LT(guide.length(), distance(guide.places.front(), guide.places.back()) + 0.1);
  }
}

// Two junctions a spacing apart, and a tail that runs out from one and back to the other.
TEST(Prune, aCornerSeenTwiceIsOne) {
  RawNetwork network;
  network.junctions = {{0, 0, 0}, {0, 0, 0.8}};
  network.curves.resize(4);
  for (int k = 1; k <= 10; ++k) {
    network.curves[0].chain.places.push_back({1.0 * k, 0, 0});
    network.curves[1].chain.places.push_back({0, 1.0 * k, 0});
    network.curves[2].chain.places.push_back({0, 0, 1.0 + k});
  }
  network.curves[3].chain.places = {{-1, 0, 0.4}};
  network.curves[0].junction = network.curves[1].junction = {0, no_junction};
  network.curves[2].junction = {1, no_junction};
  network.curves[3].junction = {0, 1};
  network = prune(std::move(network), least);
  ASSERT_EQ(network.curves.size(), 3u);
  ASSERT_EQ(network.junctions.size(), 1u);
  for (const RawCurve& curve : network.curves) EXPECT_EQ(curve.junction[0], 0);
}

}  // namespace
}  // namespace spigolo
