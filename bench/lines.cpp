// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/lines.cpp - feature curves: how many, where, how much of the truth, how fast
#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>

#include "curve_score.h"
#include "labelled.h"
#include "sections.h"
#include "spigolo/io/curve_writers.h"
#include "spigolo/pipeline/lines.h"
#include "spigolo/synth/synth.h"
#include "spigolo/trace/place_grid.h"

namespace spigolo::bench {
namespace {

namespace fs = std::filesystem;

// The constants were looked at on the same shapes with seeds 1, 2 and 7.
constexpr std::uint64_t seed = 23;

struct Sampled {
  const char* name;
  Sampling sampling;
};
constexpr std::array<Sampled, 3> samplings = {
    {{"lattice", Sampling::lattice}, {"blue", Sampling::blue}, {"random", Sampling::random}}};

constexpr std::array<const char*, 12> shapes = {"box",     "l-prism", "steps",    "star",
                                                "pyramid", "boxhole", "hole17k",  "hole",
                                                "cone",    "lens",    "cylinder", "cylinders"};

bool has_lattice(const std::string& shape) {
  for (const ShapeInfo& info : synth_shapes())
    if (shape == info.name) return info.lattice;
  return false;
}

struct Run {
  SynthCloud synth;
  Lines lines;
  CurveScore score;
};

Run run_lines(const char* shape, Sampling sampling, double noise, DetectMethod method) {
  SynthOptions options{.shape = shape, .sampling = sampling};
  options.noise = noise, options.seed = seed;
  Run run{make_cloud(options), {}, {}};
  LinesOptions how;
  how.detect.method = method;
  run.lines = find_lines(run.synth.cloud.points, how);
  run.score = score_curves(run.lines.network, run.synth.shape, run.lines.detection.spacing);
  return run;
}

std::string count_of(const CurveScore& score) {
  return std::to_string(score.curves) + " / " + std::to_string(score.corners) +
         (score.right ? "" : " (!)");
}

std::string percent(double share, int digits = 2) { return number(100 * share, digits); }

void counts(Report& report) {
  report.heading(3, "Curves and corners, without noise");
  report.text(
      "Found curves / corners; (!) marks a number of curves, or of corners of any valence, that is "
      "not the shape's. The shapes' own numbers: an edge of two smooth patches is a curve, closed "
      "where it meets no other; three or more meet in a corner. Crossing cylinders and cones have "
      "closed curves and no corner. Each shape as the thesis's or its own lattice, blue-noise and "
      "random samples of about 10 000 points (hole: 58 000, hole17k: 17 000).");
  std::vector<std::vector<std::string>> rows;
  for (const char* shape : shapes) {
    SynthOptions options{.shape = shape};
    const Shape truth = make_shape(options);
    std::vector<std::string> row = {
        shape, std::to_string(truth.creases.size()) + " / " + std::to_string(truth.corners.size())};
    for (const Sampled& s : samplings) {
      if (s.sampling == Sampling::lattice && !has_lattice(shape)) {
        row.push_back("-");
        continue;
      }
      row.push_back(count_of(run_lines(shape, s.sampling, 0, DetectMethod::sheets).score));
    }
    rows.push_back(row);
  }
  report.table({"shape", "right", "lattice", "blue", "random"}, rows);
}

void thesis_method_counts(Report& report) {
  report.heading(3, "The same from the thesis's labels");
  std::vector<std::vector<std::string>> rows;
  for (const char* shape : {"hole17k", "hole"}) {
    const Run run = run_lines(shape, Sampling::lattice, 0, DetectMethod::gauss_map);
    rows.push_back({shape, count_of(run.score), percent(run.score.length),
                    number(run.score.mean_off, 3), number(run.score.most_off, 3)});
  }
  report.text(
      "`--method gauss-map`, whose labels carry no crease, direction or angle of their own.");
  report.table({"shape", "curves / corners", "length [%]", "mean off", "max off"}, rows);
}

std::vector<std::string> distance_row(const char* shape, const Sampled& s, const Run& run) {
  const CurveScore& c = run.score;
  return {shape,
          s.name,
          percent(c.length, 3),
          number(c.mean_off, 4),
          number(c.most_off, 3),
          number(c.mean_true, 4),
          number(c.most_true, 3),
          percent(c.covered),
          number(c.corner_off, 4)};
}

void distances(Report& report) {
  report.heading(3, "Distance between curves and true edges, without noise");
  report.text(
      "In spacings, both ways; length in percent of the true length; the worst corner. Thesis's "
      "feature lines: 0.16 to 0.25 mean.");
  std::vector<std::vector<std::string>> rows;
  for (const char* shape : shapes)
    for (const Sampled& s : samplings)
      if (s.sampling != Sampling::lattice || has_lattice(shape))
        rows.push_back(
            distance_row(shape, s, run_lines(shape, s.sampling, 0, DetectMethod::sheets)));
  report.table({"shape", "samples", "length [%]", "mean off", "max off", "true edge: mean", "max",
                "covered [%]", "corner"},
               rows);
}

void radii(Report& report) {
  std::vector<std::vector<std::string>> rows;
  for (const char* shape : {"hole17k", "hole", "boxhole"}) {
    const Sampled& s = samplings[std::string(shape) == "boxhole" ? 1 : 0];
    const Run run = run_lines(shape, s.sampling, 0, DetectMethod::sheets);
    double worst = 0;
    std::size_t circles = 0;
    for (const FeatureCurve& curve : run.lines.network.curves) {
      if (curve.shape != CurveShape::circle) continue;
      ++circles;
      double right = infinity;
      for (const ExactCrease& crease : run.synth.shape.creases)
        if (crease.curve.closed)
          right = std::min(right, distance(crease.curve.at(0), crease.curve.at(0.5)) / 2);
      worst = std::max(worst, std::abs(curve.radius / right - 1));
    }
    char text[32];
    std::snprintf(text, sizeof text, "%.1e", worst);
    rows.push_back({shape, s.name, std::to_string(circles), text});
  }
  report.heading(3, "Rims of holes are circles");
  report.table({"shape", "samples", "circles", "largest error of a radius, relative"}, rows);
}

void noisy(Report& report) {
  report.heading(3, "With noise");
  report.text(
      "Standard deviation .25 and .5 h; mean distance of the curves to the true edges in units of "
      "that deviation (sigma), and the largest in spacings.");
  std::vector<std::vector<std::string>> rows;
  for (const double noise : {0.25, 0.5})
    for (const char* shape :
         {"box", "l-prism", "star", "boxhole", "hole17k", "cylinder", "cylinders"})
      for (const Sampled& s : samplings) {
        if (s.sampling == Sampling::lattice && !has_lattice(shape)) continue;
        const Run run = run_lines(shape, s.sampling, noise, DetectMethod::sheets);
        const double sigma = noise * run.synth.spacing / run.lines.detection.spacing;
        rows.push_back({number(noise, 2), shape, s.name, count_of(run.score),
                        percent(run.score.length, 1), number(run.score.mean_off / sigma, 2),
                        number(run.score.most_off, 2), percent(run.score.covered, 1)});
      }
  report.table({"noise", "shape", "samples", "curves / corners", "length [%]", "mean off [sigma]",
                "max off", "covered [%]"},
               rows);
}

void pure_noise(Report& report) {
  Random random(seed);
  std::vector<Vec3> points(20000);
  for (Vec3& p : points) p = random.in_ball();
  const Lines lines = find_lines(points);
  double length = 0;
  for (const FeatureCurve& curve : lines.network.curves) length += curve.length();
  report.text("20 000 random points in a ball: " + std::to_string(lines.network.curves.size()) +
              " curves, together " + number(length / lines.detection.spacing, 0) +
              " spacings long.");
}

void labelled(Report& report, const fs::path& data) {
  report.heading(3, "ABC clouds");
  report.text(
      "Share of the labelled samples within one spacing of a curve, share of the curves' length "
      "within one spacing of a labelled sample, and the share of the labelled samples that "
      "detection marked something for within one spacing: what tracing had to go by.");
  std::vector<std::vector<std::string>> rows;
  std::array<double, 3> sum{};
  const auto clouds = read_labelled(data / "abc" / "clean");
  for (const LabelledCloud& cloud : clouds) {
    const Lines lines = find_lines(cloud.points);
    const double spacing = lines.detection.spacing;
    std::vector<Vec3> red, marked;
    for (std::size_t i = 0; i < cloud.points.size(); ++i) {
      if (cloud.truth.feature[i]) red.push_back(cloud.points[i]);
      if (lines.detection.features.kind[i] != PointKind::surface)
        marked.push_back(lines.detection.features.crease_point[i]);
    }
    const auto share_near = [&](std::span<const Vec3> of, std::span<const Vec3> to) {
      const PlaceGrid grid(to, spacing);
      std::size_t near = 0;
      for (const Vec3& p : of) near += grid.nearest(p, spacing) != PlaceGrid::no_place;
      return of.empty() ? 1.0 : static_cast<double>(near) / static_cast<double>(of.size());
    };
    std::size_t near = 0;
    for (const double d : distances_to_curves(lines.network, CurveKind::edge, red, 2 * spacing))
      near += d <= spacing;
    const double found = static_cast<double>(near) / static_cast<double>(red.size());
    const double right = share_near(places_along(lines.network, CurveKind::edge, spacing / 4), red);
    const double known = share_near(red, marked);
    sum[0] += found, sum[1] += right, sum[2] += known;
    rows.push_back({cloud.name, std::to_string(cloud.points.size()),
                    std::to_string(lines.network.curves.size()),
                    std::to_string(lines.network.corners.size()), number(found, 3),
                    number(right, 3), number(known, 3)});
  }
  const auto n = static_cast<double>(clouds.size());
  rows.push_back(
      {"mean", "", "", "", number(sum[0] / n, 3), number(sum[1] / n, 3), number(sum[2] / n, 3)});
  report.table({"cloud", "points", "curves", "corners", "labels near a curve",
                "curves near a label", "labels near a mark"},
               rows);
}

double cpu_seconds() {
  timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

void times(Report& report) {
  report.heading(3, "Seconds from points to DXF");
  report.text(
      "`boxhole`, blue-noise samples; two threads; detection, tracing and the text of the DXF. CPU "
      "seconds are of both threads together; half of them is what two idle cores need.");
  std::vector<std::vector<std::string>> rows;
  for (const std::size_t points : {std::size_t{100000}, std::size_t{1000000}})
    for (const double noise : {0.0, 0.25}) {
      SynthOptions options{.shape = "boxhole", .sampling = Sampling::blue};
      options.points = points, options.noise = noise, options.seed = seed;
      const SynthCloud synth = make_cloud(options);
      const auto wall = std::chrono::steady_clock::now();
      const double cpu = cpu_seconds();
      Job job;
      job.threads = 2;
      const Lines lines = find_lines(synth.cloud.points, {}, job);
      const std::string dxf = dxf_text(lines.network, {});
      const double used = cpu_seconds() - cpu;
      const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - wall;
      rows.push_back({std::to_string(points), number(noise, 2), number(seconds.count(), 2),
                      number(used, 2), number(lines.seconds_trace, 2),
                      std::to_string(lines.network.curves.size())});
    }
  report.table({"points", "noise", "wall", "CPU", "tracing, wall", "curves"}, rows);
}

}  // namespace

void feature_lines(Report& report, const fs::path& data) {
  report.heading(2, "Feature lines");
  counts(report);
  thesis_method_counts(report);
  distances(report);
  radii(report);
  noisy(report);
  pure_noise(report);
  if (!data.empty()) {
    labelled(report, data);
    judged_models(report, data);
  }
  times(report);
}

}  // namespace spigolo::bench
