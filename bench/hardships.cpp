// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/hardships.cpp - what scans are like: uneven, in lines, hidden, dirty; thin, fading shapes
#include "common.h"
#include "on_all_cores.h"
#include "sections.h"

namespace spigolo::bench {
namespace {

struct Hardship {
  std::string name;
  SynthOptions options;
};

std::vector<std::string> row_of(const Hardship& hardship) {
  SynthOptions options = hardship.options;
  options.seed = 41;
  if (options.points == 0) options.points = 10000;
  const SynthCloud s = make_cloud(options);
  const Scored sheets = detect_and_score(s), thesis = detect_and_score(s, thesis_method());
  return {hardship.name,
          options.shape,
          number(options.noise, 2),
          std::to_string(s.cloud.size()),
          number(sheets.tolerant.f1, 3),
          number(sheets.thin.f1, 3),
          number(sheets.tolerant.recall, 3),
          number(sheets.tolerant.precision, 3),
          number(thesis.tolerant.f1, 3)};
}

void add(std::vector<Hardship>& list, const std::string& name, SynthOptions options,
         bool with_noise = true) {
  if (options.sampling == Sampling::automatic) options.sampling = Sampling::blue;
  list.push_back({name, options});
  options.noise = 0.25;
  if (with_noise) list.push_back({name, options});
}

std::vector<Hardship> samplings() {
  std::vector<Hardship> list;
  for (const char* shape : {"boxhole", "steps"}) {
    add(list, "even, for comparison", {.shape = shape});
    add(list, "density x 10", {.shape = shape, .density_gradient = 10});
    add(list, "scan lines 4 : 1", {.shape = shape, .sampling = Sampling::scan});
    add(list, "one view", {.shape = shape, .sampling = Sampling::view, .views = 1});
    add(list, "four views", {.shape = shape, .sampling = Sampling::view, .views = 4});
    add(list, "1 % outliers", {.shape = shape, .outliers = 0.01});
    add(list, "10 % duplicates", {.shape = shape, .duplicates = 0.1}, false);
    list.push_back(
        {"noise x 10 across",
         {.shape = shape, .sampling = Sampling::blue, .noise = 0.1, .noise_gradient = 10}});
  }
  return list;
}

std::vector<Hardship> shapes() {
  std::vector<Hardship> list;
  for (const double size : {1.5, 2.0, 2.5, 4.0})
    add(list, "plate of " + number(size, 1) + " spacings", {.shape = "plate", .size = size});
  for (const double size : {1.5, 2.5, 4.0})
    add(list, "slot of " + number(size, 1) + " spacings", {.shape = "slot", .size = size});
  for (const double size : {2.0, 3.0, 5.0})
    add(list, "chamfer of " + number(size, 1) + " spacings",
        {.shape = "chamfer-box", .size = size});
  return list;
}

std::vector<std::string> fading_row(const SynthOptions& options) {
  constexpr double bands[] = {5, 10, 15, 20, 30, 45, 90};
  const SynthCloud s = make_cloud(options);
  const auto flags = sharp_flags(detect(s.cloud.points).features);
  const auto& truth = s.cloud.find("truth_feature")->values;
  double found[std::size(bands)] = {}, all[std::size(bands)] = {};
  for (std::size_t i = 0; i < flags.size(); ++i) {
    if (truth[i] == 0) continue;
    const double bent = degrees(nearest_crease(s.shape, s.exact[i]).deviation);
    std::size_t b = 0;
    while (b + 1 < std::size(bands) && bent > bands[b]) ++b;
    found[b] += flags[i], all[b] += 1;
  }
  std::vector<std::string> row = {options.sampling == Sampling::blue ? "blue" : "random",
                                  number(options.noise, 2)};
  for (std::size_t b = 0; b < std::size(bands); ++b)
    row.push_back(number(100 * found[b] / std::max(1.0, all[b])));
  return row;
}

void fading(Report& report) {
  report.heading(3, "Edges that fade out");
  report.text(
      "`fade`: an edge from 90 degrees to flat. Percent of the feature points found by how far the "
      "edge is bent there.");
  std::vector<SynthOptions> cases;
  for (const Sampling sampling : {Sampling::random, Sampling::blue})
    for (const double noise : {0.0, 0.1, 0.25})
      cases.push_back(
          {.shape = "fade", .sampling = sampling, .points = 20000, .noise = noise, .seed = 41});
  report.table(
      {"samples", "noise", "0 to 5 deg", "to 10", "to 15", "to 20", "to 30", "to 45", "to 90"},
      on_all_cores(cases, fading_row));
}

/// How many of the places have a point of this kind within 1.5 h, and how many points of the kind
/// are farther than 3 h from all of them.
std::pair<std::size_t, std::size_t> places(const SynthCloud& s, const Features& features,
                                           const std::vector<Vec3>& at, PointKind kind) {
  std::size_t stray = 0;
  std::vector<std::uint8_t> found(at.size(), 0);
  for (std::size_t i = 0; i < features.size(); ++i) {
    if (features.kind[i] != kind) continue;
    bool near = false;
    for (std::size_t c = 0; c < at.size(); ++c) {
      const double d = distance(s.exact[i], at[c]) / s.spacing;
      near = near || d <= 3;
      if (d <= 1.5) found[c] = 1;
    }
    stray += !near;
  }
  return {static_cast<std::size_t>(std::count(found.begin(), found.end(), 1)), stray};
}

std::vector<std::string> corner_row(const Hardship& hardship) {
  SynthOptions options = hardship.options;
  options.sampling = Sampling::blue, options.points = 10000, options.seed = 41;
  const SynthCloud s = make_cloud(options);
  const Features f = detect(s.cloud.points).features;
  std::vector<Vec3> corners;
  for (const Corner& corner : s.shape.corners) corners.push_back(corner.position);
  const auto [found, stray] = places(s, f, corners, PointKind::corner);
  const auto [tips, stray_tips] = places(s, f, s.shape.tips, PointKind::tip);
  std::string meet = "-";
  if (!corners.empty()) {
    int most = 0;
    for (std::size_t i = 0; i < f.size(); ++i)
      if (f.kind[i] == PointKind::corner && distance(s.exact[i], corners.back()) <= 1.5 * s.spacing)
        most = std::max<int>(most, f.sheets[i]);
    meet = std::to_string(most) + " of " + std::to_string(s.shape.corners.back().valence);
  }
  return {hardship.name,
          number(options.noise, 2),
          std::to_string(found) + " of " + std::to_string(corners.size()),
          std::to_string(stray),
          meet,
          std::to_string(tips) + " of " + std::to_string(s.shape.tips.size()),
          std::to_string(stray_tips)};
}

void corners_and_tips(Report& report) {
  report.heading(3, "Corners and tips");
  report.text(
      "Corners with a corner point within 1.5 h, corner points farther than 3 h from any corner, "
      "sheets said to meet in the apex of the pyramid (most, of the true number); the same for the "
      "tips of cones.");
  std::vector<Hardship> cases;
  for (const double noise : {0.0, 0.25}) {
    for (const char* shape : {"box", "l-prism", "steps", "star"})
      cases.push_back({shape, {.shape = shape, .noise = noise}});
    for (const std::size_t sides : {3u, 4u, 5u, 6u})
      cases.push_back({"pyramid of " + std::to_string(sides) + " sides",
                       {.shape = "pyramid", .noise = noise, .sides = sides}});
    for (const double angle : {30.0, 60.0, 90.0, 120.0, 150.0})
      cases.push_back({"spike of " + number(angle) + " deg",
                       {.shape = "spike", .noise = noise, .angle = radians(angle)}});
  }
  report.table({"shape", "noise", "corners found", "stray corner points", "sheets at the apex",
                "tips found", "stray tip points"},
               on_all_cores(cases, corner_row));
}

std::vector<std::string> border_row(const SynthOptions& options) {
  const SynthCloud s = make_cloud(options);
  const Features f = detect(s.cloud.points).features;
  std::size_t marks = 0, there = 0, found = 0, stray = 0;
  for (std::size_t i = 0; i < f.size(); ++i) {
    const double away = border_distance(s.shape, s.exact[i]) / s.spacing;
    const bool marked = f.kind[i] == PointKind::border;
    marks += marked, there += away <= 0.75;
    found += marked && away <= 0.75, stray += marked && away > 5;
  }
  return {
      options.shape,
      options.sampling == Sampling::blue ? "blue" : "random",
      number(options.noise, 2),
      std::to_string(marks),
      number(100 * static_cast<double>(found) / std::max<double>(1, static_cast<double>(there))),
      std::to_string(stray)};
}

void borders(Report& report) {
  report.heading(3, "Borders of open surfaces");
  report.text(
      "Points marked `border`; percent of the points within .75 h of the true border that are; "
      "marks farther than 5 h from it (all marks where the surface is closed). 8000 points.");
  std::vector<SynthOptions> cases;
  for (const char* shape : {"patch", "wedge", "fillet-box"})
    for (const Sampling sampling : {Sampling::random, Sampling::blue})
      for (const double noise : {0.0, 0.25})
        cases.push_back(
            {.shape = shape, .sampling = sampling, .points = 8000, .noise = noise, .seed = 41});
  report.table({"shape", "samples", "noise", "marks", "border points found %", "stray marks"},
               on_all_cores(cases, border_row));
}

std::vector<std::string> head() {
  return {"hardship",
          "shape",
          "noise",
          "points",
          "`sheets`: tolerant F1",
          "thin F1",
          "recall",
          "precision",
          "`gauss-map`: tolerant F1"};
}

}  // namespace

void hardships(Report& report) {
  report.heading(2, "Hardships: what scans are like");
  report.text(
      "Blue samples but for scan lines and views; noise per axis in h. Density and noise change "
      "ten-fold from one end of the shape to the other (noise: `--noise` is the middle). Views: "
      "first hits of scanners at fixed places; edges of which one side was not seen are borders. "
      "The limits of the truth follow the local h. docs/synth.md defines each. Seed 41.");
  report.table(head(), on_all_cores(samplings(), row_of));
  report.heading(3, "Thin plates, slots, chamfers");
  report.table(head(), on_all_cores(shapes(), row_of));
  fading(report);
  corners_and_tips(report);
  borders(report);
}

}  // namespace spigolo::bench
