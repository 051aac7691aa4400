// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/blend.cpp
#include "spigolo/blend/blend.h"

#include <algorithm>
#include <utility>

#include "spigolo/blend/linear.h"
#include "spigolo/blend/remove.h"
#include "spigolo/core/error.h"

namespace spigolo {
namespace {

constexpr double measured_around = 8;  // [spacings] of a collar: what its MLS surface depends on

std::vector<Vec3> shifted(std::span<const Vec3> points, const Vec3& by) {
  std::vector<Vec3> out(points.begin(), points.end());
  for (Vec3& p : out) p -= by;
  return out;
}

// Everything relative to the middle of the cloud: moving both changes nothing.
struct Scene {
  Vec3 origin;
  NurbsFace face;
  CloudSide cloud;

  Scene(std::span<const Vec3> points, const NurbsFace& given, const Job& job)
      : face(given), cloud(points, job) {
    origin = cloud.mls().origin();
    face.surface.poles = shifted(face.surface.poles, origin);
  }
};

// What the stages of either method leave.
struct Filled {
  std::vector<char> removed;            // canonical order
  std::vector<FilledPoint> points;      // relative to the origin
  std::vector<BorderLoop> loops;        // alphas and betas
  std::vector<CollarPlace> places;      // the collars as surfaces
  std::vector<Collar> collars;          // tangent only
  std::vector<std::size_t> removed_by;  // a start
};

Filled tangent_blend(const Scene& scene, std::vector<TracedStart>& traced, Setbacks& setbacks,
                     const BlendOptions& options, const Job& job) {
  Filled out;
  trace_borders(scene.cloud, setbacks, traced, job);
  out.removed.assign(scene.cloud.points().size(), 0);
  for (const TracedStart& t : traced) {
    std::vector<char> own(out.removed.size(), 0);
    remove_enclosed(scene.cloud, t.loop, own);
    out.removed_by.push_back(static_cast<std::size_t>(std::count(own.begin(), own.end(), 1)));
    for (std::size_t i = 0; i < own.size(); ++i) out.removed[i] |= own[i];
    out.collars.push_back(build_collar(t.loop));
    out.loops.push_back(t.loop);
  }
  out.points = fill_blend(scene.cloud, out.removed, traced, out.collars, options.seed, job);
  for (const Collar& collar : out.collars)
    out.places.push_back([collar](double row, double share) {
      const std::size_t n = collar.station.size();
      const auto i = std::min(static_cast<std::size_t>(row), n - 1);
      const double a = collar.station[i], b = i + 1 < n ? collar.station[i + 1] : 1.0;
      return point_at(collar.surface, a + (b - a) * (row - static_cast<double>(i)), share);
    });
  return out;
}

CollarPlace straight_place(const BorderLoop& loop) {
  return [loop](double row, double share) {
    const std::size_t n = loop.strands.size();
    const auto i = static_cast<std::size_t>(row);
    const double part = row - static_cast<double>(i);
    const Strand &a = loop.strands[i % n], &b = loop.strands[(i + 1) % n];
    const Vec3 alpha = a.alpha + (b.alpha - a.alpha) * part;
    return alpha + (a.beta + (b.beta - a.beta) * part - alpha) * share;
  };
}

Filled linear_blend(const Scene& scene, const std::vector<TracedStart>& traced,
                    const Setbacks& setbacks, const BlendOptions& options) {
  Filled out;
  out.removed.assign(scene.cloud.points().size(), 0);
  for (std::size_t i = 0; i < traced.size(); ++i) {
    std::vector<char> own(out.removed.size(), 0);
    LinearBorder border = linear_border(scene.cloud, traced[i], setbacks,
                                        static_cast<std::uint32_t>(i), options.seed + i, own);
    out.removed_by.push_back(static_cast<std::size_t>(std::count(own.begin(), own.end(), 1)));
    for (std::size_t k = 0; k < own.size(); ++k) out.removed[k] |= own[k];
    out.points.insert(out.points.end(), border.points.begin(), border.points.end());
    out.places.push_back(straight_place(border.loop));
    out.loops.push_back(std::move(border.loop));
  }
  return out;
}

// The kept samples in the order of the input, then the new points.
void assemble(const Scene& scene, std::span<const Vec3> input, const Filled& filled,
              const CloudNormals& normals, Blend& out) {
  const OrderedCloud& ordered = scene.cloud.mls().ordered();
  for (std::size_t i = 0; i < input.size(); ++i) {
    const std::uint32_t at = ordered.rank[i];
    if (at == no_point || filled.removed[at]) {
      ++(at == no_point ? out.non_finite : out.removed);
      continue;
    }
    out.points.push_back(input[i]);
    out.normals.push_back(normals.normal[at]);
    out.source.push_back(BlendSource::cloud);
    out.cloud_index.push_back(static_cast<std::uint32_t>(i));
  }
  for (const BlendSource source : {BlendSource::nurbs, BlendSource::collar})
    for (const FilledPoint& p : filled.points)
      if (p.source == source) {
        out.points.push_back(p.point + scene.origin);
        out.normals.push_back(p.normal);
        out.source.push_back(source);
      }
}

// All points of the blend near one collar, those of the collar first.
std::vector<Vec3> surroundings(const Scene& scene, const Filled& filled, std::uint32_t border,
                               std::size_t& collar_points) {
  std::vector<Vec3> points;
  for (const FilledPoint& p : filled.points)
    if (p.source == BlendSource::collar && p.border == border) points.push_back(p.point);
  collar_points = points.size();
  if (points.empty()) return points;
  const OrderedCloud own = order_cloud(points);
  const KdTree tree(own);
  std::vector<Neighbor> found;
  const double reach = measured_around * scene.cloud.spacing();
  Box box = bounding_box(points);
  const auto add_if_near = [&](const Vec3& p) {
    if (squared_distance(box, p) > reach * reach) return;
    tree.nearest(p - own.origin, 1, found);
    if (found.front().squared_distance <= reach * reach) points.push_back(p);
  };
  for (const FilledPoint& p : filled.points)
    if (p.source != BlendSource::collar || p.border != border) add_if_near(p.point);
  for (std::size_t i = 0; i < scene.cloud.points().size(); ++i)
    if (!filled.removed[i]) add_if_near(scene.cloud.points()[i]);
  return points;
}

void describe_lengths(const BorderLoop& loop, double spacing, BorderReport& report) {
  report.angle_min = report.height_min = report.width_min = infinity;
  for (const Strand& s : loop.strands) {
    report.angle_min = std::min(report.angle_min, s.angle);
    report.angle_max = std::max(report.angle_max, s.angle);
    report.height_min = std::min(report.height_min, s.height / spacing);
    report.height_max = std::max(report.height_max, s.height / spacing);
    report.width_min = std::min(report.width_min, s.width / spacing);
    report.width_max = std::max(report.width_max, s.width / spacing);
  }
}

BorderReport describe(const Scene& scene, const TracedStart& traced, const Setbacks& setbacks,
                      const Filled& filled, std::uint32_t border, const Job& job) {
  BorderReport report;
  report.start = traced.isolines.start().name;
  report.closed = traced.loop.closed;
  report.lines = traced.loop.strands.size();
  report.missed = traced.missed;
  report.patched = traced.patched;
  report.removed = filled.removed_by[border];
  describe_lengths(traced.loop, scene.cloud.spacing(), report);
  if (filled.collars.empty()) {
    report.height_min = report.height_max = setbacks.height / scene.cloud.spacing();
    report.width_min = report.width_max = setbacks.width / scene.cloud.spacing();
  }
  for (const FilledPoint& p : filled.points)
    if (p.border == border)
      ++(p.source == BlendSource::collar ? report.collar_points : report.nurbs_points);
  std::size_t collar_points = 0;
  const std::vector<Vec3> near = surroundings(scene, filled, border, collar_points);
  report.quality = measure_collar(near, collar_points, filled.loops[border], filled.places[border],
                                  scene.cloud, job);
  return report;
}

void warn(const BorderReport& report, std::size_t points, Blend& out) {
  if (report.missed > 0)
    out.warnings.push_back(std::to_string(report.missed) + " lines of the face from " +
                           report.start + " do not meet the cloud; the face is cut off there");
  if (report.patched > 0)
    out.warnings.push_back(std::to_string(report.patched) + " of " + std::to_string(report.lines) +
                           " border points on the cloud from " + report.start +
                           " had no room and were put between their neighbors");
  if (3 * report.removed > points)
    out.warnings.push_back("the face from " + report.start + " removes " +
                           std::to_string(report.removed) + " of " + std::to_string(points) +
                           " samples; --keep says which side of the cloud stays");
}

}  // namespace

Blend blend(std::span<const Vec3> cloud, const NurbsFace& face, const BlendOptions& options,
            const Job& job) {
  check_options(options);
  validate(face);
  const Scene scene(cloud, face, job);
  CloudNormals normals = find_normals(scene.cloud, job);
  const std::vector<BlendStart> starts =
      choose_starts(scene.face, scene.cloud, normals, options, job);  // 5.4.2.1
  std::vector<TracedStart> traced =
      trace_starts(scene.face, scene.cloud, starts, options, job);  // 5.4.2.2
  Setbacks setbacks = choose_setbacks(options, scene.cloud);
  const double wanted_radius = setbacks.radius;
  const Filled filled =  // 5.4.2.2 to 5.4.2.4
      options.method == BlendMethod::tangent ? tangent_blend(scene, traced, setbacks, options, job)
                                             : linear_blend(scene, traced, setbacks, options);
  point_outward(scene.cloud, filled.loops, normals);

  Blend out;
  out.spacing = scene.cloud.spacing();
  out.noise = scene.cloud.noise();
  out.smoothing = scene.cloud.smoothing();
  out.radius = setbacks.radius / out.spacing;
  assemble(scene, cloud, filled, normals, out);  // (5.2)
  for (const Collar& collar : filled.collars) {
    out.collars.push_back(collar.surface);
    out.collars.back().poles = shifted(collar.surface.poles, -scene.origin);
  }
  if (setbacks.radius < wanted_radius)
    out.warnings.push_back("for the usual radius the cloud has no room: it became " +
                           std::to_string(out.radius).substr(0, 4) + " spacings");
  for (std::uint32_t i = 0; i < traced.size(); ++i) {
    out.borders.push_back(describe(scene, traced[i], setbacks, filled, i, job));
    warn(out.borders.back(), scene.cloud.points().size(), out);
  }
  return out;
}

}  // namespace spigolo
