// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/moved_inputs.cpp
#include "moved_inputs.h"

#include <algorithm>
#include <functional>

#include "on_all_cores.h"
#include "spigolo/core/random.h"
#include "spigolo/detect/detect.h"
#include "spigolo/measure/distance.h"
#include "spigolo/pipeline/lines.h"
#include "spigolo/pipeline/mesh.h"
#include "spigolo/pipeline/smooth.h"

namespace spigolo::bench {
namespace {

constexpr double same_place = 1e-5;    // [spacings] what rounding may move a point
constexpr double same_surface = 0.01;  // [spacings] curves and meshes may be sampled elsewhere

struct Move {
  const char* name;
  bool permuted = false, turned = false;
  double scale = 1;
  Vec3 shift = {};  // [extents of the cloud]
};

const Move moves[] = {{"other order", true},
                      {"turned", false, true},
                      {"x 0.0254", false, false, 0.0254},
                      {"shifted by 100 extents", false, false, 1, {60, -80, 10}},
                      {"all of it", true, true, 0.0254, {60, -80, 10}}};

// A turn by no round angle about no axis of the shape.
const Vec3 turn_x = normalized(Vec3{0.7, -0.2, 0.55});
const Vec3 turn_y = normalized(cross(Vec3{0.1, 0.9, -0.3}, turn_x));
const Vec3 turn_z = cross(turn_x, turn_y);

struct Moved {
  Move move;
  Vec3 offset = {};
  std::vector<Vec3> points = {};
  std::vector<std::size_t> origin = {};  // of each point, in the cloud as it was

  Vec3 undo(const Vec3& moved) const {
    const Vec3 p = (moved - offset) / move.scale;
    return move.turned ? turn_x * p.x + turn_y * p.y + turn_z * p.z : p;
  }
};

Moved moved_by(const Move& move, const std::vector<Vec3>& points) {
  Moved result{move};
  result.offset = move.shift * norm(bounding_box(points).size()) * move.scale;
  for (std::size_t i = 0; i < points.size(); ++i) result.origin.push_back(i);
  Random random(92);
  if (move.permuted)
    for (std::size_t i = points.size(); i > 1; --i)
      std::swap(result.origin[i - 1], result.origin[random.below(i)]);
  for (const std::size_t i : result.origin) {
    const Vec3& p = points[i];
    const Vec3 q = move.turned ? Vec3{dot(p, turn_x), dot(p, turn_y), dot(p, turn_z)} : p;
    result.points.push_back(q * move.scale + result.offset);
  }
  return result;
}

/// What a stage says, in the place, size and order that the cloud had.
struct Answer {
  std::vector<int> labels = {};   // by point
  std::vector<Vec3> places = {};  // by point, or the vertices of lines or triangles
  Segments lines = {};
  TriangleMesh mesh = {};
};

struct Stage {
  const char* name;
  const char* what;
  std::function<Answer(const Moved&)> run;
};

Answer labels_of(const Moved& moved, DetectMethod method) {
  DetectOptions options;
  options.method = method;
  const Features features = detect(moved.points, options).features;
  Answer answer{std::vector<int>(features.size())};
  for (std::size_t i = 0; i < features.size(); ++i)
    answer.labels[moved.origin[i]] = static_cast<int>(features.kind[i]);
  return answer;
}

Answer smoothed(const Moved& moved, SmoothMethod method) {
  SmoothOptions options;
  options.method = method;
  const Smoothed s = smooth(moved.points, options);
  Answer answer{{}, std::vector<Vec3>(s.size())};
  for (std::size_t i = 0; i < s.size(); ++i)
    answer.places[moved.origin[i]] = moved.undo(s.position[i]);
  return answer;
}

Answer curves_of(const Moved& moved) {
  Answer answer;
  const Lines found = find_lines(moved.points);
  for (const FeatureCurve& curve : found.network.curves) {
    const auto first = static_cast<std::uint32_t>(answer.places.size());
    for (const Vec3& p : curve.points) {
      const auto at = static_cast<std::uint32_t>(answer.places.size());
      if (at > first) answer.lines.push_back({at - 1, at});
      answer.places.push_back(moved.undo(p));
    }
    if (curve.closed)
      answer.lines.push_back({static_cast<std::uint32_t>(answer.places.size()) - 1, first});
  }
  return answer;
}

Answer vertices_of(const Moved& moved) {
  Answer answer;
  answer.mesh = mesh_cloud(moved.points).sharp.mesh;
  for (Vec3& p : answer.mesh.vertices.points) p = moved.undo(p);
  answer.places = answer.mesh.vertices.points;
  return answer;
}

std::vector<Stage> stages() {
  std::vector<Stage> list;
  for (const auto& [name, method] : {std::pair{"detect sheets", DetectMethod::sheets},
                                     {"detect gauss-map", DetectMethod::gauss_map},
                                     {"detect gauss-map-global", DetectMethod::gauss_map_global}})
    list.push_back({name, "labels", [=](const Moved& m) { return labels_of(m, method); }});
  for (const auto& [name, method] : {std::pair{"smooth sheets", SmoothMethod::sheets},
                                     {"smooth feature-line", SmoothMethod::feature_line},
                                     {"smooth plain", SmoothMethod::plain}})
    list.push_back({name, "projected points", [=](const Moved& m) { return smoothed(m, method); }});
  list.push_back({"lines", "points of curves", curves_of});
  list.push_back({"mesh", "vertices", vertices_of});
  return list;
}

struct Difference {
  std::size_t count = 0;
  double most = 0;  // [h] of places; 0 of labels

