// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/local_lines.cpp - tables 3 and 4: how far local feature lines are from the true edge
#include <algorithm>
#include <functional>

#include "projection.h"
#include "sample_mesh.h"
#include "sections.h"
#include "spigolo/core/triangle_mesh.h"
#include "spigolo/detect/detect.h"
#include "spigolo/io/cloud_file.h"
#include "spigolo/measure/distance.h"
#include "spigolo/mls/sharp_neighborhood.h"

namespace spigolo::bench {
namespace {

struct LineErrors {
  double max = 0, min = infinity, sum = 0;
  std::size_t samples = 0, lines = 0;

  std::string text(double unit) const {
    if (lines == 0) return "no line";
    return number(max * unit, 4) + " / " + number(min * unit, 4) + " / " +
           number(sum / static_cast<double>(samples) * unit, 4);
  }
};

using Distance = std::function<double(const Vec3&)>;

// Every neighborhood of k points that has a line, where `counts` says so; the line at 21 places.
LineErrors measure_lines(const std::vector<Vec3>& points, std::span<const PointKind> kind,
                         std::size_t k, const Distance& to_edge,
                         const std::function<bool(const Vec3&)>& counts) {
  const MlsCloud cloud(points);
  FeatureLineOptions options;
  options.mls.k = k;
  options.mls = settle(options.mls, cloud.noise());
  const FeatureMap features = map_features(cloud, ordered_kinds(cloud.ordered(), kind), k);
  FeatureLineScratch scratch;
  LineErrors errors;
  for (const Vec3& p : cloud.points()) {
    if (!counts(p + cloud.origin())) continue;
    cloud.tree().nearest(p, k, scratch.mls.found);
    const auto line = local_feature_line(cloud, features, options, scratch);
    if (!line) continue;
    ++errors.lines;
    for (int i = 0; i <= 20; ++i, ++errors.samples) {
      const double d = to_edge(point_at(*line, i / 20.0) + cloud.origin());
      errors.max = std::max(errors.max, d), errors.min = std::min(errors.min, d);
      errors.sum += d;
    }
  }
  return errors;
}

std::vector<PointKind> true_kinds(const SynthCloud& s) {
  std::vector<PointKind> kinds;
  for (const double k : s.cloud.find("truth_kind")->values)
    kinds.push_back(static_cast<PointKind>(static_cast<int>(k)));
  return kinds;
}

// Near the edge, away from corners and borders; of hole only near the round rims.
LineErrors lines_of(const char* shape, double percent, std::size_t k, bool exact_labels) {
  SynthOptions options;
  options.shape = shape;
  options.noise_percent = percent;
  const SynthCloud s = make_cloud(options);
  const bool rims = options.shape == "hole";
  const auto to_edge = [&](const Vec3& p) { return nearest_crease(s.shape, p).distance; };
  const auto counts = [&](const Vec3& p) {
    const CreaseFoot foot = nearest_crease(s.shape, p);
    return foot.distance < 1.5 * s.spacing &&
           (!rims || s.shape.creases[foot.crease].curve.closed) &&
           corner_distance(s.shape, foot.point) > 6 * s.spacing &&
           border_distance(s.shape, foot.point) > 6 * s.spacing;
  };
  const auto kind = exact_labels ? true_kinds(s) : detect(s.cloud.points).features.kind;
  return measure_lines(s.cloud.points, kind, k, to_edge, counts);
}

// Sides of the mesh whose triangles meet at more than this are its edges.
constexpr double sharp_side = radians(20);

Segments sharp_sides(const TriangleMesh& mesh) {
  struct Side {
    std::array<std::uint32_t, 2> ends;
    Vec3 normal;
  };
  std::vector<Side> sides;
  const auto& v = mesh.vertices.points;
  for (const auto& t : mesh.triangles) {
    const Vec3 n = cross(v[t[1]] - v[t[0]], v[t[2]] - v[t[0]]);
    for (std::size_t i = 0; i < 3; ++i)
      sides.push_back({{std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])}, n});
  }
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b) { return a.ends < b.ends; });
  Segments sharp;
  for (std::size_t i = 1; i < sides.size(); ++i)
    if (sides[i].ends == sides[i - 1].ends &&
        angle_between(sides[i].normal, sides[i - 1].normal) > sharp_side)
      sharp.push_back(sides[i].ends);
  return sharp;
}

// In units where the spacing is that of the thesis.
std::string fandisk_lines(const std::filesystem::path& data) {
  if (data.empty()) return "not run (--data)";
  const TriangleMesh mesh = read_mesh(data / "fandisk.off");
  const Segments edges = sharp_sides(mesh);
  const auto& points = mesh.vertices.points;
  const Detection detection = detect(points);
  const auto to_edge = [&](const Vec3& p) {
    return distances_to_segments({&p, 1}, points, edges)[0];
  };
  const auto distances = distances_to_segments(points, points, edges);
  std::vector<Vec3> beside;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (distances[i] < 0.5 * detection.spacing && i % 8 == 0) beside.push_back(points[i]);
  const auto counts = [&](const Vec3& p) {
    return std::any_of(beside.begin(), beside.end(), [&](const Vec3& q) {
      return squared_distance(p, q) < 1e-12 * squared_norm(q);
    });
  };
  const double unit = 0.125 / detection.spacing;
  return measure_lines(points, detection.features.kind, 20, to_edge, counts).text(unit);
}

}  // namespace

void local_lines(Report& report, const std::filesystem::path& data) {
  report.heading(3, "Tables 3 and 4: error of local feature lines");
  report.text(
      "Largest / smallest / mean distance of the line to the true edge, in the thesis's units "
      "(spacing .244 of cube, .125 of fandisk, .111 of hole, .1 of planes). The thesis measures a "
      "single line; ours are all lines within 1.5 spacings of the edge and 6 from corners and "
      "borders, on hole those of the round rims, on fandisk (vertices of the mesh; edges are sides "
      "of more than 20 degrees) an eighth of them, corners too. Noise in percent of the bounding "
      "sphere's radius. The first of ours has labels of our own detection, the second true ones.");
  struct Row {
    const char* name;
    double unit, percent;
    std::size_t k;
    const char* thesis;
  };
  std::vector<std::vector<std::string>> rows;
  for (const Row& row : {Row{"cube", .244, 0, 20, "0.0 / 0.0 / 0.0"},
                         {"hole", .111, 0, 20, ".0447 / 0.0 / .0206"},
                         {"hole", .111, .5, 20, ".0457 / .0052 / .0185"},
                         {"hole", .111, 1, 20, ".0880 / .0154 / .0363"},
                         {"hole", .111, 2, 20, ".0785 / .0352 / .0591"},
                         {"planes", .1, 0, 20, ".0620 / 0.0 / .0310"},
                         {"planes", .1, .5, 20, ".0667 / .0049 / .0474"},
                         {"planes", .1, 1, 20, ".0712 / .0141 / .0644"},
                         {"planes", .1, 2, 20, ".1042 / .0442 / .0752"},
                         {"planes", .1, 2, 40, ".0821 / .0252 / .0657"}}) {
    rows.push_back({row.name, number(row.percent, 1), std::to_string(row.k), row.thesis,
                    lines_of(row.name, row.percent, row.k, false).text(row.unit),
                    lines_of(row.name, row.percent, row.k, true).text(row.unit)});
  }
  rows.push_back({"fandisk", "0.0", "20", ".0740 / 0.0 / .0318", fandisk_lines(data), "-"});
  report.table({"set", "noise %", "k", "thesis", "our labels", "true labels"}, rows);
}

}  // namespace spigolo::bench
