// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/gauss_map/feature_test.h - is one point on a sharp feature? (thesis §3.4.3)
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "spigolo/core/geometry.h"
#include "spigolo/gauss_map/clustering.h"
#include "spigolo/gauss_map/gauss_map.h"

namespace spigolo {

struct FeatureTestOptions {
  double sigma = 0.1;  // [rad] clusters closer than this merge; in (0, pi/2]; larger finds fewer
  double flatness = 0.15;     // share of a right angle; a smaller spread of normals means flat
  double min_cluster = 0.15;  // share of the triangles; smaller clusters are noise
  int max_clusters = 4;       // more than this many is noise, not a corner
};

enum class FeatureVerdict : std::uint8_t {
  degenerate,  // fewer than three triangles with area: coincident or collinear neighbors
  flat,        // the flatness test ended it
  smooth,      // one cluster, or too many
  sharp        // two, three or four clusters
};

struct FeatureTest {
  FeatureVerdict verdict = FeatureVerdict::degenerate;
  int clusters = 0;              // that count; 0 unless clustering was needed
  std::array<Vec3, 2> normal{};  // unit normals of the two largest, if sharp; signs arbitrary
  double second_share = 0;       // share of the triangles in the second largest cluster
};

/// Memory of one thread; keeping it between calls avoids allocation.
struct FeatureTestScratch {
  std::vector<Vec3> neighbors;
  GaussMap map;
  Clustering clustering;
};

/// Flatness test first; if it fails, the clusters of the Gauss map decide.
/// neighbors: the k nearest points of p, without p itself, at most 64.
FeatureTest test_point(const Vec3& p, std::span<const Vec3> neighbors,
                       const FeatureTestOptions& options, FeatureTestScratch& scratch);

/// Deviation from flat [rad] of the edge through p between the sheets of these two unit normals:
/// pi minus the angle between the half planes in which the neighbors lie; in [0, pi].
double edge_deviation(const Vec3& p, std::span<const Vec3> neighbors,
                      const std::array<Vec3, 2>& normal);

}  // namespace spigolo
