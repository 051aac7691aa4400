// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mls/levin.h - the classical moving least squares projection (thesis §2.3.2.2, §4.3.2)
#pragma once

#include <span>
#include <vector>

#include "spigolo/mls/mls_cloud.h"
#include "spigolo/mls/surface_point.h"

namespace spigolo {

struct MlsOptions {
  std::size_t k = 0;     // neighbors N_p of a query, at least 9; 0: by `smoothing`
  double smoothing = 0;  // [spacings] h of the weight (4.3), above 0; 0: by the noise
  double reach = 0;  // [spacings] a query farther from all samples has no result; 0: 6, or three
                     // times `smoothing` if that is more
};

/// The options with every 0 replaced: h = 1 without noise, growing by 8 times the noise up to 5; k
/// such that the weight has fallen to a twentieth at the last neighbor, at least 20. noise: in
/// spacings. Throws UsageError for a value out of range.
MlsOptions settle(const MlsOptions& options, double noise);

/// Memory of one thread; keeping it between calls avoids allocation.
struct MlsScratch {
  std::vector<Neighbor> found;
  std::vector<Vec3>
      neighbors;  // of the query, as the fit uses them, relative to the cloud's origin
  std::vector<double> distance;  // squared
  std::vector<double> weight;
};

/// Levin's projection of p with these neighbors: the plane (4.2), by weighing anew until its foot q
/// stays; the quadratic polynomial over it (4.4); its value at q. The weight is the Gaussian (4.3)
/// divided by that of the nearest neighbor, so it cannot vanish for all of them; h is at least such
/// that nine neighbors keep a ten-thousandth of the largest weight. With fewer than six neighbors
/// the surface is the plane. h: in the units of the points.
SurfacePoint project_levin(const Vec3& p, std::span<const Vec3> neighbors, double h,
                           MlsScratch& scratch);

/// Plain projection of a query in input coordinates. options: settled.
SurfacePoint project_plain(const MlsCloud& cloud, const Vec3& query, const MlsOptions& options,
                           MlsScratch& scratch);

/// First step of every method: fills scratch.found with the k nearest samples and tells the local
/// spacing, or the status that ends the projection. query: relative to the cloud's origin.
struct Surroundings {
  SurfaceStatus status = SurfaceStatus::sheet;
  double spacing = 0;  // [units of the points]
};
Surroundings look_around(const MlsCloud& cloud, const Vec3& query, const MlsOptions& options,
                         MlsScratch& scratch);

}  // namespace spigolo
