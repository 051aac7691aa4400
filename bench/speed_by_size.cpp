// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/speed_by_size.cpp - what a point costs in small and in large clouds, by stage and by verb,
// as tables and as one picture
#include "line_chart.h"
#include "meter.h"
#include "plain_search.h"
#include "sections.h"
#include "spigolo/detect/detect.h"
#include "spigolo/index/order.h"
#include "spigolo/pipeline/lines.h"
#include "spigolo/pipeline/mesh.h"
#include "spigolo/pipeline/smooth.h"
#include "spigolo/sheets/own_sheet.h"
#include "spigolo/synth/synth.h"
#include "stages.h"

namespace spigolo::bench {
namespace {

using Row = std::vector<std::string>;

constexpr std::size_t plain_k = 16;
constexpr std::size_t least_for_memory = 100000;  // below, pages of the system drown the figure
constexpr std::size_t floor_stages = 3;           // order, tree, neighbors

std::vector<Vec3> random_samples(const std::string& shape, std::size_t points, double noise = 0) {
  SynthOptions options{
      .shape = shape, .sampling = Sampling::random, .points = points, .noise = noise};
  return make_cloud(options).cloud.points;
}

Job with_threads(int threads) {
  Job job;
  job.threads = threads;
  return job;
}

double microseconds(double seconds, std::size_t points) {
  return 1e6 * seconds / static_cast<double>(points);
}

// --- by stage
// -------------------------------------------------------------------------------------

struct Staged {
  std::string name;
  std::vector<Vec3> points;
};

// The column of one cloud: each stage, the floor, all.
Row stage_column(const std::vector<Vec3>& points) {
  const double search = search_seconds(points, plain_k);
  const auto seconds = stage_seconds(points, with_threads(1));
  const auto entry = [&](double s) {
    return number(microseconds(s, points.size()), 3) + " (" + number(s / search, 2) + ")";
  };
  Row column;
  double all = 0, floor = 0;
  for (std::size_t s = 0; s < seconds.size(); ++s) {
    column.push_back(entry(seconds[s]));
    all += seconds[s];
    if (s < floor_stages) floor += seconds[s];
  }
  column.insert(column.end(), {entry(floor), entry(all), number(all / floor, 2)});
  return column;
}

void stage_table(Report& report) {
  report.heading(3, "Detection by stage");
  report.text(
      "One core, no noise: CPU microseconds a point, and in brackets what that is of a plain "
      "search of the 16 nearest neighbors of all points in the same run. The first three stages "
      "are the floor: no method that looks at neighbors can do without them. What is above the "
      "floor is the fit of a sheet to each point's neighbors and, near edges, the judgement.");
  const std::vector<Staged> clouds = {
      {"box, random", random_samples("box", 10000)},
      {"box, random", random_samples("box", 100000)},
      {"box, random", random_samples("box", 1000000)},
      {"torus, random", random_samples("torus", 1000000)},
      {"hole, lattice", make_cloud({.shape = "hole", .points = 896000}).cloud.points}};
  Row head = {"stage"};
  std::vector<Row> rows;
  for (const char* name : stage_names) rows.push_back({name});
  for (const char* name : {"floor", "all", "all / floor"}) rows.push_back({name});
  for (const Staged& cloud : clouds) {
    head.push_back(cloud.name + ", " + std::to_string(cloud.points.size()));
    const Row column = stage_column(cloud.points);
    for (std::size_t s = 0; s < rows.size(); ++s) rows[s].push_back(column[s]);
  }
  report.table(head, rows);
}

// --- by size
// --------------------------------------------------------------------------------------

// Microseconds a point of the three on one thread; seconds of the runs.
struct Cost {
  std::size_t points = 0;
  double detect = 0, search = 0, nanoflann = 0, wall_one = 0, wall_two = 0, cpu_two = 0;
  double alone = 0, bytes = 0;
};

Cost cost_of(const std::vector<Vec3>& points) {
  const std::size_t n = points.size();
  Cost cost{n};
  cost.search = microseconds(search_seconds(points, plain_k), n);
  cost.nanoflann = microseconds(nanoflann_seconds(order_cloud(points).points, plain_k), n);
  const Meter one;
  detect(points, {}, with_threads(1));
  cost.detect = microseconds(one.cpu(), n), cost.wall_one = one.wall();
  cost.bytes = static_cast<double>(one.peak_bytes()) / static_cast<double>(n);
  const Meter two;
  detect(points, {}, with_threads(2));
  cost.wall_two = two.wall(), cost.cpu_two = two.cpu(), cost.alone = two.alone(2);
  return cost;
}

Row row_of(const std::string& name, const Cost& c) {
  return {name,
          std::to_string(c.points),
          number(c.detect, 2),
          number(c.detect / c.search, 2),
          number(c.nanoflann / c.search, 2),
          number(1 / c.detect, 2),
          number(c.wall_two, 2),
          number(c.cpu_two, 2),
          number(c.wall_one / c.wall_two, 2),
          number(100 * c.alone / c.cpu_two) + " %",
          c.points < least_for_memory ? "" : number(c.bytes)};
}

LineChart chart_of(const std::string& name, const std::vector<Cost>& costs) {
  LineChart chart{"detect, " + name, "points", "microseconds a point", {}, {}};
  chart.curves = {{"one thread", {}},
                  {"two threads, wall", {}},
                  {"16 neighbors", {}},
                  {"the same, nanoflann", {}}};
  for (const Cost& c : costs) {
    chart.x.push_back(static_cast<double>(c.points));
    chart.curves[0].second.push_back(c.detect);
    chart.curves[1].second.push_back(microseconds(c.wall_two, c.points));
    chart.curves[2].second.push_back(c.search);
    chart.curves[3].second.push_back(c.nanoflann);
  }
  chart.low = 0.1, chart.high = 100;
  chart.decades = chart.x_decades = true;
  return chart;
}

void size_table(Report& report, bool large, std::vector<LineChart>& charts) {
  report.heading(3, "Detection by size");
  report.text(
      "Random samples, detect() as a whole. Search: 16 nearest neighbors of all points, one core; "
      "nanoflann the same in the same order. Alone: share of the CPU time of the run on two "
      "threads in which only one was at work, as what one thread used more than the other. "
      "Speed-up: wall time of one thread to that of two. Memory: resident at its highest, beyond "
      "the points and beyond what stood before.");
  std::vector<Row> rows;
  for (const char* shape : {"box", "torus"}) {
    std::vector<Cost> costs;
    for (const std::size_t n : {10000u, 30000u, 100000u, 300000u, 1000000u, 3000000u, 10000000u}) {
      if (n > 1000000 && !large) continue;
      costs.push_back(cost_of(random_samples(shape, n)));
      rows.push_back(row_of(shape, costs.back()));
    }
    charts.push_back(chart_of(shape, costs));
  }
  report.table({"shape", "points", "detect [us a point]", "of a search", "nanoflann, of a search",
                "M points/s, one core", "two threads, wall [s]", "CPU [s]", "speed-up", "alone",
                "memory [bytes a point]"},
               rows);
}

// --- by verb
// --------------------------------------------------------------------------------------

struct Verb {
  const char* name;
  void (*run)(const std::vector<Vec3>& points, const Job& job);
};
constexpr Verb verbs[] = {
    {"detect", [](const std::vector<Vec3>& p, const Job& job) { detect(p, {}, job); }},
    {"lines", [](const std::vector<Vec3>& p, const Job& job) { find_lines(p, {}, job); }},
    {"smooth", [](const std::vector<Vec3>& p, const Job& job) { smooth(p, {}, job); }},
    {"mesh", [](const std::vector<Vec3>& p, const Job& job) { mesh_cloud(p, {}, job); }}};

void verb_table(Report& report, bool large, std::vector<LineChart>& charts) {
  report.heading(3, "All verbs by size");
  report.text(
      "Random samples of `boxhole`, no noise, two threads: CPU and wall microseconds a point, what "
      "the CPU time is of a plain search, memory as above. A million points with --large.");
  LineChart chart{"verbs, boxhole", "points", "CPU microseconds a point", {}, {}};
  for (const Verb& verb : verbs) chart.curves.push_back({verb.name, {}});
  chart.low = 1, chart.high = 1000;
  chart.decades = chart.x_decades = true;
  std::vector<Row> rows;
  for (const std::size_t n : {10000u, 30000u, 100000u, 300000u, 1000000u}) {
    if (n > 100000 && !large) continue;
    const std::vector<Vec3> points = random_samples("boxhole", n);
    const double search = microseconds(search_seconds(points, plain_k), n);
    chart.x.push_back(static_cast<double>(n));
    for (std::size_t v = 0; v < std::size(verbs); ++v) {
      const Meter meter;
      verbs[v].run(points, with_threads(2));
      const double cpu = microseconds(meter.cpu(), n), wall = microseconds(meter.wall(), n);
      const double bytes = static_cast<double>(meter.peak_bytes()) / static_cast<double>(n);
      chart.curves[v].second.push_back(cpu);
      rows.push_back({verbs[v].name, std::to_string(n), number(cpu, 1), number(wall, 1),
                      number(cpu / search, 1), n < least_for_memory ? "" : number(bytes)});
    }
  }
  report.table({"verb", "points", "CPU [us a point]", "wall [us a point]", "of a search",
                "memory [bytes a point]"},
               rows);
  charts.push_back(std::move(chart));
}

// --- by noise
// -------------------------------------------------------------------------------------

void noisy_table(Report& report) {
  report.heading(3, "Detection with noise");
  report.text(
      "Random samples of a box, 50 000 points, one core: CPU microseconds a point. The floor is a "
      "search of as many neighbors as the noise found asks for; beyond it are wider looks, "
      "separated sheets and folds around them.");
  std::vector<Row> rows;
  for (const double noise : {0.0, 0.06, 0.25, 0.5}) {
    const std::vector<Vec3> points = random_samples("box", 50000, noise);
    const double start = cpu_seconds();
    const Detection found = detect(points, {}, with_threads(1));
    const double cost = microseconds(cpu_seconds() - start, points.size());
    const std::size_t k = sheet_tolerances(found.noise).k;
    const double floor = microseconds(search_seconds(points, k), points.size());
    rows.push_back({number(noise, 2), number(found.noise, 3), number(cost, 1), std::to_string(k),
                    number(floor, 2), number(cost / floor, 1)});
  }
  report.table({"noise [h]", "noise found [spacings]", "us a point", "k",
                "search of k [us a point]", "of that search"},
               rows);
}

}  // namespace

void speed_by_size(Report& report, const std::filesystem::path& pictures, bool large) {
  std::vector<LineChart> charts;
  stage_table(report);
  size_table(report, large, charts);
  verb_table(report, large, charts);
  report.text("![Cost a point by the number of points](pictures/speed.png)");
  write_line_charts(pictures / "speed.png", charts);
  noisy_table(report);
}

}  // namespace spigolo::bench