  void add(double off, double limit) {
    count += !(off <= limit);
    most = std::max(most, off);
  }
};

/// Points of one that are not on the curves or the mesh of the other.
Difference beside(const Answer& one, const Answer& other, double h) {
  Difference difference;
  const std::vector<double> off = other.mesh.triangles.empty()
                                      ? distances_to_segments(one.places, other.places, other.lines)
                                      : distances_to_mesh(one.places, other.mesh, false);
  for (const double d : off) difference.add(d / h, same_surface);
  return difference;
}

/// How many labels or places are not those of the cloud as it was.
Difference difference_of(const Answer& was, const Answer& is, double h) {
  if (!was.lines.empty() || !was.mesh.triangles.empty()) {
    const Difference there = beside(was, is, h), back = beside(is, was, h);
    return {std::max(there.count, back.count), std::max(there.most, back.most)};
  }
  Difference difference;
  for (std::size_t i = 0; i < was.labels.size(); ++i)
    difference.count += was.labels[i] != is.labels[i];
  for (std::size_t i = 0; i < was.places.size(); ++i)
    difference.add(distance(was.places[i], is.places[i]) / h, same_place);
  return difference;
}

std::string cell_of(const Difference& difference) {
  if (difference.count == 0) return "same";
  std::string text = "differs (" + std::to_string(difference.count);
  if (difference.most > 0) text += ", up to " + number(difference.most, 3) + " h";
  return text + ")";
}

struct Case {
  SynthOptions options;
  Stage stage;
};

std::vector<std::string> row_of(const Case& c) {
  const SynthCloud s = make_cloud(c.options);
  const std::vector<Vec3>& points = s.cloud.points;
  const Answer was = c.stage.run(moved_by({"as it is"}, points));
  const std::size_t all = std::max(was.labels.size(), was.places.size());
  std::vector<std::string> row = {c.options.shape, c.stage.name,
                                  std::to_string(all) + " " + c.stage.what};
  for (const Move& move : moves)
    row.push_back(cell_of(difference_of(was, c.stage.run(moved_by(move, points)), s.spacing)));
  return row;
}

}  // namespace

std::vector<SynthOptions> moved_inputs() {
  return {
      {.shape = "boxhole", .sampling = Sampling::random, .points = 3000, .seed = 91},
      {.shape = "l-prism", .sampling = Sampling::blue, .points = 3000, .noise = 0.25, .seed = 91}};
}

void moved_inputs_tables(Report& report) {
  report.heading(3, "The same cloud in another order, direction, size and place");
  report.text(
      "The move is undone in what comes out. Labels that are not the same then; projected points "
      "that are more than 1e-5 h from where they were; points of curves and vertices of meshes "
      "that "
      "are more than .01 h beside the curves or the mesh that came out before, or the other way "
      "round. A turned cloud has another order along the space-filling curve, which decides where "
      "two choices are equal and where samples of curves and surfaces are laid.");
  std::vector<Case> cases;
  for (const SynthOptions& options : moved_inputs())
    for (const Stage& stage : stages()) cases.push_back({options, stage});
  std::vector<std::string> head = {"input", "stage", "of"};
  for (const Move& move : moves) head.emplace_back(move.name);
  report.table(head, on_all_cores(cases, row_of));
}

}  // namespace spigolo::bench
