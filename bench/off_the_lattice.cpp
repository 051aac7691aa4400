// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/off_the_lattice.cpp - samples that do not lie on the edges, with and without noise
#include "common.h"
#include "on_all_cores.h"
#include "sections.h"

namespace spigolo::bench {
namespace {

struct Shape {
  const char* name;
  double angle;
};

std::string title(const Shape& shape) {
  std::string text = shape.name;
  if (shape.angle > 0) text.append(" ").append(number(shape.angle));
  return text;
}

struct Case {
  Shape shape;
  Sampling sampling;
  double noise = 0;
};

std::vector<std::string> row_of(const Case& c) {
  const auto& [shape, sampling, noise] = c;
  SynthOptions options{.shape = shape.name,
                       .sampling = sampling,
                       .noise = noise,
                       .seed = 11,
                       .angle = radians(shape.angle > 0 ? shape.angle : 90)};
  const SynthCloud s = make_cloud(options);
  DetectOptions literal = thesis_method();
  literal.sigma = 0.1;
  literal.min_cluster = 0.15;
  const bool ask_literal = noise <= 0.25,
             ask_automatic = noise <= 0.5 || shape.name == std::string("box");
  const Scored fixed = ask_literal ? detect_and_score(s, literal) : Scored{},
               adapted = ask_automatic ? detect_and_score(s, thesis_method()) : Scored{},
               sheets = detect_and_score(s);
  const auto if_asked = [](bool asked, double f1) { return asked ? number(f1, 3) : "-"; };
  return {title(shape),
          sampling == Sampling::blue ? "blue" : "random",
          number(noise, 2),
          if_asked(ask_literal, fixed.tolerant.f1),
          if_asked(ask_literal, fixed.thin.f1),
          if_asked(ask_automatic, adapted.tolerant.f1),
          if_asked(ask_automatic, adapted.thin.f1),
          number(sheets.tolerant.f1, 3),
          number(sheets.thin.f1, 3),
          number(sheets.tolerant.recall, 3),
          number(sheets.tolerant.precision, 3),
          number(sheets.detection.noise, 2)};
}

std::vector<std::string> false_flags(const Case& c) {
  SynthOptions options{.shape = c.shape.name, .sampling = c.sampling, .points = 20000, .seed = 11};
  const SynthCloud s = make_cloud(options);
  const auto per_mille = [&](const DetectOptions& method) {
    const auto flagged = static_cast<double>(detect_and_score(s, method).thin.flagged);
    return number(1000 * flagged / static_cast<double>(s.cloud.size()), 2);
  };
  return {c.shape.name, c.sampling == Sampling::blue ? "blue" : "random",
          per_mille(thesis_method()), per_mille({})};
}

void smooth_shapes(Report& report) {
  report.heading(3, "Shapes without an edge: false flags in 1000 points, without noise");
  std::vector<Case> cases;
  for (const char* shape : {"sphere", "torus", "patch", "fillet-box"})
    for (const Sampling sampling : {Sampling::random, Sampling::blue})
      cases.push_back({{shape, 0}, sampling});
  report.table({"shape", "samples", "`gauss-map`", "`sheets`"}, on_all_cores(cases, false_flags));
}

}  // namespace

void off_the_lattice(Report& report) {
  report.heading(2, "Off the lattice: what the thesis could not see");
  report.text(
      "Random (uniform by area) and blue-noise samples, none placed on an edge; noise is the "
      "standard deviation per axis in spacings h. A sample within .75 h of an edge is a feature. "
      "Tolerant: samples between that and 2 h do not count. Thin: every detected one beyond .75 h "
      "is wrong. Literal: `gauss-map` with sigma 0.1 and smallest cluster 0.15; automatic: both "
      "from the noise found. Where they find next to nothing with less noise, they are not asked "
      "again, but for the box. The thesis's method needs samples on the edges: without them every "
      "triangle at a point misses the second sheet. That is why `sheets` is the default. "
      "Seed 11; its constants were looked at with seed 5 on the same shapes but the last five "
      "(pyramid, steps, cylinder-hole, chamfer-box, lens), which were kept apart.");
  std::vector<Case> cases;
  for (const Shape& shape :
       {Shape{"box", 0}, Shape{"boxhole", 0}, Shape{"wedge", 25}, Shape{"wedge", 60},
        Shape{"wedge", 90}, Shape{"wedge", 120}, Shape{"wedge", 150}, Shape{"wedge", 165},
        Shape{"l-prism", 0}, Shape{"cylinders", 0}, Shape{"cone", 0}, Shape{"star", 0},
        Shape{"plate", 0}, Shape{"pyramid", 0}, Shape{"steps", 0}, Shape{"cylinder-hole", 0},
        Shape{"chamfer-box", 0}, Shape{"lens", 0}})
    for (const Sampling sampling : {Sampling::random, Sampling::blue})
      for (const double noise : {0.0, 0.25, 0.5, 1.0}) cases.push_back({shape, sampling, noise});
  report.table(
      {"shape", "samples", "noise", "literal: tolerant F1", "thin F1", "automatic: tolerant F1",
       "thin F1", "`sheets`: tolerant F1", "thin F1", "recall", "precision", "noise found"},
      on_all_cores(cases, row_of));
  smooth_shapes(report);
}

}  // namespace spigolo::bench
