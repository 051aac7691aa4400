// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/chapter5.cpp - blends of the thesis and harder ones, by its collar and by the tangent one
#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

#include "blend_meshes.h"
#include "blend_pictures.h"
#include "blend_scenes.h"
#include "sections.h"
#include "spigolo/cad/nurbs_shapes.h"
#include "spigolo/core/error.h"
#include "spigolo/mls/levin.h"
#include "spigolo/mls/mls_cloud.h"

namespace spigolo::bench {
namespace {

using Row = std::vector<std::string>;

std::string pair_of(const MeanMax& value) {
  return number(degrees(value.mean), 1) + " / " + number(degrees(value.max), 1);
}

struct Removal {
  std::size_t missed = 0, wrong = 0;  // enclosed and kept; removed beyond the collar
};

Removal check_removal(const BlendScene& scene, const Blend& blend) {
  std::vector<char> kept(scene.cloud.size(), 0);
  for (const std::uint32_t i : blend.cloud_index) kept[i] = 1;
  double width = 0;
  for (const BorderReport& b : blend.borders) width = std::max(width, b.width_max * blend.spacing);
  Removal removal;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const double outside = scene.enclosed(scene.cloud[i]);
    removal.missed += kept[i] && outside < 0;
    removal.wrong += !kept[i] && outside > width + 1e-6 * blend.spacing;
  }
  return removal;
}

// How much the MLS surface moves by the collar, 2 to 6 spacings away from it, in spacings: on the
// cloud from its own MLS surface, on the face from the face.
struct Moved {
  double cloud = 0, face = 0;
};

Moved check_moved(const BlendScene& scene, const Blend& blend) {
  std::vector<Vec3> collar;
  for (std::size_t i = 0; i < blend.points.size(); ++i)
    if (blend.source[i] == BlendSource::collar) collar.push_back(blend.points[i]);
  const OrderedCloud ordered = order_cloud(collar);
  const KdTree tree(ordered);
  const MlsCloud before(scene.cloud), after(blend.points);
  const MlsOptions options = settle({}, before.noise());
  std::vector<Neighbor> found;
  MlsScratch scratch;
  Moved moved;
  for (std::size_t i = 0; i < blend.points.size(); ++i) {
    const Vec3& p = blend.points[i];
    tree.nearest(p - ordered.origin, 1, found);
    const double away = std::sqrt(found.front().squared_distance) / blend.spacing;
    if (away < 2 || away > 6 || blend.source[i] == BlendSource::collar) continue;
    const SurfacePoint now = project_plain(after, p, options, scratch);
    const bool on_cloud = blend.source[i] == BlendSource::cloud;
    const Vec3 was = on_cloud ? project_plain(before, p, options, scratch).position : p;
    double& most = on_cloud ? moved.cloud : moved.face;
    most = std::max(most, distance(now.position, was) / blend.spacing);
  }
  return moved;
}

Row failed(const BlendScene& scene, const char* method, const std::string& why) {
  Row row = {scene.name, method, why};
  row.resize(14);
  return row;
}

// One row a border.
std::vector<Row> rows_of(const BlendScene& scene, BlendMethod method) {
  const char* name = method == BlendMethod::tangent ? "tangent" : "linear";
  Blend result;
  try {
    result = blend(scene.cloud, scene.face, options_of(scene, method));
  } catch (const NoResultError& error) {
    return {failed(scene, name, std::string("refused: ") + error.what())};
  }
  const Moved moved = check_moved(scene, result);
  Removal removal;
  if (scene.enclosed) removal = check_removal(scene, result);
  std::vector<Row> rows;
  for (const BorderReport& b : result.borders) {
    const CollarQuality& q = b.quality;
    rows.push_back(
        {scene.name, name, number(degrees(b.angle_min)) + " to " + number(degrees(b.angle_max)),
         number(std::min(b.height_min, b.width_min), 1), pair_of(q.face_error),
         pair_of(q.cloud_error), pair_of(q.turn), number(q.ripple, 4), number(q.gap, 2),
         number(q.nearest_cv, 3), number(q.nearest_min, 2), number(moved.face, 4),
         number(moved.cloud, 4),
         scene.enclosed ? std::to_string(removal.missed) + " / " + std::to_string(removal.wrong)
                        : "-"});
  }
  return rows;
}

void cases(Report& report, const std::string& data) {
  std::vector<Row> rows;
  for (const BlendScene& scene : blend_scenes(data))
    for (const BlendMethod method : {BlendMethod::tangent, BlendMethod::linear})
      for (Row& row : rows_of(scene, method)) rows.push_back(std::move(row));
  report.table({"case", "method", "angle", "least setback", "normal error at the face, mean / max",
                "at the cloud", "turn a spacing, mean / max", "ripple", "gap", "nearest cv",
                "nearest min", "face moved", "cloud moved", "enclosed missed / wrong"},
               rows);
}

void sweep(Report& report, const std::filesystem::path& pictures) {
  report.heading(3, "Figures 81 to 87: varying the collar");
  report.text(
      "The tube on the cube. `tangent` by its radius R, `linear` by t with w = sqrt(2) t, and as "
      "the thesis varies them, one alone.");
  report.text("![Blends of the sweep](pictures/blend-sweep.png)");
  std::vector<Row> rows;
  std::vector<PictureOf> shown;
  const auto run = [&](BlendMethod method, double radius, double height, double width) {
    const BlendScene scene = tube_on_cube();
    BlendOptions options = options_of(scene, method);
    options.radius = radius, options.height = height, options.width = width;
    const bool tangent = method == BlendMethod::tangent;
    const std::string what = radius > 0 ? "R = " + number(radius, 1)
                                        : "t = " + number(height, 1) + ", w = " + number(width, 1);
    const Row head = {tangent ? "tangent" : "linear", what};
    try {
      Blend b = blend(scene.cloud, scene.face, options);
      const CollarQuality& q = b.borders[0].quality;
      const Removal removal = check_removal(scene, b);
      rows.push_back({head[0], what, pair_of(q.face_error), pair_of(q.cloud_error), pair_of(q.turn),
                      number(q.ripple, 4), number(q.gap, 2),
                      std::to_string(b.borders[0].collar_points), std::to_string(removal.missed)});
      shown.push_back({head[0] + ", " + what, std::move(b)});
    } catch (const NoResultError& error) {
      rows.push_back(
          {head[0], what, std::string("refused: ") + error.what(), "", "", "", "", "", ""});
    }
  };
  for (const double radius : {2.5, 4.0, 6.0, 8.0, 10.0}) run(BlendMethod::tangent, radius, 0, 0);
  run(BlendMethod::tangent, 0, 8, 2.5);
  run(BlendMethod::tangent, 0, 2.5, 8);
  for (const double t : {0.75, 1.0, 2.0, 4.0, 8.0})
    run(BlendMethod::linear, 0, t, t * std::sqrt(2.0));
  run(BlendMethod::linear, 0, 2, 2.4);
  run(BlendMethod::linear, 0, 4, 12);
  report.table({"method", "collar", "normal error at the face", "at the cloud", "turn", "ripple",
                "gap", "points", "enclosed missed"},
               rows);
  draw_blends(shown, pictures / "blend-sweep.png", 4);
}

// The cloud's own waves where no collar is: rms over the top, as ripple is measured.
double own_ripple(const std::vector<Vec3>& cloud) {
  const MlsCloud mls(cloud);
  const MlsOptions options = settle({}, mls.noise());
  MlsScratch scratch;
  double squares = 0, count = 0;
  std::vector<double> height;
  for (double y = 8; y < 33; y += 2) {
    height.clear();
    for (double x = 4; x < 37; x += 0.5)
      height.push_back(project_plain(mls, {x, y, 41}, options, scratch).position.z);
    for (std::size_t i = 8; i + 8 < height.size(); ++i) {
      double mean = 0;
      for (std::size_t k = i - 8; k <= i + 8; ++k) mean += height[k] / 17;
      squares += (height[i] - mean) * (height[i] - mean);
      ++count;
    }
  }
  return std::sqrt(squares / count) / mls.spacing();
}

void noise(Report& report, const std::filesystem::path& pictures) {
  report.heading(3, "Figure 88: noise");
  report.text(
      "The tube on the cube; noise in percent of the bounding sphere's radius, seeds 61 to 63, all "
      "values means over them. Radius chosen by the noise (`tangent`), t = 4 (`linear`). The "
      "cloud's own ripple is that of its MLS surface on the top, measured the same way.");
  report.text("![Blends of noisy clouds](pictures/blend-noise.png)");
  std::vector<Row> rows;
  std::vector<PictureOf> shown;
  for (const double percent : {0.0, 0.1, 0.5, 1.0, 2.0})
    for (const BlendMethod method : {BlendMethod::tangent, BlendMethod::linear}) {
      double ripple = 0, own = 0, mean = 0, max = 0, radius = 0;
      for (const std::uint64_t seed : {61u, 62u, 63u}) {
        const BlendScene scene = tube_on_cube(percent, seed);
        BlendOptions options = options_of(scene, method);
        options.radius = 0;
        Blend b = blend(scene.cloud, scene.face, options);
        const CollarQuality& q = b.borders[0].quality;
        ripple += q.ripple / 3, own += own_ripple(scene.cloud) / 3, radius += b.radius / 3;
        mean += degrees(q.cloud_error.mean) / 3, max += degrees(q.cloud_error.max) / 3;
        if (seed == 61 && method == BlendMethod::tangent)
          shown.push_back({number(percent, 1) + " % noise", std::move(b)});
      }
      rows.push_back({number(percent, 1), method == BlendMethod::tangent ? "tangent" : "linear",
                      radius > 0 ? number(radius, 1) : "-", number(ripple, 4), number(own, 4),
                      number(mean, 1) + " / " + number(max, 1)});
    }
  report.table({"noise", "method", "radius", "ripple of the collar", "of the cloud itself",
                "normal error at the cloud, mean / max"},
               rows);
  draw_blends(shown, pictures / "blend-noise.png", 3);
}

void speed_of_blends(Report& report) {
  constexpr int n = 409;
  constexpr double side = n - 1;
  std::vector<Vec3> cloud;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double a = i, b = j;
      const bool inner = i > 0 && i < n - 1, both = inner && j > 0 && j < n - 1;
      for (const double c : {0.0, side}) {
        cloud.push_back({a, b, c});
        if (inner) cloud.push_back({a, c, b});
        if (both) cloud.push_back({c, a, b});
      }
    }
  NurbsFace face;
  face.surface = nurbs_tube({{side / 2, side / 2, side - 100}, {0, 0, 1}}, 82, 300);
  face.u = face.v = {0, 1};
  find_seams(face);
  BlendOptions options;
  options.starts = {parse_start("v1")};
  options.radius = 4;
  Job job;
  job.threads = 2;
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t cpu = std::clock();
  const Blend b = blend(cloud, face, options, job);
  const double wall =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  report.heading(3, "Speed of a blend");
  report.text(std::to_string(cloud.size()) + " points, " + std::to_string(b.borders[0].lines) +
              " isolines, " + std::to_string(b.borders[0].nurbs_points) + " points of the face, " +
              std::to_string(b.borders[0].collar_points) + " of the collar, two threads: " +
              number(static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC, 1) + " s of CPU, " +
              number(wall, 1) + " s passed (other work may have run).");
}

}  // namespace

void chapter5(Report& report, const std::filesystem::path& data,
              const std::filesystem::path& pictures) {
  report.heading(2, "Chapter 5: blending with NURBS surfaces");
  report.text(
      "Lengths in spacings, angles in degrees. `linear` is the collar of the thesis, `tangent` "
      "ours. Normal error: of the MLS surface of all points (quadratic) at the borders of the "
      "collar, from the face and from the cloud's own MLS surface. Turn: of its normal over one "
      "spacing, the most along each profile. Ripple: rms of its waves along the collar, shorter "
      "than 8. Gap: from a place of the collar to the nearest point. Face or cloud moved: MLS "
      "surface 2 to 6 away from the collar. Enclosed samples that stayed, and samples removed "
      "though they lie outside the collar. What the ball does in "
      "acute corners and at edges was chosen on the tubes of radius 4.1, on the tube across an "
      "edge "
      "and on the fandisk; the tubes of radius 8.7 were looked at, those of radius 6.3 and 12.2 "
      "not before all was chosen.");
  cases(report, data.string());
  sweep(report, pictures);
  noise(report, pictures);
  blend_meshes(report, data.string(), pictures);
  speed_of_blends(report);
}

}  // namespace spigolo::bench
