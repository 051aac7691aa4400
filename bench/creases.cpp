// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/creases.cpp - where the crease is said to be, at which angle, convex or not, how surely
#include <array>

#include "common.h"
#include "on_all_cores.h"
#include "sections.h"
#include "truth.h"

namespace spigolo::bench {
namespace {

struct Set {
  const char* shape;
  double angle;        // of a wedge, else 0
  std::size_t points;  // 0: 10000
};

SynthCloud cloud_of(const Set& set, Sampling sampling, double noise, std::uint64_t seed) {
  SynthOptions options{.shape = set.shape, .sampling = sampling};
  options.points = set.points > 0 ? set.points : 10000;
  options.angle = radians(set.angle > 0 ? set.angle : 90);
  options.noise = noise, options.seed = seed;
  return make_cloud(options);
}

std::string name_of(const Set& set) {
  return set.angle > 0 ? std::string(set.shape) + " " + number(set.angle) : set.shape;
}

double at_share(std::vector<double> values, double share) {
  if (values.empty()) return not_a_number;
  const auto last = static_cast<double>(values.size() - 1);
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * last);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Very small numbers in powers of ten; NaN: there was nothing to measure.
std::string small(double value) {
  if (std::isnan(value)) return "-";
  if (!(value < 1e-3)) return number(value, 3);
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.0e", value);
  return value == 0 ? "0" : buffer;
}

std::string degrees_text(double value) { return std::isnan(value) ? "-" : number(value, 2); }

/// Over the marked edge points that lie on an edge.
struct Errors {
  std::vector<double> position;                   // [mean spacings] crease point to the true crease
  std::vector<double> angle;                      // [deg]
  std::array<std::size_t, 3> convex = {0, 0, 0};  // right, wrong, not known
};

Errors errors_of(const SynthCloud& s, const Detection& detection) {
  Errors errors;
  const Features& f = detection.features;
  const auto& truth = s.cloud.find("truth_kind")->values;
  for (std::size_t i = 0; i < f.size(); ++i) {
    if (f.kind[i] != PointKind::edge || truth[i] != 1) continue;
    const CreaseFoot foot = nearest_crease(s.shape, s.exact[i]);
    errors.position.push_back(edge_distance(s.shape, f.crease_point[i]) / mean_spacing(s));
    errors.angle.push_back(std::abs(degrees(f.angle[i] - foot.deviation)));
    errors.convex[f.convex[i] == 0 ? 2 : f.convex[i] == foot.convex ? 0 : 1] += 1;
  }
  return errors;
}

std::string share(std::size_t part, const std::array<std::size_t, 3>& of) {
  const std::size_t whole = of[0] + of[1] + of[2];
  return whole == 0 ? "-" : number(100 * static_cast<double>(part) / static_cast<double>(whole), 1);
}

struct Case {
  Set set;
  Sampling sampling;
  double noise;
};

std::vector<std::string> accuracy_row(const Case& c) {
  const auto& [set, sampling, noise] = c;
  const SynthCloud s = cloud_of(set, sampling, noise, 31);
  const Errors errors = errors_of(s, detect(s.cloud.points));
  const double middle = at_share(errors.position, 0.5), sigma = noise * s.spacing / mean_spacing(s);
  return {name_of(set),
          number(noise, 2),
          std::to_string(errors.position.size()),
          small(middle),
          small(at_share(errors.position, 0.95)),
          noise > 0 && !std::isnan(middle) ? number(middle / sigma, 2) : "-",
          degrees_text(at_share(errors.angle, 0.5)),
          degrees_text(at_share(errors.angle, 0.95)),
          share(errors.convex[0], errors.convex),
          share(errors.convex[1], errors.convex),
          share(errors.convex[2], errors.convex)};
}

constexpr std::array<double, 6> strength_from = {0, 0.2, 0.4, 0.6, 0.8, 0.9};

struct Bin {
  double marks = 0, tolerant = 0, counted = 0, thin = 0, strength = 0;

