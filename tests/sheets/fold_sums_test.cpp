// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
#include "spigolo/sheets/fold_sums.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "spigolo/core/random.h"

namespace spigolo {
namespace {

std::vector<FoldRow> random_rows(std::size_t n, Random& random) {
  std::vector<FoldRow> rows(n);
  for (FoldRow& row : rows)
    for (double& entry : row) entry = random.normal();
  return rows;
}

TEST(FoldSums, HeightsAreHyperbolas) {
  Random random(3);
  for (const std::size_t n : {1u, 7u, 8u, 21u}) {
    std::vector<double> s(n);
    for (double& at : s) at = random.normal();
    const std::vector<double> before = s;
    fold_heights(s, 0.3);
    for (std::size_t i = 0; i < n; ++i) {
      const double r = 0.3;
      EXPECT_EQ(s[i], std::sqrt(before[i] * before[i] + r * r));
    }
  }
}

TEST(FoldSums, BinsAreThePlainSums) {
  Random random(4);
  const auto rows = random_rows(50, random);
  std::vector<std::uint32_t> bin(rows.size());
  for (std::uint32_t i = 0; i < bin.size(); ++i) bin[i] = i * i % 7;
  std::vector<FoldRow> bins(7, FoldRow{}), expected = bins;
  add_to_bins(rows, bin, bins);
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t e = 0; e < 8; ++e) expected[bin[i]][e] += rows[i][e];
  EXPECT_EQ(bins, expected);
}

// To the last bit, whatever the instruction set: one fold after the other, row after row.
TEST(FoldSums, SumsAreThePlainSums) {
  Random random(5);
  const auto rows = random_rows(48, random);
  for (const std::size_t folds : {1u, 2u, 3u, 9u}) {
    std::vector<double> heights(rows.size() * folds);
    for (double& h : heights) h = random.normal();
    std::vector<FoldRow> sums(folds), expected(folds, FoldRow{});
    sum_folds(rows, heights, sums);
    for (std::size_t o = 0; o < folds; ++o)
      for (std::size_t i = 0; i < rows.size(); ++i) {
        const double h = heights[i * folds + o];
        expected[o][0] += rows[i][0] * h * h;
        for (std::size_t e = 1; e < 8; ++e) expected[o][e] += rows[i][e] * h;
      }
    EXPECT_EQ(sums, expected);
  }
}

}  // namespace
}  // namespace spigolo
