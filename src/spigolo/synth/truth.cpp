// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/truth.cpp - what is true of every sample
#include "spigolo/synth/truth.h"

#include <optional>
#include <utility>

#include "spigolo/core/features.h"
#include "spigolo/core/parallel.h"
#include "spigolo/index/kd_tree.h"

namespace spigolo {
namespace {

constexpr double on_edge = 1e-12;    // share of the shape's radius that is rounding
constexpr double near_edge = 0.75;   // [spacings] off the lattice, nearer is a feature
constexpr double seen_within = 2.5;  // [spacings] of a crease, samples of each of its sides

PointKind kind_of(const Shape& shape, const Vec3& p, double edge, double limit) {
  if (corner_distance(shape, p) <= limit) return PointKind::corner;
  if (tip_distance(shape, p) <= limit) return PointKind::tip;
  if (edge <= limit) return PointKind::edge;
  return border_distance(shape, p) <= limit ? PointKind::border : PointKind::surface;
}

/// Tells which creases were seen from both sides.
class Seen {
 public:
  explicit Seen(const SynthCloud& made)
      : made_(made), ordered_(order_cloud(made.exact)), tree_(ordered_) {}

  /// Whether at least two of the patches that meet in the crease point nearest to p have a sample
  /// near it.
  bool both_sides(const Vec3& p, double spacing) const {
    const Vec3 at = nearest_crease(made_.shape, p).point;
    std::vector<Neighbor> around;
    tree_.within(at - ordered_.origin, seen_within * spacing, around);
    const double rounding = 1e3 * on_edge * made_.shape.radius;
    int sides = 0;
    for (const Patch& patch : made_.shape.patches) {
      if (distance(at, patch.nearest(at)) > rounding) continue;
      sides += std::any_of(around.begin(), around.end(), [&](const Neighbor& n) {
        const Vec3 q = ordered_.points[n.index] + ordered_.origin;
        return distance(q, patch.nearest(q)) <= rounding;
      });
    }
    return sides >= 2;
  }

 private:
  const SynthCloud& made_;
  OrderedCloud ordered_;
  KdTree tree_;
};

}  // namespace

void add_truth(SynthCloud& made, const LocalSpacing& local, bool half_seen, const Job& job) {
  const std::size_t n = made.exact.size();
  const double rounding = on_edge * made.shape.radius;
  std::optional<Seen> seen;
  if (half_seen) seen.emplace(made);
  std::vector<double> feature(n), distance(n), kind(n);
  parallel_for(job, "truth", n, 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const double h = local.empty() ? made.spacing : local[i];
      const double limit = made.lattice ? rounding : near_edge * h;
      const double d = edge_distance(made.shape, made.exact[i]);
      PointKind k = kind_of(made.shape, made.exact[i], d, limit);
      const bool on_crease = k == PointKind::edge || k == PointKind::corner;
      if (on_crease && seen && !seen->both_sides(made.exact[i], h)) k = PointKind::border;
      distance[i] = d <= rounding ? 0 : d;
      kind[i] = static_cast<double>(k);
      feature[i] = k != PointKind::surface && k != PointKind::border;
    }
  });
  made.cloud.set("truth_feature", ScalarType::uint8, std::move(feature));
  made.cloud.set("truth_edge_distance", ScalarType::float64, std::move(distance));
  made.cloud.set("truth_kind", ScalarType::uint8, std::move(kind));
  if (!local.empty()) made.cloud.set("truth_spacing", ScalarType::float64, local);
}

}  // namespace spigolo
