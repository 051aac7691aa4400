// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/gauss_map/connect.h - which feature points lie on the same edge? (thesis §4.3.6)
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/index/kd_tree.h"

namespace spigolo {

struct ConnectOptions {
  std::size_t k = 20;  // neighbors of a feature point that are looked at
  double sigma = 0.3;  // [rad] clusters of normals closer than this merge, as in the feature test
  double min_cluster = 0.15;   // share of the triangles; smaller clusters are noise
  std::size_t triangles = 24;  // most triangles a pair of feature points is judged by
};

/// For every feature point the feature points of its neighborhood that it is connected to, in
/// ascending order; itself is not among them.
struct ConnectedFeatures {
  std::vector<std::uint32_t> begin;  // of each point's list in `features`; one more than points
  std::vector<std::uint32_t> features;

  std::span<const std::uint32_t> of(std::size_t i) const {
    return {features.data() + begin[i], begin[i + 1] - begin[i]};
  }
};

/// f1 and f2 are on the same edge if the normals of the triangles (f1, f2, p_i), with p_i the
/// points of f1's neighborhood that are no features, form two clusters. is_feature: one flag per
/// point of the tree. The list of f2 need not name f1.
ConnectedFeatures connect_features(const KdTree& tree, std::span<const std::uint8_t> is_feature,
                                   const ConnectOptions& options, const Job& job = {});

}  // namespace spigolo
