// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/projection_options.cpp
#include "projection_options.h"

#include "feature_cloud.h"
#include "files.h"

namespace spigolo {
namespace {

// "auto" stands for 0: from the noise.
CLI::Option* by_noise(CLI::Option* option) {
  return option->default_str("auto")->transform(
      [](const std::string& text) { return text == "auto" ? "0" : text; });
}

}  // namespace

SmoothMethod ProjectionChoice::smooth_method() const {
  if (method == "sheets") return SmoothMethod::sheets;
  return method == "plain" ? SmoothMethod::plain : SmoothMethod::feature_line;
}

void declare_method(CommandLine& line, ProjectionChoice& choice) {
  line.parameter("--method", choice.method, "sheets, feature-line (thesis) or plain (rounds edges)")
      ->check(CLI::IsMember({"sheets", "feature-line", "plain"}))
      ->type_name("NAME");
}

void declare_smoothing(CommandLine& line, MlsOptions& mls) {
  by_noise(line.parameter("--k", mls.k, "neighbors of a point, at least 9"))->type_name("N");
  by_noise(line.parameter("--smoothing", mls.smoothing,
                          "h of the weight, in spacings; larger smooths more"))
      ->type_name("H");
}

void declare_features(CommandLine& line, ProjectionChoice& choice) {
  line.app()
      .add_option("--features", choice.features, "labels of these points, as detect writes them")
      ->type_name("FILE.ply");
}

std::optional<Features> read_labels(const ProjectionChoice& choice, const PointCloud& cloud,
                                    Run& run) {
  if (choice.features.empty()) return std::nullopt;
  if (choice.smooth_method() == SmoothMethod::plain)
    run.warn("--features has no effect with --method plain");
  ReadReport seen;
  const PointCloud labels = read_points(choice.features, run, seen);
  warn(seen, choice.features, run);
  return features_of(labels, cloud, choice.features);
}

}  // namespace spigolo
