// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mls/sharp.cpp
#include "spigolo/mls/sharp.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "spigolo/core/error.h"

namespace spigolo {
namespace {

constexpr std::size_t prepared_k = 20;  // neighbors that spacing, noise and sheets start from
constexpr int most_looks = 3;           // the weights follow the result
constexpr double settled_step = 0.02;   // [spacings]
constexpr double stray = 0.05;          // [spacings] no sample without noise is so far off
constexpr double least_h = 1.3, h_per_noise = 12, largest_h = 6;  // [spacings]
constexpr double least_reach = 6, reach_per_smoothing = 3;        // [spacings]

MlsOptions settle_sharp(const MlsOptions& given, double noise) {
  MlsOptions options = settle(given, noise);  // also says what is out of range
  if (given.smoothing == 0)
    options.smoothing = std::clamp(least_h + h_per_noise * noise, least_h, largest_h);
  if (given.k == 0) options.k = points_for(options.smoothing);
  if (given.reach == 0)
    options.reach = std::max(least_reach, reach_per_smoothing * options.smoothing);
  return options;
}

SurfaceStatus status_of(FootKind kind) {
  switch (kind) {
    case FootKind::sheet:
      return SurfaceStatus::sheet;
    case FootKind::crease:
      return SurfaceStatus::crease;
    case FootKind::corner:
      return SurfaceStatus::corner;
    case FootKind::none:
      break;
  }
  return SurfaceStatus::too_few;
}

}  // namespace

SharpSurface::SharpSurface(std::span<const Vec3> points, const MlsOptions& options, const Job& job)
    : SharpSurface(build_sheet_model(prepare_cloud(points, prepared_k, job), {}, job), options,
                   job) {}

SharpSurface::SharpSurface(SheetModel&& model, const MlsOptions& options, const Job& job)
    : model_(std::move(model)),
      tree_(model_.prepared.cloud),
      options_(settle_sharp(options, model_.prepared.noise)) {
  note_plain_places(model_, job);
  separate_places(model_, tree_, {options_.smoothing, options_.k}, job);
}

namespace {

SurfacePoint point_on(const Sheet& sheet, const Vec3& position, SurfaceStatus status) {
  SurfacePoint result;
  result.status = status;
  result.position = position;
  result.normal = normal_at(sheet, position);
  result.curvature = curvatures_at(sheet, position);
  return result;
}

// A sample without noise lies on the surface: where a look leaves it nothing near, the sheets or
// their sides are wrong, and its own sheet is not.
std::optional<SurfacePoint> stay_on_own_sheet(const SharpSurface& surface, const Vec3& x,
                                              const Vec3& found, const SheetProbe& probe) {
  const double limit = stray * probe.spacing();
  if (!surface.model().tolerances.exact() || !(distance(found, x) > limit)) return std::nullopt;
  const Sheet& own = probe.own_sheet();
  const std::optional<Vec3> foot = own.fitted() ? find_foot(own, x) : std::nullopt;
  if (!foot || distance(*foot, x) > limit) return std::nullopt;
  return point_on(own, *foot, SurfaceStatus::sheet);
}

}  // namespace

SurfacePoint project_sharp(const SharpSurface& surface, const Vec3& query, SheetProbe& probe) {
  SurfacePoint result;
  result.position = query;
  if (!is_finite(query)) return result;
  const Vec3 x = query - surface.origin();
  Vec3 center = x;
  Foot foot;
  const LocalSheets* sheets = nullptr;
  for (int look = 0; look < most_looks; ++look) {
    sheets = &probe.look(center);
    result.status = SurfaceStatus::too_far;
    if (!(probe.away() <= surface.options().reach * probe.spacing())) return result;
    foot = find_nearest_foot(*sheets, x);
    if (look == 0 && probe.away() == 0)
      if (auto stays = stay_on_own_sheet(surface, x, foot.position, probe)) {
        stays->position += surface.origin();
        return *stays;
      }
    result.status = status_of(foot.kind);
    if (foot.kind == FootKind::none) return result;
    const double step = distance(foot.position, center);
    center = foot.position;
    if (step < settled_step * probe.spacing()) break;
    if (step < probe.slack() * probe.spacing() && probe.place_at(center) == probe.place()) break;
  }
  result = point_on(sheets->sheet[foot.sheets[0]], center, result.status);
  result.position += surface.origin();
  return result;
}

std::optional<CreasePlace> find_crease_near(const SharpSurface& surface, const Vec3& query,
                                            SheetProbe& probe) {
  if (!is_finite(query)) return std::nullopt;
  std::optional<CreasePlace> place =
      find_nearest_crease(probe.look(query - surface.origin()), query - surface.origin());
  if (!place) return place;
  place->crease.point += surface.origin();
  if (place->corner) *place->corner += surface.origin();
  return place;
}

}  // namespace spigolo
