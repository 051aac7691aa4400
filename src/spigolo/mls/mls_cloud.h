// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mls/mls_cloud.h - a cloud made ready for projecting onto its surface
#pragma once

#include <span>
#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/index/kd_tree.h"
#include "spigolo/index/prepared_cloud.h"

namespace spigolo {

/// Distinct samples in canonical order, relative to `origin()`, with a search tree, the spacing at
/// each of them and the noise. Built once; all queries are const and may run on many threads. May
/// be moved, not copied.
class MlsCloud {
 public:
  /// Throws NoResultError for fewer than nine different places or points that all lie on one line.
  explicit MlsCloud(std::span<const Vec3> points, const Job& job = {});

  /// Takes what detection has prepared.
  explicit MlsCloud(PreparedCloud&& prepared);

  MlsCloud(MlsCloud&&) = default;
  MlsCloud& operator=(MlsCloud&&) = default;

  const OrderedCloud& ordered() const { return cloud_; }
  std::span<const Vec3> points() const { return cloud_.points; }
  const Vec3& origin() const { return cloud_.origin; }
  const KdTree& tree() const { return tree_; }
  double spacing() const { return spacing_.of_cloud; }  // median, in the units of the points
  double noise() const { return noise_; }               // [spacings] across the surface

  /// Mean spacing at these samples: where the density changes, lengths change with it.
  double spacing_at(std::span<const Neighbor> samples) const;

 private:
  OrderedCloud cloud_;
  KdTree tree_;  // views cloud_.points, whose memory moves along
  Spacing spacing_;
  double noise_ = 0;
};

}  // namespace spigolo
