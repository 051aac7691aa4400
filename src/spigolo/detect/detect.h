// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/detect/detect.h - which points of a raw cloud lie on sharp features
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "spigolo/core/features.h"
#include "spigolo/core/geometry.h"
#include "spigolo/core/job.h"

namespace spigolo {

enum class DetectMethod : std::uint8_t {
  sheets,            // smooth sheets fitted to each neighborhood, features where two or more cross
  gauss_map,         // thesis §3.6, local-adaptive
  gauss_map_global,  // thesis §3.4, one sigma and one k for all points
};

/// A parameter that detect() chooses by the noise it finds in the cloud.
inline constexpr double from_noise = -1;

struct DetectOptions {
  DetectMethod method = DetectMethod::sheets;
  double sensitivity = 0.5;  // of sheets, 0 to 1: left fewer bends, right more obtuse edges
  // The others are of the two methods of the thesis.
  std::size_t k = 20;               // neighbors of a point, 4 to 64
  double sigma = from_noise;        // [rad] clusters closer than this merge; in (0, pi/2]
  double flatness = 0.15;           // share of a right angle, 0 to 1; normals spread less: flat
  double min_cluster = from_noise;  // share of the triangles, 0 to 0.5; smaller clusters are noise
};

struct Detection {
  Features features;           // one entry per input point, in input order
  double spacing = 0;          // of the cloud, in the units of the input
  double noise = 0;            // standard deviation across the surface, in spacings
  std::size_t duplicates = 0;  // input points that repeat a place; they share its verdict
  std::size_t non_finite = 0;  // input points with NaN or infinity; labelled surface
  std::size_t degenerate = 0;  // gauss-map: places whose neighborhood spans no surface
  std::size_t candidates =
      0;              // places that passed the first round (gauss-map), or all marked (sheets)
  std::size_t k = 0;  // neighbors used; less than asked for in tiny clouds
  double sigma = 0, min_cluster = 0;  // used by the thesis's methods: given or chosen
  double seconds_index = 0, seconds_detect = 0;
  std::vector<std::string> warnings;
};

/// Labels every point from positions alone, in any unit. The labels do not depend on the order of
/// the points, nor on the threads. Throws UsageError for an option out of range, NoResultError for
/// fewer than nine different places or points that all lie on one line, Cancelled.
Detection detect(std::span<const Vec3> points, const DetectOptions& options = {},
                 const Job& job = {});

}  // namespace spigolo
