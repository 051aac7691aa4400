// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/detect/detect.cpp - order, neighbors, spacing, verdicts, back to the order of the input
#include "spigolo/detect/detect.h"

#include <cmath>
#include <string>
#include <utility>

#include "spigolo/core/error.h"
#include "spigolo/core/parallel.h"
#include "spigolo/core/stopwatch.h"
#include "spigolo/detect/methods.h"
#include "spigolo/index/prepared_cloud.h"

namespace spigolo {
namespace {

constexpr std::size_t grain = 1 << 14;

// Written so that a NaN fails it too.
void require(bool sound, const char* message) {
  if (!sound) throw UsageError(message);
}

void check(const DetectOptions& o) {
  require(o.k >= 4 && o.k <= 64, "k must be between 4 and 64 neighbors");
  require(o.sigma == from_noise || (o.sigma > 0 && o.sigma <= half_pi),
          "sigma must be above 0 and at most pi/2 = 1.5708 rad");
  require(o.flatness >= 0 && o.flatness <= 1, "flatness must be between 0 and 1");
  require(o.min_cluster == from_noise || (o.min_cluster >= 0 && o.min_cluster <= 0.5),
          "min-cluster must be between 0 and 0.5");
  require(o.sensitivity >= 0 && o.sensitivity <= 1, "sensitivity must be between 0 and 1");
}

PlaceFeatures rows_of_all(Features features) {
  PlaceFeatures all{std::vector<std::uint32_t>(features.size(), no_point), std::move(features)};
  for (std::uint32_t i = 0; i < all.row.size(); ++i)
    if (all.features.kind[i] != PointKind::surface) all.row[i] = i;
  return all;
}

Features in_input_order(const OrderedCloud& cloud, std::span<const Vec3> points,
                        const PlaceFeatures& found, const Job& job) {
  const Features& of_places = found.features;
  Features features;
  features.assign_surface(points.size());
  const auto copy = [&](std::size_t i) {
    const std::uint32_t r = cloud.rank[i];
    const std::uint32_t row = r == no_point ? no_point : found.row[r];
    if (row == no_point) return;
    features.kind[i] = of_places.kind[row];
    features.angle[i] = of_places.angle[row];
    features.strength[i] = of_places.strength[row];
    features.convex[i] = of_places.convex[row];
    features.direction[i] = of_places.direction[row];
    features.sheets[i] = of_places.sheets[row];
    // A crease through the very point keeps its coordinates to the last bit.
    const Vec3& crease = of_places.crease_point[row];
    features.crease_point[i] = crease == cloud.points[r] ? points[i] : crease + cloud.origin;
  };
  parallel_for(job, "", points.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) copy(i);
  });
  return features;
}

void warn(const OrderedCloud& cloud, Detection& result) {
  const auto say = [&](std::string text) { result.warnings.push_back(std::move(text)); };
  if (cloud.non_finite > 0)
    say(std::to_string(cloud.non_finite) +
        " points have a NaN or infinite coordinate; labelled surface");
  if (cloud.duplicates > 0)
    say(std::to_string(cloud.duplicates) +
        " points repeat the place of another; they share its label");
  if (result.degenerate > 0)
    say(std::to_string(result.degenerate) +
        " places have all their neighbors on one line; labelled surface");
}

// What the sheets cannot see at this noise: measured on wedges (docs/results.md).
void warn_of_noise(Detection& result) {
  constexpr double noticeable = 0.15, too_much = 0.4;  // [spacings]
  constexpr double hidden_degrees = 150;               // of bend, per spacing of noise
  if (result.noise < noticeable) return;
  const auto percent = std::to_string(static_cast<int>(std::lround(100 * result.noise)));
  const auto hidden = std::to_string(static_cast<int>(std::lround(hidden_degrees * result.noise)));
  result.warnings.push_back(
      result.noise < too_much
          ? "noise of " + percent + " % of the spacing hides edges bent by less than about " +
                hidden + " degrees"
          : "noise of " + percent +
                " % of the spacing is beyond what edges can be told from: many are missed, some "
                "are chance; scan more densely or average several scans");
}

}  // namespace

Detection detect(std::span<const Vec3> points, const DetectOptions& options, const Job& job) {
  check(options);
  Stopwatch watch;
  PreparedCloud prepared = prepare_cloud(points, options.k, job);
  Detection result;
  result.duplicates = prepared.cloud.duplicates;
  result.non_finite = prepared.cloud.non_finite;
  result.spacing = prepared.spacing.of_cloud;
  result.noise = prepared.noise;
  result.seconds_index = watch.lap();
  const PlaceFeatures found =
      options.method == DetectMethod::sheets
          ? features_by_sheets(prepared, options, job, result)
          : rows_of_all(features_by_gauss_map(prepared, options, job, result));
  prepared.neighborhoods = {};  // before the labels take their room
  result.features = in_input_order(prepared.cloud, points, found, job);
  warn(prepared.cloud, result);
  warn_of_noise(result);
  result.seconds_detect = watch.lap();
  return result;
}

}  // namespace spigolo
