// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/pipeline/smooth.cpp - order and neighbors, labels, projection of every place, back to the
// order of the input
#include "spigolo/pipeline/smooth.h"

#include <functional>
#include <utility>

#include "spigolo/core/error.h"
#include "spigolo/core/parallel.h"
#include "spigolo/core/stopwatch.h"
#include "spigolo/detect/methods.h"
#include "spigolo/mls/sharp.h"
#include "spigolo/mls/sharp_neighborhood.h"

namespace spigolo {
namespace {

constexpr std::size_t grain = 256;
constexpr std::size_t prepared_k = 20;  // neighbors that spacing, noise and labels start from

// The labels of the places in canonical order: given ones, or found ones.
std::vector<PointKind> labels_of(PreparedCloud& prepared, const SmoothOptions& options,
                                 const Job& job, std::vector<std::string>& warnings) {
  if (options.method == SmoothMethod::plain) return {};
  if (options.features == nullptr) {
    Detection detection;
    const PlaceFeatures found = features_by_sheets(prepared, {}, job, detection);
    warnings.insert(warnings.end(), detection.warnings.begin(), detection.warnings.end());
    std::vector<PointKind> kind(found.row.size(), PointKind::surface);
    for (std::size_t i = 0; i < kind.size(); ++i)
      if (found.row[i] != no_point) kind[i] = found.features.kind[found.row[i]];
    return kind;
  }
  return ordered_kinds(prepared.cloud, options.features->kind);
}

// Projects every place of the cloud with a function that each thread makes for itself.
using Projection = std::function<SurfacePoint(const Vec3& query)>;
std::vector<SurfacePoint> project_all(const OrderedCloud& cloud, const Job& job,
                                      const std::function<Projection()>& make_projection) {
  std::vector<SurfacePoint> result(cloud.size());
  parallel_for(job, "projection", result.size(), grain, [&](std::size_t begin, std::size_t end) {
    const Projection project = make_projection();
    for (std::size_t i = begin; i < end; ++i) result[i] = project(cloud.points[i] + cloud.origin);
  });
  return result;
}

std::vector<SurfacePoint> project_by(SmoothMethod method, const MlsCloud& cloud,
                                     std::span<const PointKind> kind, const MlsOptions& mls,
                                     const Job& job) {
  if (method == SmoothMethod::plain)
    return project_all(cloud.ordered(), job, [&] {
      return [&, scratch = MlsScratch()](const Vec3& q) mutable {
        return project_plain(cloud, q, mls, scratch);
      };
    });
  FeatureLineOptions options;
  options.mls = mls;
  const FeatureMap features = map_features(cloud, kind, mls.k, job);
  return project_all(cloud.ordered(), job, [&] {
    return [&, scratch = FeatureLineScratch()](const Vec3& q) mutable {
      return project_feature_line(cloud, features, q, options, scratch);
    };
  });
}

void in_input_order(std::span<const Vec3> points, const OrderedCloud& cloud,
                    std::span<const SurfacePoint> found, std::span<const PointKind> kind,
                    Smoothed& s) {
  const std::size_t n = points.size();
  s.position.assign(points.begin(), points.end());
  s.normal.assign(n, {});
  s.curvature.assign(n, {});
  s.status.assign(n, SurfaceStatus::degenerate);
  s.deviation.assign(n, not_a_number);
  s.kind.assign(n, PointKind::surface);
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t r = cloud.rank[i];
    if (r == no_point) continue;
    if (!kind.empty()) s.kind[i] = kind[r];
    s.status[i] = found[r].status;
    if (!on_surface(found[r].status)) continue;
    s.position[i] = found[r].position;
    s.normal[i] = found[r].normal;
    s.curvature[i] = found[r].curvature;
    s.deviation[i] = distance(points[i], s.position[i]);
  }
}

void warn(Smoothed& s) {
  const auto say = [&](std::size_t n, const char* text) {
    if (n > 0) s.warnings.push_back(std::to_string(n) + text);
  };
  std::size_t lost = 0;
  for (const SurfaceStatus status : s.status) lost += !on_surface(status);
  say(s.non_finite, " points have a NaN or infinite coordinate; they stay as they are");
  say(s.duplicates, " points repeat the place of another; they share its result");
  say(lost - s.non_finite, " points have no surface near them; they stay as they are");
}

}  // namespace

