// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/placed.cpp
#include "spigolo/sheets/placed.h"

#include <algorithm>

#include "spigolo/core/parallel.h"
#include "spigolo/sheets/placed_crease.h"

namespace spigolo {
namespace {

constexpr std::size_t grain = 4096, judge_grain = 64;
constexpr double right_on = 0.02;  // [spacings] from the crease
// Of the edge marks. Of samples by chance one in thirty lies so close.
constexpr double placed_share = 0.4;

bool right_on_crease(const SheetCloud& cloud, const SheetVerdict& verdict, std::size_t i) {
  return distance(cloud.points[i], verdict.crease_point) <= right_on * cloud.spacing.of_point[i];
}

// Verdicts on some places from their nearest k neighbors.
template <typename Judge>
void judge_again(const SheetCloud& cloud, std::span<const std::uint32_t> places, std::size_t k,
                 VerdictRows& verdicts, const Job& job, const Judge& judge) {
  k = std::min(k, cloud.neighborhoods.k);
  const auto again = [&](std::size_t begin, std::size_t end, std::vector<FoundVerdict>& found) {
    std::vector<std::uint32_t> members;
    for (const std::uint32_t i : places.subspan(begin, end - begin)) {
      const auto row = cloud.neighborhoods.of(i).first(k);
      members.assign(1, i);
      members.insert(members.end(), row.begin(), row.end());
      found.emplace_back(i, judge(members));
    }
  };
  verdicts.set(parallel_collect<FoundVerdict>(job, places.size(), judge_grain, again));
}

}  // namespace

bool is_placed(const SheetCloud& cloud, const VerdictRows& verdicts, const Job& job) {
  const auto count = [&](auto&& counts) {
    return static_cast<double>(parallel_count(job, verdicts.size(), grain, [&](std::size_t i) {
      return verdicts[i].kind == PointKind::edge && counts(i);
    }));
  };
  const double edges = count([](std::size_t) { return true; });
  const double placed =
      count([&](std::size_t i) { return right_on_crease(cloud, verdicts[i], i); });
  return edges > 0 && placed >= placed_share * edges;
}

void judge_placed(const SheetCloud& cloud, const SheetTolerances& tolerances,
                  const SheetOptions& options, VerdictRows& verdicts, const Job& job) {
  const auto doubtful = parallel_select(job, verdicts.size(), grain, [&](std::size_t i) {
    const PointKind kind = verdicts[i].kind;
    return (kind == PointKind::edge || kind == PointKind::corner) &&
           !right_on_crease(cloud, verdicts[i], i);
  });
  using Members = std::span<const std::uint32_t>;
  judge_again(cloud, doubtful, tolerances.asked, verdicts, job, [&](Members members) {
    return ends_at(cloud.points, cloud.sheets, members, tolerances, options) ? verdicts[members[0]]
                                                                             : SheetVerdict{};
  });
  const auto unmarked = parallel_select(job, verdicts.size(), grain, [&](std::size_t i) {
    return verdicts[i].kind == PointKind::surface && !cloud.sheets[i].whole;
  });
  const double least = least_deviation(options.sensitivity);
  judge_again(cloud, unmarked, tolerances.k, verdicts, job, [&](Members members) {
    return find_placed_crease(cloud.points, cloud.sheets, members, least).value_or(SheetVerdict{});
  });
}

}  // namespace spigolo
