// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/refine.cpp
#include "spigolo/sheets/refine.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "spigolo/core/parallel.h"
#include "spigolo/index/row_search.h"
#include "spigolo/sheets/sheet_probe.h"

namespace spigolo {
namespace {

constexpr std::size_t grain = 64;
constexpr std::size_t together = 8;  // candidates that seek their neighbors at once
constexpr double reach = 2.5;        // [spacings] a crease this close is a proposal
constexpr double little = 0.3;       // [spacings] of noise: wider fits know the place better
constexpr double one_sheet = 1.25;  // [standard deviations] a single sheet that fits so well is all
constexpr double corner_reach = 0.9;  // [spacings]
constexpr std::size_t asked = 8;      // neighbors that make a point a candidate

bool sharp(const SheetVerdict& v) {
  return v.kind == PointKind::edge || v.kind == PointKind::corner;
}

// Folds know the place of their creases as well as wider fits do, unless the noise is small.
bool asks(const SheetVerdict& v, double noise) {
  return sharp(v) && (v.folded == 0 || noise < little);
}

// Points beside a crease that the first look saw.
std::vector<std::uint32_t> candidates(const SheetModel& model) {
  const double noise = model.tolerances.noise;
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < model.size(); ++i) {
    const auto row = model.prepared.neighborhoods.of(i);
    const auto near = row.first(std::min(asked, row.size()));
    if (model.verdicts[i].folded > 0 && !asks(model.verdicts[i], noise)) continue;
    if (asks(model.verdicts[i], noise) ||
        std::any_of(near.begin(), near.end(),
                    [&](std::uint32_t j) { return asks(model.verdicts[j], noise); }))
      found.push_back(i);
  }
  return found;
}

SheetVerdict verdict_by(const CreasePlace& place, const Vec3& p, double spacing) {
  SheetVerdict verdict;
  const double away = distance(place.crease.point, p) / spacing;
  if (place.corner && distance(*place.corner, p) < corner_reach * spacing) {
    verdict.kind = PointKind::corner;
    verdict.crease_point = *place.corner;
    verdict.sheets = 3;
  } else if (away <= reach) {
    verdict.kind = PointKind::edge;
    verdict.crease_point = place.crease.point;
    verdict.direction = place.crease.direction;
    verdict.into = place.into;
    verdict.sheets = 2;
  } else {
    return verdict;
  }
  verdict.deviation = place.deviation;
  verdict.strength = std::clamp(1 - 0.5 * away / reach, 0.01, 1.0);
  return verdict;
}

SheetVerdict refine(const SheetModel& model, std::uint32_t i, const SheetOptions& options,
                    const LocalSheets& sheets) {
  if (model.verdicts[i].folded == 0 && sheets.count == 1 &&
      sheets.sheet[0].deviation < one_sheet * model.tolerances.noise)
    return {};
  const Vec3& p = model.points()[i];
  SheetVerdict refined;
  const auto place = find_nearest_crease(sheets, p);
  if (place && place->deviation >= least_deviation(options.sensitivity))
    refined = verdict_by(*place, p, model.prepared.spacing.of_point[i]);
  return refined.kind == PointKind::surface ? model.verdicts[i] : refined;
}

}  // namespace

void refine_creases(SheetModel& model, const SheetOptions& options, const Job& job) {
  const KdTree tree(model.prepared.cloud);
  const ProbeReach probed = probe_reach(model.tolerances.noise);
  const std::size_t k = std::min(probed.k, model.size()) - 1;
  const std::vector<std::uint32_t> near = candidates(model);
  std::vector<SheetVerdict> refined(near.size());
  parallel_for(job, "creases", near.size(), grain, [&](std::size_t begin, std::size_t end) {
    SheetProbe probe(model, tree, probed);
    RowSearch search(tree, k);
    std::vector<std::uint32_t> rows(together * k);
    for (; begin < end; begin += together) {
      const auto some = std::span(near).subspan(begin, std::min(together, end - begin));
      search.find(some, rows.data());
      for (std::size_t c = 0; c < some.size(); ++c)
        refined[begin + c] = refine(model, some[c], options,
                                    probe.look_at(some[c], std::span(rows).subspan(c * k, k)));
    }
  });
  for (std::size_t c = 0; c < near.size(); ++c) model.verdicts.set(near[c], refined[c]);
}

}  // namespace spigolo
