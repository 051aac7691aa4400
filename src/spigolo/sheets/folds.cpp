// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/folds.cpp
#include "spigolo/sheets/folds.h"

#include <algorithm>

#include "spigolo/core/parallel.h"
#include "spigolo/index/kd_tree.h"
#include "spigolo/sheets/hinge.h"

namespace spigolo {
namespace {

constexpr std::size_t grain = 64;
constexpr std::size_t one_in = 3;  // points is the center of a neighborhood
constexpr double much = 0.55;      // [spacings] of noise: neighborhoods double twice, else once
constexpr double reach = 2.5;      // [spacings] of a proposal

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

std::vector<Hinge> look_around(const SheetModel& model, const Job& job) {
  const KdTree tree(model.prepared.cloud);
  const std::size_t k = model.tolerances.k;
  std::vector<Hinge> hinges((model.size() + one_in - 1) / one_in);
  parallel_for(job, "folds", hinges.size(), grain, [&](std::size_t begin, std::size_t end) {
    HingeTest test(model.tolerances.noise);
    std::vector<Neighbor> found;
    std::vector<Vec3> around;
    for (std::size_t h = begin; h < end; ++h) {
      const std::size_t i = h * one_in;
      tree.nearest(model.points()[i], (k << doublings(model)) + 1, found);
      around.clear();
      for (const Neighbor& n : found) around.push_back(model.points()[n.index]);
      hinges[h] = largest_fold(around, k, model.prepared.spacing.of_point[i], test);
    }
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
    SheetVerdict& verdict = model.verdicts[i];
    if (hinge.fold == Fold::bend) {
      verdict = {};
      verdict.folded = -1;
    }
    if (hinge.fold != Fold::edge || hinge.deviation < least_deviation(options.sensitivity))
      continue;
    const Vec3 to = model.points()[i] - hinge.point;
    const double away = norm(to - hinge.direction * dot(to, hinge.direction));
    if (away < reach * model.prepared.spacing.of_point[i]) verdict = proposal(hinge);
  }
}

}  // namespace spigolo
