// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/stages.cpp
#include "stages.h"

#include <vector>

#include "meter.h"
#include "spigolo/core/error.h"
#include "spigolo/index/kd_tree.h"
#include "spigolo/index/noise.h"
#include "spigolo/sheets/convexity.h"
#include "spigolo/sheets/gaps.h"
#include "spigolo/sheets/local_noise.h"
#include "spigolo/sheets/meeting.h"
#include "spigolo/sheets/placed.h"
#include "spigolo/sheets/rim.h"
#include "spigolo/sheets/strength.h"
#include "spigolo/sheets/tips.h"

namespace spigolo::bench {

std::array<double, stage_names.size()> stage_seconds(std::span<const Vec3> points, const Job& job) {
  std::array<double, stage_names.size()> seconds{};
  std::size_t stage = 0;
  double last = cpu_seconds();
  const auto done = [&] {
    const double now = cpu_seconds();
    seconds[stage++] = now - last;
    last = now;
  };
  const OrderedCloud cloud = order_cloud(points, job);
  done();
  const KdTree tree(cloud);
  done();
  const SheetTolerances tolerances = sheet_tolerances(0);
  const Neighborhoods neighborhoods = find_neighborhoods(tree, tolerances.k, job);
  done();
  const Spacing spacing = estimate_spacing(cloud.points, neighborhoods, job);
  const double noise = estimate_noise(cloud.points, neighborhoods, spacing, tree, job);
  if (!sheet_tolerances(noise).exact())
    throw Error("the stages are those of a cloud without noise");
  done();
  const auto sheets = find_own_sheets(cloud.points, neighborhoods, spacing, tolerances, job);
  const SheetCloud looked{cloud.points, neighborhoods, spacing, sheets};
  is_quiet(looked, job);
  done();
  auto verdicts = judge_points(cloud.points, neighborhoods, sheets, tolerances, {}, job);
  const bool placed = is_placed(looked, verdicts, job);
  if (placed) judge_placed(looked, tolerances, {}, verdicts, job);
  if (!placed) drop_chance_rims(looked, verdicts, job);
  clean_verdicts(cloud.points, neighborhoods, spacing, tolerances, verdicts, job);
  done();
  fill_gaps(cloud.points, neighborhoods, spacing, placed, verdicts, job);
  done();
  find_tips(looked, tolerances, verdicts, job);
  count_meeting_sheets(looked, verdicts, job);
  done();
  rate_verdicts(looked, tolerances, verdicts, job);
  done();
  note_convexity(looked, tolerances, verdicts, job);
  done();
  return seconds;
}

}  // namespace spigolo::bench
