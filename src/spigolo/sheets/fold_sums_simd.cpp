// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/fold_sums_simd.cpp - an entry of the rows a lane; compiled once per instruction
// set
#include "spigolo/sheets/fold_sums.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "spigolo/sheets/fold_sums_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "spigolo/sheets/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace spigolo {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t entries = std::tuple_size_v<FoldRow>;

void heights_in_place(std::span<double> distances, double roundness) {
  const LaneTag d;
  const auto round2 = hn::Set(d, roundness * roundness);
  const auto height = [&](LaneVec s) HWY_ATTR { return hn::Sqrt(hn::Add(hn::Mul(s, s), round2)); };
  std::size_t i = 0;
  for (; i + hn::Lanes(d) <= distances.size(); i += hn::Lanes(d))
    hn::StoreU(height(hn::LoadU(d, &distances[i])), d, &distances[i]);
  for (; i < distances.size(); ++i) distances[i] = hn::GetLane(height(hn::Set(d, distances[i])));
}

void add_rows(std::span<const FoldRow> rows, std::span<const std::uint32_t> bin,
              std::span<FoldRow> bins) {
  const LaneTag d;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double* row = rows[i].data();
    double* to = bins[bin[i]].data();
    for (std::size_t e = 0; e < entries; e += hn::Lanes(d))
      hn::StoreU(hn::Add(hn::LoadU(d, to + e), hn::LoadU(d, row + e)), d, to + e);
  }
}

// As many entries as there are lanes, from entry e on, of a few folds side by side: so many sums
// that one addition does not wait for the other.
template <std::size_t folds>
void sum_few(std::span<const FoldRow> rows, const double* heights, std::size_t stride,
             std::size_t e, FoldRow* sums) {
  const LaneTag d;
  const auto count = hn::FirstN(d, e == 0 ? 1 : 0);
  std::array<LaneVec, folds> sum;
  sum.fill(hn::Zero(d));
  for (std::size_t i = 0; i < rows.size(); ++i, heights += stride) {
    const auto row = hn::LoadU(d, &rows[i][e]);
    for (std::size_t o = 0; o < folds; ++o) {
      const auto f = hn::Set(d, heights[o]);
      const auto once = hn::Mul(row, f);
      sum[o] = hn::Add(sum[o], hn::IfThenElse(count, hn::Mul(once, f), once));
    }
  }
  for (std::size_t o = 0; o < folds; ++o) hn::StoreU(sum[o], d, &sums[o][e]);
}

void sum_all(std::span<const FoldRow> rows, std::span<const double> heights,
             std::span<FoldRow> sums) {
  constexpr std::size_t few = 3;
  for (std::size_t e = 0; e < entries; e += hn::Lanes(LaneTag())) {
    std::size_t o = 0;
    for (; o + few <= sums.size(); o += few)
      sum_few<few>(rows, &heights[o], sums.size(), e, &sums[o]);
    for (; o < sums.size(); ++o) sum_few<1>(rows, &heights[o], sums.size(), e, &sums[o]);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace spigolo
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace spigolo {

HWY_EXPORT(heights_in_place);
HWY_EXPORT(add_rows);
HWY_EXPORT(sum_all);

void fold_heights(std::span<double> distances, double roundness) {
  HWY_DYNAMIC_DISPATCH(heights_in_place)(distances, roundness);
}

void add_to_bins(std::span<const FoldRow> rows, std::span<const std::uint32_t> bin,
                 std::span<FoldRow> bins) {
  HWY_DYNAMIC_DISPATCH(add_rows)(rows, bin, bins);
}

void sum_folds(std::span<const FoldRow> rows, std::span<const double> heights,
               std::span<FoldRow> sums) {
  HWY_DYNAMIC_DISPATCH(sum_all)(rows, heights, sums);
}

}  // namespace spigolo
#endif  // HWY_ONCE
