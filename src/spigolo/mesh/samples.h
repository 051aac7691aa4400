// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/samples.h - the vertices of a mesh to be: creases sampled evenly, sheets thinned
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "spigolo/core/feature_curves.h"
#include "spigolo/core/job.h"
#include "spigolo/mesh/check.h"
#include "spigolo/mesh/surface_points.h"

namespace spigolo {

/// How long the edges of a mesh are to be, in units of the points.
struct EdgeLength {
  double step = 1;         // on flat parts and along creases
  double chord_error = 0;  // where edges of that length would leave the surface by more, they are
  double shortest = 0.5;   // shorter, down to this share of the step; 0: everywhere one length
};

/// Vertices in one canonical order: those on creases first, tips of cones after them (they count as
/// on creases, but no segment names them), then those in strips between creases (see strips.h),
/// then those on other sheets.
struct MeshSamples {
  std::vector<Vec3> position;
  std::vector<Vec3> normal;         // unit, sign arbitrary; zero on creases
  std::vector<double> length;       // edge length aimed at around each
  std::vector<VertexPair> creases;  // segments of the crease curves
  std::vector<std::int32_t> curve;  // per segment, the curve it belongs to
  std::size_t on_creases = 0;       // how many vertices come before those of the sheets
  std::size_t strips = 0;           // how many of these are in strips
  double step = 1;                  // edge length aimed at

  std::size_t size() const { return position.size(); }
  bool on_crease(std::size_t v) const { return v < on_creases; }
};

/// Tips become vertices. Creases (not borders) are cut into equal steps from corner to corner, each
/// as near to the step as can be. Of the surface points, in the order given, those are taken that
/// are not nearer than .7 edges to one taken before on the same sheet, nor than .62 steps to a
/// crease. Then gaps between them are filled with points of the continued sheets, where surface
/// points lie all around.
MeshSamples choose_samples(const SurfacePoints& surface, const FeatureCurves& network,
                           const EdgeLength& edge, const Job& job = {});

/// The creases alone: first step of choose_samples.
MeshSamples sample_creases(const FeatureCurves& network, double step);

/// Cuts crease segments in half, at the middle of their chord. which: places in creases, ascending.
void split_creases(MeshSamples& samples, std::span<const std::size_t> which);

}  // namespace spigolo
