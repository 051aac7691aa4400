// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/sheet_model.cpp
#include "spigolo/sheets/sheet_model.h"

#include <algorithm>
#include <utility>

#include "spigolo/core/parallel.h"
#include "spigolo/sheets/agree.h"
#include "spigolo/sheets/chains.h"
#include "spigolo/sheets/convexity.h"
#include "spigolo/sheets/folds.h"
#include "spigolo/sheets/gaps.h"
#include "spigolo/sheets/joints.h"
#include "spigolo/sheets/local_noise.h"
#include "spigolo/sheets/meeting.h"
#include "spigolo/sheets/passing.h"
#include "spigolo/sheets/placed.h"
#include "spigolo/sheets/refine.h"
#include "spigolo/sheets/rim.h"
#include "spigolo/sheets/strength.h"
#include "spigolo/sheets/tips.h"

namespace spigolo {
namespace {

constexpr std::size_t grain = 1024;
constexpr int plain_rounds = 2;  // neighborhoods of neighborhoods: as far as any later fit looks

}  // namespace

// Points whose neighbors, and theirs, know of one sheet only.
void note_plain_places(SheetModel& model, const Job& job) {
  std::vector<char> plain(model.size()), next(model.size());
  for (std::size_t i = 0; i < plain.size(); ++i)
    plain[i] = model.verdicts[i].kind == PointKind::surface && model.own[i].whole;
  for (int round = 0; round < plain_rounds; ++round) {
    parallel_for(job, "", plain.size(), grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const auto row = model.prepared.neighborhoods.of(i);
        next[i] = plain[i] && std::all_of(row.begin(), row.end(),
                                          [&](std::uint32_t j) { return plain[j] != 0; });
      }
    });
    plain.swap(next);
  }
  model.plain = std::move(plain);
}

namespace {

// Own sheets and first verdicts of all points, as if this were the noise everywhere.
void judge_all(SheetModel& model, const SheetOptions& options, const Job& job) {
  const PreparedCloud& p = model.prepared;
  const std::span<const Vec3> points = p.cloud.points;
  const double noise = model.tolerances.noise;
  const bool exact = model.tolerances.exact();
  model.verdicts = judge_points(points, p.neighborhoods, model.own, model.tolerances, options, job);
  const auto agree = [&] {
    model.verdicts = agree_on_creases(points, p.neighborhoods, p.spacing, model.verdicts, job);
  };
  const auto keep = [&](const SamplePlaces& places) {
    model.verdicts = drop_passed_by(points, p.spacing, places, noise, model.verdicts, job);
  };
  if (!exact) {
    propose_folds(model, options, job);
    agree();
    keep({});
    refine_creases(model, options, job);
    agree();
    const SamplePlaces places =
        find_sample_places(points, p.neighborhoods, p.spacing, model.verdicts, noise);
    keep({.near = places.near});
    drop_short_chains(points, p.neighborhoods, p.spacing, noise, model.verdicts, job);
    if (places.on_creases) keep(places);
    join_creases(points, p.neighborhoods, p.spacing, model.verdicts, job);
  }
  const SheetCloud cloud{points, p.neighborhoods, p.spacing, model.own};
  const bool placed = exact && is_placed(cloud, model.verdicts, job);
  if (placed) judge_placed(cloud, model.tolerances, options, model.verdicts, job);
  if (exact && !placed) drop_chance_rims(cloud, model.verdicts, job);
  clean_verdicts(points, p.neighborhoods, p.spacing, model.tolerances, model.verdicts, job);
  if (exact) fill_gaps(points, p.neighborhoods, p.spacing, placed, model.verdicts, job);
}

void find_sheets(SheetModel& model, double noise, const Job& job) {
  model.tolerances = sheet_tolerances(noise, model.prepared.spacing.on_lines);
  widen_neighborhoods(model.prepared, model.tolerances.k, job);
  const PreparedCloud& p = model.prepared;
  model.own = find_own_sheets(p.cloud.points, p.neighborhoods, p.spacing, model.tolerances, job);
}

// Noise that differs over the cloud: each level judges all points, each point takes the verdict
// of the level its own noise is nearest to.
void judge_by_levels(SheetModel& model, const std::vector<double>& local,
                     const std::vector<double>& levels, const SheetOptions& options,
                     const Job& job) {
  std::vector<Sheet> own(model.size());
  VerdictRows verdicts(model.size());
  for (std::size_t level = 0; level < levels.size(); ++level) {
    find_sheets(model, levels[level], job);
    judge_all(model, options, job);
    for (std::size_t i = 0; i < model.size(); ++i) {
      if (nearest_level(levels, local[i]) != level) continue;
      own[i] = model.own[i];
      verdicts.set(i, model.verdicts[i]);
    }
  }
  model.own = std::move(own);
  model.verdicts = std::move(verdicts);
  model.tolerances = sheet_tolerances(model.prepared.noise, model.prepared.spacing.on_lines);
}

}  // namespace

SheetModel build_sheet_model(PreparedCloud prepared, const SheetOptions& options, const Job& job) {
  SheetModel model;
  model.prepared = std::move(prepared);
  find_sheets(model, model.prepared.noise, job);
  const auto cloud = [&]() -> SheetCloud {
    const PreparedCloud& p = model.prepared;
    return {p.cloud.points, p.neighborhoods, p.spacing, model.own};
  };
  std::vector<double> local, levels(1, model.prepared.noise);
  if (!is_quiet(cloud(), job)) {
    local = estimate_local_noise(cloud(), job);
    levels = noise_levels(local, model.prepared.noise);
  }
  if (levels.size() == 1)
    judge_all(model, options, job);
  else
    judge_by_levels(model, local, levels, options, job);
  find_tips(cloud(), model.tolerances, model.verdicts, job);
  if (model.tolerances.exact()) count_meeting_sheets(cloud(), model.verdicts, job);
  rate_verdicts(cloud(), model.tolerances, model.verdicts, job);
  note_convexity(cloud(), model.tolerances, model.verdicts, job);
  return model;
}

}  // namespace spigolo
