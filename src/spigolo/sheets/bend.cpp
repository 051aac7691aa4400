// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/bend.cpp
#include "spigolo/sheets/bend.h"

#include <cmath>
#include <vector>

#include "spigolo/sheets/normal_equations.h"

namespace spigolo {
namespace {

constexpr int lines = 6;          // tried on each side of the center
constexpr double farthest = 1.2;  // widths of the look: a line beyond has too little on one side

// A point in a frame whose u is across the line.
struct Row {
  double weight;
  FramePlace at;
};

struct Fold {
  double squares = infinity;  // weighted, less what all folds have in common
  double line = 0;            // u of the line
  std::array<double, 6> a{};  // w = a0 + a1 u + a2 v + a3 |u - line|
};

Fold fit_fold(const std::vector<Row>& rows, double line) {
  Matrix6 m{};
  Fold fold;
  fold.line = line;
  std::array<double, 6> right{};
  for (const Row& r : rows) {
    const std::array<double, 4> term = {1, r.at.u, r.at.v, std::abs(r.at.u - line)};
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) m[i][j] += r.weight * term[i] * term[j];
      right[i] += r.weight * term[i] * r.at.w;
    }
  }
  fold.a = right;
  if (!solve(m, fold.a, 4)) return fold;
  fold.squares = 0;
  for (std::size_t i = 0; i < 4; ++i) fold.squares -= fold.a[i] * right[i];
  return fold;
}

// The frame of a sheet, turned so that u is along the larger of its curvatures.
Sheet along_bend(const Sheet& bent) {
  const double turn = 0.5 * std::atan2(bent.a[4], bent.a[3] - bent.a[5]);
  const double c = std::cos(turn), s = std::sin(turn);
  const double across = bent.a[3] * c * c + bent.a[4] * c * s + bent.a[5] * s * s;
  const double other = bent.a[3] + bent.a[5] - across;
  Sheet frame = bent;
  frame.u = bent.u * c + bent.v * s;
  frame.v = bent.v * c - bent.u * s;
  if (std::abs(other) > std::abs(across)) {
    const Vec3 u = frame.u;
    frame.u = frame.v, frame.v = -u;
  }
  return frame;
}

Sheet half_plane(const Sheet& frame, const Fold& fold, double side) {
  Sheet half = frame;
  half.a = {
      fold.a[0] - side * fold.a[3] * fold.line, fold.a[1] + side * fold.a[3], fold.a[2], 0, 0, 0};
  return half;
}

}  // namespace

std::optional<LocalSheets> fold_at_bend(const SheetRegion& region, const Sheet& bent) {
  if (!bent.fitted() || !bent.is_curved()) return std::nullopt;
  const Sheet frame = along_bend(bent);
  const double width = region.smoothing * region.spacing / frame.spacing;
  std::vector<Row> rows;
  for (const Vec3& p : region.points) {
    const FramePlace at = in_frame(frame, p);
    rows.push_back({std::exp(-(at.u * at.u + at.v * at.v + at.w * at.w) / (width * width)), at});
  }
  Fold best;
  for (int i = -lines; i <= lines; ++i) {
    const Fold fold = fit_fold(rows, farthest * width * i / lines);
    if (fold.squares < best.squares) best = fold;
  }
  if (!(best.squares < infinity)) return std::nullopt;
  LocalSheets halves = region.sheets;
  halves.count = 2;
  halves.sheet[0] = half_plane(frame, best, -1);
  halves.sheet[1] = half_plane(frame, best, 1);
  halves.data_sides.fill(~std::uint64_t{0});
  return halves;
}

}  // namespace spigolo
