// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/folds.cpp
#include "spigolo/sheets/folds.h"

#include <algorithm>
#include <utility>

#include "spigolo/core/parallel.h"
#include "spigolo/index/row_search.h"
#include "spigolo/index/sample.h"
#include "spigolo/sheets/hinge.h"

namespace spigolo {
namespace {

constexpr std::size_t grain = 256;
constexpr std::size_t contest = 2;   // nearest neighbors: a center has a lower number than these
constexpr std::size_t together = 8;  // centers
constexpr double much = 0.55;        // [spacings] of noise: neighborhoods double twice, else once
constexpr double reach = 2.5;        // [spacings] of a proposal

std::size_t doublings(const SheetModel& model) { return model.tolerances.noise < much ? 1 : 2; }

// The verdict of the largest neighborhood that has one. around: the points of that, the center
// first.
Hinge largest_fold(std::span<const Vec3> around, std::size_t smallest, double spacing,
                   HingeTest& test) {
  Hinge best;
  for (std::size_t k = smallest;; k *= 2) {
    const Hinge hinge = test.find(around.first(std::min(k + 1, around.size())), spacing);
    if (hinge.fold == Fold::unclear) return best;
    best = hinge;
    if (hinge.fold == Fold::bend || k + 1 >= around.size()) return best;
  }
}

// One point in three, evenly and the same ones in a turned cloud.
std::vector<std::uint32_t> choose_centers(const SheetModel& model, const Job& job) {
  const PreparedCloud& p = model.prepared;
  const auto is_center = [&](std::size_t i) {
    const auto own = chance_number(p.spacing, i);
    const auto row = p.neighborhoods.of(i).first(std::min(contest, p.neighborhoods.k));
    return std::all_of(row.begin(), row.end(), [&](std::uint32_t j) {
      return std::pair(own, i) < std::pair(chance_number(p.spacing, j), std::size_t{j});
    });
  };
  return parallel_select(job, model.size(), grain, is_center);
}

// The hinges of the centers; a few that lie together seek their neighbors at once.
void look_around(const SheetModel& model, RowSearch& search, std::size_t k,
                 std::span<const std::uint32_t> centers, std::span<Hinge> hinges) {
  const std::span<const Vec3> points = model.points();
  HingeTest test(model.tolerances.noise);
  std::vector<std::uint32_t> rows(together * k);
  std::vector<Vec3> around;
  for (std::size_t first = 0; first < hinges.size(); first += together) {
    const auto some = centers.subspan(first, std::min(together, centers.size() - first));
    search.find(some, rows.data());
    for (std::size_t c = 0; c < some.size(); ++c) {
      around.assign(1, points[some[c]]);
      for (const std::uint32_t j : std::span(rows).subspan(c * k, k)) around.push_back(points[j]);
      hinges[first + c] =
          largest_fold(around, model.tolerances.k, model.prepared.spacing.of_point[some[c]], test);
    }
  }
}

std::vector<Hinge> look_around(const SheetModel& model, std::span<const std::uint32_t> centers,
                               const Job& job) {
  const KdTree tree(model.prepared.cloud);
  const std::size_t k = std::min(model.tolerances.k << doublings(model), model.size() - 1);
  std::vector<Hinge> hinges(centers.size());
  parallel_for(job, "folds", hinges.size(), grain, [&](std::size_t begin, std::size_t end) {
    RowSearch search(tree, k);
    look_around(model, search, k, centers.subspan(begin, end - begin),
                std::span(hinges).subspan(begin, end - begin));
  });
  return hinges;
}

SheetVerdict proposal(const Hinge& hinge) {
  SheetVerdict verdict;
  verdict.kind = PointKind::edge;
  verdict.crease_point = hinge.point;
  verdict.direction = hinge.direction;
  verdict.into = hinge.into;
  verdict.deviation = hinge.deviation;
  verdict.sheets = 2;
  verdict.folded = 1;
  return verdict;
}

}  // namespace

void propose_folds(SheetModel& model, const SheetOptions& options, const Job& job) {
  const std::vector<std::uint32_t> centers = choose_centers(model, job);
  const std::vector<Hinge> hinges = look_around(model, centers, job);
  std::vector<std::uint32_t> place(model.size(), no_point);  // of a center among them
  for (std::uint32_t c = 0; c < centers.size(); ++c) place[centers[c]] = c;
  for (std::uint32_t i = 0; i < model.size(); ++i) {
    std::uint32_t center = i;
    const auto row = model.prepared.neighborhoods.of(i);
    for (std::size_t n = 0; place[center] == no_point && n < row.size(); ++n) center = row[n];
    if (place[center] == no_point) continue;
    const Hinge& hinge = hinges[place[center]];
    if (hinge.fold == Fold::bend) {
      SheetVerdict bent;
      bent.folded = -1;
      model.verdicts.set(i, bent);
    }
    if (hinge.fold != Fold::edge || hinge.deviation < least_deviation(options.sensitivity))
      continue;
    const Vec3 to = model.points()[i] - hinge.point;
    const double away = norm(to - hinge.direction * dot(to, hinge.direction));
    if (away < reach * model.prepared.spacing.of_point[i]) model.verdicts.set(i, proposal(hinge));
  }
}

}  // namespace spigolo
