// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/measure/classification.h - how well flagged points meet the true features (section 3.7)
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "spigolo/core/features.h"
#include "spigolo/core/job.h"
#include "spigolo/core/point_cloud.h"

namespace spigolo {

/// What is true of every point of a constructed cloud.
struct FeatureTruth {
  std::vector<std::uint8_t> feature;  // 1: a feature point
  std::vector<double> edge_distance;  // of the noise-free sample to the nearest crease or tip
  double spacing = 0;                 // h, of the noise-free cloud
  bool lattice = false;               // features lie exactly on an edge, else within .75 h of one
  std::vector<double> local_spacing = {};  // h of each place; empty: `spacing` everywhere
};

/// From the attributes truth_feature, truth_edge_distance and, if there, truth_spacing; throws
/// NoResultError without the first two.
FeatureTruth read_truth(const PointCloud& cloud, double spacing, bool lattice);

/// thin: every flagged point that is no feature is wrong, however close to an edge it lies.
/// tolerant: non-features up to 1.5 h (on a lattice) or 2 h (off it) from an edge do not count.
enum class Scoring : std::uint8_t { thin, tolerant };

struct Classification {
  std::size_t points = 0;    // that count
  std::size_t ignored = 0;   // that do not
  std::size_t features = 0;  // true ones
  std::size_t flagged = 0;   // of the points that count
  std::size_t hits = 0;      // features that are flagged
  std::size_t missed = 0;    // features that are not
  std::size_t outliers = 0;  // flagged points that are no features
  double recall = 1;         // hits / features; 1 if there are none
  double precision = 1;      // hits / flagged; 1 if there are none
  double f1 = 1;  // harmonic mean of the two; 1 if there is nothing to find and no outlier
};

/// flagged: one entry per point, nonzero for a detected feature. Throws UsageError unless all have
/// the same length.
Classification classify(std::span<const std::uint8_t> flagged, const FeatureTruth& truth,
                        Scoring scoring);

/// 1 for edge, corner and tip, 0 for surface and border.
std::vector<std::uint8_t> sharp_flags(const Features& features);

/// delta_inf and delta_avg of section 3.7.5: distances of the estimated feature points P to their
/// nearest true feature points Q.
struct FeatureDeviation {
  double max = 0;   // delta_inf
  double mean = 0;  // delta_avg
  std::size_t estimated = 0, real = 0;
};

/// Zero deviation if nothing was estimated; throws NoResultError if something was but there are no
/// true features.
FeatureDeviation feature_deviation(std::span<const Vec3> estimated, std::span<const Vec3> real,
                                   const Job& job = {});

}  // namespace spigolo
