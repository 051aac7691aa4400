// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/mesh/majority_test.cpp - wrong claims are outvoted
#include "spigolo/mesh/majority.h"

#include <gtest/gtest.h>

#include "spigolo/core/random.h"

namespace spigolo {
namespace {

// Cells of a square grid, left half of one side, right half of the other; neighbors say how they
// lie to each other, and some of them lie.
struct Grid {
  static constexpr std::uint32_t side = 30, cells = side * side;
  std::vector<Claim> claims;
  std::size_t wrong = 0;

  static std::uint8_t truth(std::uint32_t cell) { return cell % side < side / 2 ? 0 : 1; }
  void say(std::uint32_t a, std::uint32_t b, bool lie) {
    const auto differ = static_cast<std::uint8_t>(truth(a) ^ truth(b) ^ (lie ? 1 : 0));
    claims.push_back({a, b, differ, 0.2F});
    wrong += lie ? 1 : 0;
  }
  explicit Grid(double share_of_lies) {
    Random random(5);
    for (std::uint32_t y = 0; y < side; ++y)
      for (std::uint32_t x = 0; x < side; ++x) {
        if (x + 1 < side) say(y * side + x, y * side + x + 1, random.uniform() < share_of_lies);
        if (y + 1 < side) say(y * side + x, (y + 1) * side + x, random.uniform() < share_of_lies);
        if (x + 1 < side && y + 1 < side)
          say(y * side + x, (y + 1) * side + x + 1, random.uniform() < share_of_lies);
      }
  }
};

std::size_t right(const std::vector<std::uint8_t>& sign) {
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < sign.size(); ++i)
    count += (sign[i] ^ sign[0]) == (Grid::truth(i) ^ Grid::truth(0));
  return std::max(count, sign.size() - count);
}

TEST(Majority, TrueClaimsAreAllKept) {
  const Grid grid(0);
  EXPECT_EQ(right(settle_by_majority(grid.claims, Grid::cells)), Grid::cells);
}

TEST(Majority, WrongOnesAreOutvoted) {
  const Grid grid(0.05);
  ASSERT_GT(grid.wrong, 100U);
  EXPECT_GE(right(settle_by_majority(grid.claims, Grid::cells)), Grid::cells * 99 / 100);
}

TEST(Majority, ALineOfClaimsBeatsASureOne) {
  std::vector<Claim> claims = {{0, 1, 0, 0}, {2, 3, 0, 0}, {0, 2, 1, 0.1F}};
  for (int i = 0; i < 3; ++i) claims.push_back({1, 3, 0, 0.3F});
  const auto sign = settle_by_majority(claims, 5);
  EXPECT_EQ(sign[0], sign[2]);
  EXPECT_EQ(sign[1], sign[3]);
}

}  // namespace
}  // namespace spigolo
