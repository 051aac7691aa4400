// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/synth.h - point clouds of constructed shapes, with the exact truth
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/core/point_cloud.h"
#include "spigolo/synth/shape.h"

namespace spigolo {

/// lattice: the shape's own regular grid, with samples on the edges. random: uniform by area. blue:
/// random with a smallest distance between samples (like a Poisson disk sampling). scan: scan
/// lines, four times denser along than across. view: what scanners at SynthOptions::views places
/// see. automatic: lattice if the shape has one, else blue.
enum class Sampling : std::uint8_t { automatic, lattice, random, blue, scan, view };

struct SynthOptions {
  std::string shape = "cube";
  Sampling sampling = Sampling::automatic;
  std::size_t points = 0;      // 0: the shape's own number; a lattice takes the nearest it can make
  double noise = 0;            // standard deviation along each axis, in spacings h (see SynthCloud)
  double noise_percent = 0;    // radius of the ball of uniform noise, in percent of Shape::radius
  std::uint64_t seed = 1;      // the same seed, the same bytes
  double angle = radians(90);  // [rad] interior angle of `wedge`, in [5, 175] degrees
  double size = 4;             // fillet radius, chamfer width, thickness of plate or slot, in mean
                               // spacings sqrt(area / points)
  std::size_t sides = 4;       // of the base of `pyramid`, 3 to 12
  std::size_t views = 1;       // scanner places of Sampling::view, 1 to 64
  double density_gradient = 1;  // random and blue: samples per area at one end of the shape's
                                // longest extent over those at the other; in [1, 1000]
  double noise_gradient = 1;    // the same for the noise, along the second longest extent; `noise`
                                // is the geometric middle; in [1, 1000]
  double duplicates = 0;        // samples that come twice, in [0, 1], a share of the samples
  double outliers = 0;          // added anywhere in the box 1.2 times as large, in [0, 1], a share
};

/// A sampled shape. The cloud carries
///   truth_feature        uint8    1: lattice: lies on a crease, corner or tip; else: its
///                                 noise-free place is within .75 h of one (h of the place, where
///                                 the density changes)
///   truth_edge_distance  float64  exact distance of the noise-free sample to the nearest crease or
///                                 tip; infinite if there is none
///   truth_kind           uint8    PointKind by the same limit; border samples are no features
///   truth_x truth_y truth_z  float64  the noise-free sample; only when there is noise
///   truth_spacing        float64  h of the place; only with a density gradient, scan or view
///   truth_outlier        uint8    1 for outliers, which are never features; only with outliers
/// With Sampling::view a crease of which one side was not seen is a border, not a feature.
/// Duplicates and then outliers stand behind the samples.
struct SynthCloud {
  PointCloud cloud;
  std::vector<Vec3> exact;  // the noise-free samples; outliers as they are
  Shape shape;
  double spacing = 0;  // h: median distance of the noise-free samples to their nearest one; scan
                       // and view: that of blue samples of the same density
  bool lattice = false;
};

/// Throws UsageError for an unknown shape, a lattice of a shape that has none, or a value out of
/// range. The same bytes for any number of threads.
SynthCloud make_cloud(const SynthOptions& options, const Job& job = {});

/// The shape alone, as make_cloud(options) would sample it.
Shape make_shape(const SynthOptions& options);

/// One shape of the catalogue.
struct ShapeInfo {
  const char* name;
  const char* help;  // one line
  bool lattice;      // has one
};
std::span<const ShapeInfo> synth_shapes();

}  // namespace spigolo
