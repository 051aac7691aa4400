// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/projection_options.h - how points come onto their surface: what smooth and mesh ask alike
#pragma once

#include <optional>
#include <string>

#include "command_line.h"
#include "run.h"
#include "spigolo/core/features.h"
#include "spigolo/core/point_cloud.h"
#include "spigolo/pipeline/smooth.h"

namespace spigolo {

struct ProjectionChoice {
  std::string method = "sheets";
  std::string features;  // file; empty: points are labelled first

  SmoothMethod smooth_method() const;
};

void declare_method(CommandLine& line, ProjectionChoice& choice);
/// --k and --smoothing, by the noise where they are not given.
void declare_smoothing(CommandLine& line, MlsOptions& mls);
void declare_features(CommandLine& line, ProjectionChoice& choice);

/// The labels of that file, which must be of these points; none if no file was named.
std::optional<Features> read_labels(const ProjectionChoice& choice, const PointCloud& cloud,
                                    Run& run);

}  // namespace spigolo
