// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/pipeline/smooth.h - every point of a cloud projected onto its surface
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "spigolo/core/features.h"
#include "spigolo/core/job.h"
#include "spigolo/mls/levin.h"
#include "spigolo/mls/surface_point.h"

namespace spigolo {

enum class SmoothMethod : std::uint8_t {
  sheets,        // onto the local sheet model: exactly sharp
  plain,         // thesis §4.3.2: Levin's projection, which rounds edges
  feature_line,  // thesis §4.3: the neighborhood cut at the feature line
};

struct SmoothOptions {
  SmoothMethod method = SmoothMethod::sheets;
  MlsOptions mls;  // k, smoothing, reach; 0 where they are to follow from the noise
  /// Labels of these very points, one each; null: the points are labelled first (not for plain).
  const Features* features = nullptr;
};

/// One entry per input point, in input order, in the units of the input.
struct Smoothed {
  std::vector<Vec3> position;                    // the input point where there is no result
  std::vector<Vec3> normal;                      // unit, sign arbitrary; zero without a result
  std::vector<std::array<double, 2>> curvature;  // principal, see SurfacePoint
  std::vector<SurfaceStatus> status;
  std::vector<double> deviation;  // distance of the input point to its position; NaN without one
  std::vector<PointKind> kind;    // the labels used; all surface for plain

  double spacing = 0;          // of the cloud
  double noise = 0;            // [spacings]
  MlsOptions mls;              // as used
  std::size_t duplicates = 0;  // input points that repeat a place; they share its result
  std::size_t non_finite = 0;  // input points with NaN or infinity; they stay as they are
  double seconds_index = 0, seconds_detect = 0, seconds_project = 0;
  std::vector<std::string> warnings;

  std::size_t size() const { return position.size(); }
};

/// Throws UsageError for an option out of range or labels of another number of points,
/// NoResultError for fewer than nine different places or points that all lie on one line,
/// Cancelled. The result depends neither on the order of the points nor on the threads.
Smoothed smooth(std::span<const Vec3> points, const SmoothOptions& options = {},
                const Job& job = {});

/// Throws Error unless all arrays have one entry per point, finite where there is a result, with
/// unit normals.
void validate(const Smoothed& smoothed);

}  // namespace spigolo
