// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/folds.cpp
#include "spigolo/sheets/folds.h"

#include <algorithm>

#include "spigolo/core/parallel.h"
#include "spigolo/index/row_search.h"
#include "spigolo/sheets/hinge.h"

namespace spigolo {
namespace {

constexpr std::size_t grain = 256;
constexpr std::size_t one_in = 3;    // points is the center of a neighborhood
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

// The hinges of every one_in-th point; a few centers that lie together seek their neighbors at
// once.
void look_around(const SheetModel& model, RowSearch& search, std::size_t k, std::size_t begin,
                 std::span<Hinge> hinges) {
  const std::span<const Vec3> points = model.points();
  HingeTest test(model.tolerances.noise);
  std::vector<std::uint32_t> centers, rows(together * k);
  std::vector<Vec3> around;
  for (std::size_t first = 0; first < hinges.size(); first += together) {
    centers.clear();
    for (std::size_t h = first; h < std::min(first + together, hinges.size()); ++h)
      centers.push_back(static_cast<std::uint32_t>((begin + h) * one_in));
    search.find(centers, rows.data());
    for (std::size_t c = 0; c < centers.size(); ++c) {
      around.assign(1, points[centers[c]]);
      for (const std::uint32_t j : std::span(rows).subspan(c * k, k)) around.push_back(points[j]);
      hinges[first + c] = largest_fold(around, model.tolerances.k,
                                       model.prepared.spacing.of_point[centers[c]], test);
    }
  }
}

std::vector<Hinge> look_around(const SheetModel& model, const Job& job) {
  const KdTree tree(model.prepared.cloud);
  const std::size_t k = std::min(model.tolerances.k << doublings(model), model.size() - 1);
  std::vector<Hinge> hinges((model.size() + one_in - 1) / one_in);
  parallel_for(job, "folds", hinges.size(), grain, [&](std::size_t begin, std::size_t end) {
    RowSearch search(tree, k);
    look_around(model, search, k, begin, std::span(hinges).subspan(begin, end - begin));
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
  const std::vector<Hinge> hinges = look_around(model, job);
  for (std::uint32_t i = 0; i < model.size(); ++i) {
    std::uint32_t center = i;
    const auto row = model.prepared.neighborhoods.of(i);
    for (std::size_t n = 0; center % one_in != 0 && n < row.size(); ++n) center = row[n];
    if (center % one_in != 0) continue;
    const Hinge& hinge = hinges[center / one_in];
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