  void add(const Bin& b) {
    marks += b.marks, tolerant += b.tolerant, counted += b.counted;
    thin += b.thin, strength += b.strength;
  }
};
using Bins = std::array<Bin, strength_from.size()>;

Bins count(const Case& c) {
  const SynthCloud s = cloud_of(c.set, c.sampling, c.noise, 31);
  Bins bins;
  const Features f = detect(s.cloud.points).features;
  const FeatureTruth truth = read_truth(s.cloud, s.spacing, s.lattice);
  const std::vector<std::uint8_t> flags = sharp_flags(f);
  for (std::size_t i = 0; i < f.size(); ++i) {
    if (flags[i] == 0) continue;
    std::size_t b = strength_from.size() - 1;
    while (b > 0 && f.strength[i] < strength_from[b]) --b;
    Bin& bin = bins[b];
    bin.marks += 1, bin.strength += f.strength[i], bin.thin += truth.feature[i];
    if (truth.feature[i] == 0 && truth.edge_distance[i] <= 2 * s.spacing) continue;
    bin.counted += 1, bin.tolerant += truth.feature[i];
  }
  return bins;
}

std::string percent(double part, double whole) {
  return whole > 0 ? number(100 * part / whole, 1) : "-";
}

void calibration(Report& report) {
  report.heading(3, "Strength: of the points with this strength, how many are right");
  report.text(
      "The shapes kept apart (pyramid, steps, cylinder-hole, chamfer-box, lens), random and blue "
      "samples, noise 0, .25 and .5, seed 31. Calibrated means: right = mean strength.");
  std::vector<Case> cases;
  for (const char* shape : {"pyramid", "steps", "cylinder-hole", "chamfer-box", "lens"})
    for (const Sampling sampling : {Sampling::random, Sampling::blue})
      for (const double noise : {0.0, 0.25, 0.5}) cases.push_back({{shape, 0, 0}, sampling, noise});
  Bins bins;
  for (const Bins& of_one : on_all_cores(cases, count))
    for (std::size_t b = 0; b < bins.size(); ++b) bins[b].add(of_one[b]);
  std::vector<std::vector<std::string>> rows;
  for (std::size_t b = 0; b < bins.size(); ++b) {
    const double to = b + 1 < bins.size() ? strength_from[b + 1] : 1;
    rows.push_back({number(strength_from[b], 1) + " to " + number(to, 1), number(bins[b].marks),
                    percent(bins[b].strength, bins[b].marks),
                    percent(bins[b].tolerant, bins[b].counted),
                    percent(bins[b].thin, bins[b].marks)});
  }
  report.table(
      {"strength", "marked points", "mean strength %", "right %, tolerant", "right %, thin"}, rows);
}

}  // namespace

void creases(Report& report) {
  report.heading(2, "Creases: position, angle, convexity, strength");
  report.heading(3, "Position and angle of the crease at marked edge points");
  report.text(
      "Blue samples; position: distance from the crease point that `sheets` gives to the true "
      "crease, in mean spacings (median and 95 %), with noise also over sigma; angle: median and "
      "95 "
      "% of the error in degrees; convex or concave: percent right, wrong and not known. "
      "`cylinder` with 2200 points has curves of radius 10 spacings. Seed 31.");
  std::vector<Case> cases;
  for (const Set& set : {Set{"box", 0, 0}, Set{"l-prism", 0, 0}, Set{"steps", 0, 0},
                         Set{"star", 0, 0}, Set{"wedge", 60, 6000}, Set{"wedge", 120, 6000},
                         Set{"wedge", 150, 6000}, Set{"cylinder", 0, 2200},
                         Set{"cylinder-hole", 0, 0}, Set{"lens", 0, 0}, Set{"cylinders", 0, 0}})
    for (const double noise : {0.0, 0.1, 0.25, 0.5}) cases.push_back({set, Sampling::blue, noise});
  report.table({"shape", "noise", "edge points", "position: median", "95 %", "median / sigma",
                "angle: median [deg]", "95 %", "convexity right %", "wrong %", "not known %"},
               on_all_cores(cases, accuracy_row));
  calibration(report);
}

}  // namespace spigolo::bench
