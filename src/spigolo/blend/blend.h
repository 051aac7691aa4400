// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/blend.h - one cloud out of a scan and a NURBS face (thesis chapter 5)
#pragma once

#include <span>
#include <string>
#include <vector>

#include "spigolo/blend/fill.h"
#include "spigolo/blend/measure.h"
#include "spigolo/blend/options.h"
#include "spigolo/core/job.h"

namespace spigolo {

/// What became of one start.
struct BorderReport {
  std::string start;
  bool closed = false;
  std::size_t lines = 0, missed = 0;      // isolines with a crossing; without one
  std::size_t patched = 0;                // betas put between their neighbors
  double angle_min = 0, angle_max = 0;    // [rad] between face and cloud, on the free side
  double height_min = 0, height_max = 0;  // [spacings] of the collar along the face
  double width_min = 0, width_max = 0;    // along the cloud
  std::size_t removed = 0;                // samples of the cloud
  std::size_t nurbs_points = 0, collar_points = 0;
  CollarQuality quality;
};

struct Blend {
  // G of (5.2): the kept samples of the cloud, unchanged and in their order; then face, then
  // collar.
  std::vector<Vec3> points;   // in the coordinates of the input
  std::vector<Vec3> normals;  // unit, to the side that the face comes from
  std::vector<BlendSource> source;
  std::vector<std::uint32_t> cloud_index;  // of the kept samples: number in the input
  std::size_t removed = 0;                 // input points that went, repeats of a place too
  std::size_t non_finite = 0;              // input points that are no places
  std::vector<NurbsSurface> collars;       // one a start; only of the method `tangent`
  std::vector<BorderReport> borders;
  double spacing = 0;    // of the cloud, in the units of the input
  double noise = 0;      // [spacings]
  double radius = 0;     // [spacings] used; 0 with height and width
  double smoothing = 0;  // [spacings] h of the MLS surface that was used
  std::vector<std::string> warnings;
};

/// Steps 5.4.2.1 to 5.4.2.4; G is what step 5.4.2.5 takes. cloud and face are in the same unit. The
/// same result for any number of threads and any order of the points. Throws UsageError for
/// options out of range; NoResultError, saying what stands in the way: see the stages; Cancelled.
Blend blend(std::span<const Vec3> cloud, const NurbsFace& face, const BlendOptions& options = {},
            const Job& job = {});

}  // namespace spigolo
