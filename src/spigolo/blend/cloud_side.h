// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/cloud_side.h - the scanned surface P: samples, neighbors, its MLS surface
#pragma once

#include <span>

#include "spigolo/core/job.h"
#include "spigolo/index/neighborhoods.h"
#include "spigolo/mls/levin.h"
#include "spigolo/mls/mls_cloud.h"

namespace spigolo {

/// Points are given and answered in the coordinates of the cloud, near its origin.
class CloudSide {
 public:
  explicit CloudSide(std::span<const Vec3> points, const Job& job = {});

  double spacing() const { return cloud_.spacing(); }               // d [units of the points]
  double noise() const { return cloud_.noise(); }                   // [spacings]
  double smoothing() const { return options_.smoothing; }           // [spacings] h of the weight
  std::span<const Vec3> points() const { return cloud_.points(); }  // canonical order
  const KdTree& tree() const { return cloud_.tree(); }
  const MlsCloud& mls() const { return cloud_; }
  const MlsOptions& options() const { return options_; }
  std::span<const std::uint32_t> neighbors(std::size_t i) const { return neighborhoods_.of(i); }
  const Neighborhoods& neighborhoods() const { return neighborhoods_; }

  /// Distance to the nearest sample.
  double sample_distance(const Vec3& p, MlsScratch& scratch) const;
  /// Foot on the MLS surface, relative to the cloud's origin, as everything here is.
  SurfacePoint project(const Vec3& p, MlsScratch& scratch) const;

 private:
  explicit CloudSide(PreparedCloud&& prepared);

  Neighborhoods neighborhoods_;
  MlsCloud cloud_;
  MlsOptions options_;
};

}  // namespace spigolo
