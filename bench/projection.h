// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/projection.h - the projections onto the surface, and how far from the truth they end
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "spigolo/core/features.h"
#include "spigolo/mls/levin.h"
#include "spigolo/synth/synth.h"

namespace spigolo::bench {

/// Projects a query in input coordinates; one thread at a time.
using Projection = std::function<SurfacePoint(const Vec3& query)>;

struct ProjectionMethod {
  const char* name;
  /// The cloud must outlive the projection. kind: labels of the input points; smoothing 0: default.
  std::function<Projection(const MlsCloud& cloud, std::span<const PointKind> kind,
                           const MlsOptions& options)>
      make;
};
const std::vector<ProjectionMethod>& projection_methods();
const ProjectionMethod& projection_method(const std::string& name);

/// A shape with noise in mean spacings sqrt(area / points), the unit of everything measured here.
struct Specimen {
  std::string name;
  SynthCloud synth;
  double spacing = 0;
  double noise = 0;             // [spacings] along each axis
  std::vector<PointKind> kind;  // as our own detection has them
};
/// options.noise: in mean spacings too.
Specimen make_specimen(std::string name, SynthOptions options);

/// In spacings and degrees, against the exact surface. Queries are surface points moved by up to .3
/// spacings along the normal; near: within 3 spacings of an edge. Nothing is measured closer than 3
/// spacings to a border. Zero where the shape has no place to measure.
struct ProjectionQuality {
  double rms = 0, rms_near = 0, max_near = 0;
  double gap = 0, gap_max = 0;  // of the true edge to the nearest projected point
  double normal_error = 0;      // mean, of places .1 to 1.5 spacings from an edge
  double corner = 0;            // mean distance of a true corner to the nearest projected point
  double smooth_rms = 0;        // of the samples themselves, 6 spacings and more from any edge
  double again = 0;             // 99 of 100 move less when they are projected a second time
  double lost = 0;              // share of queries without a result
};
ProjectionQuality measure_projection(const Specimen& specimen, const Projection& project,
                                     std::size_t queries = 6000);

}  // namespace spigolo::bench
