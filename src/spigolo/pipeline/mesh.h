// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/pipeline/mesh.h - from a raw cloud to a sharp triangle mesh
#pragma once

#include <span>
#include <string>
#include <vector>

#include "spigolo/core/feature_curves.h"
#include "spigolo/core/features.h"
#include "spigolo/mesh/mesher.h"
#include "spigolo/mls/levin.h"
#include "spigolo/pipeline/smooth.h"

namespace spigolo {

struct MeshOptions {
  SmoothMethod method = SmoothMethod::sheets;  // how points come onto the surface; plain has no
                                               // creases
  MlsOptions mls;                              // 0 where a value is to follow from the noise
  double sensitivity = 0.5;                    // of the features, see DetectOptions
  /// Labels of these very points, one each; null: they are found.
  const Features* features = nullptr;
  /// The creases; null: they are found.
  const FeatureCurves* network = nullptr;
  MesherOptions mesher;
};

struct MeshedCloud {
  SharpMesh sharp;
  FeatureCurves network;                                     // the creases it was built on
  double spacing = 0;                                        // of the cloud
  double noise = 0;                                          // [spacings]
  std::size_t duplicates = 0, non_finite = 0, outliers = 0;  // input points left out
  double seconds_index = 0, seconds_detect = 0, seconds_lines = 0, seconds_project = 0,
         seconds_mesh = 0;
  std::vector<std::string> warnings;
};

/// Throws UsageError for an option out of range, NoResultError if the points span no surface or no
/// mesh of them passes its own check, Cancelled. The result depends neither on the order of the
/// points nor on the threads.
MeshedCloud mesh_cloud(std::span<const Vec3> points, const MeshOptions& options = {},
                       const Job& job = {});

}  // namespace spigolo