namespace {

// The thesis's two methods.
void smooth_by_neighbors(std::span<const Vec3> points, PreparedCloud&& prepared,
                         const SmoothOptions& options, const Job& job, Smoothed& s) {
  Stopwatch watch;
  const std::vector<PointKind> kind = labels_of(prepared, options, job, s.warnings);
  s.seconds_detect = watch.lap();
  const MlsCloud cloud(std::move(prepared));
  s.mls = settle(options.mls, s.noise);
  const std::vector<SurfacePoint> found = project_by(options.method, cloud, kind, s.mls, job);
  in_input_order(points, cloud.ordered(), found, kind, s);
  s.seconds_project = watch.lap();
}

// Given labels replace our own: their kinds and, where they have them, places on the creases.
void give_labels(const Features& features, SheetModel& model) {
  const OrderedCloud& cloud = model.prepared.cloud;
  model.labels_given = true;
  for (std::size_t i = 0; i < features.size(); ++i) {
    if (cloud.rank[i] == no_point) continue;
    SheetVerdict verdict = model.verdicts[cloud.rank[i]];
    verdict.kind = features.kind[i];
    verdict.strength = static_cast<double>(features.strength[i]);
    verdict.direction = {};  // not known: pins nothing
    if (features.kind[i] == PointKind::edge && is_finite(features.crease_point[i])) {
      verdict.crease_point = features.crease_point[i] - cloud.origin;
      verdict.direction = features.direction[i];
    }
    model.verdicts.set(cloud.rank[i], verdict);
  }
}

void smooth_by_sheets(std::span<const Vec3> points, PreparedCloud&& prepared,
                      const SmoothOptions& options, const Job& job, Smoothed& s) {
  Stopwatch watch;
  SheetModel model = build_sheet_model(std::move(prepared), {}, job);
  if (options.features != nullptr) give_labels(*options.features, model);
  std::vector<PointKind> kind(model.size());
  for (std::size_t i = 0; i < kind.size(); ++i) kind[i] = model.verdicts[i].kind;
  s.seconds_detect = watch.lap();
  const SharpSurface surface(std::move(model), options.mls, job);
  s.mls = surface.options();
  const OrderedCloud& cloud = surface.model().prepared.cloud;
  const std::vector<SurfacePoint> found = project_all(cloud, job, [&] {
    return [&, probe = surface.probe()](const Vec3& q) mutable {
      return project_sharp(surface, q, probe);
    };
  });
  in_input_order(points, cloud, found, kind, s);
  s.seconds_project = watch.lap();
}

}  // namespace

Smoothed smooth(std::span<const Vec3> points, const SmoothOptions& options, const Job& job) {
  settle(options.mls, 0);  // what is out of range is told before the work begins
  if (options.features != nullptr && options.features->size() != points.size())
    throw UsageError("there are labels for " + std::to_string(options.features->size()) +
                     " points, but the cloud has " + std::to_string(points.size()) +
                     "; labels must be of these very points");
  Stopwatch watch;
  PreparedCloud prepared = prepare_cloud(points, prepared_k, job);
  Smoothed s;
  s.spacing = prepared.spacing.of_cloud, s.noise = prepared.noise;
  s.duplicates = prepared.cloud.duplicates, s.non_finite = prepared.cloud.non_finite;
  s.seconds_index = watch.lap();
  (options.method == SmoothMethod::sheets ? smooth_by_sheets : smooth_by_neighbors)(
      points, std::move(prepared), options, job, s);
  warn(s);
  return s;
}

void validate(const Smoothed& s) {
  const std::size_t n = s.size();
  if (s.normal.size() != n || s.curvature.size() != n || s.status.size() != n ||
      s.deviation.size() != n || s.kind.size() != n)
    throw Error("smoothed cloud: the arrays differ in length");
  for (std::size_t i = 0; i < n; ++i) {
    if (!on_surface(s.status[i])) continue;
    const bool sound = is_finite(s.position[i]) && std::abs(norm(s.normal[i]) - 1) < 1e-6 &&
                       std::isfinite(s.curvature[i][0]) && std::isfinite(s.curvature[i][1]) &&
                       s.deviation[i] >= 0;
    if (!sound)
      throw Error("smoothed cloud: the entry of point " + std::to_string(i) + " is not sound");
  }
}

}  // namespace spigolo
