// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/speed.cpp - cost per point by stage and by size, memory, nearest neighbors beside nanoflann
#include <nanoflann.hpp>

#include "common.h"
#include "meter.h"
#include "sample_mesh.h"
#include "sections.h"
#include "spigolo/index/neighborhoods.h"
#include "spigolo/io/cloud_file.h"
#include "stages.h"

namespace spigolo::bench {
namespace {

struct Times {
  double wall = infinity, cpu = infinity, index = infinity, detect = infinity;
};

// The fastest of a few runs: the least disturbed one.
Times time_detection(const std::vector<Vec3>& points, const DetectOptions& options, int threads,
                     int runs) {
  Job job;
  job.threads = threads;
  Times best;
  for (int run = 0; run < runs; ++run) {
    const double wall = wall_seconds(), cpu = cpu_seconds();
    const Detection detection = detect(points, options, job);
    const double elapsed = wall_seconds() - wall;
    if (elapsed < best.wall)
      best = {elapsed, cpu_seconds() - cpu, detection.seconds_index, detection.seconds_detect};
  }
  return best;
}

std::vector<Vec3> hole(std::size_t points) {
  SynthOptions options;
  options.shape = "hole";
  options.points = points;
  return make_cloud(options).cloud.points;
}

// The same shape again and again: what a point costs must not grow with their number.
std::vector<Vec3> side_by_side(std::size_t copies) {
  const std::vector<Vec3> one = hole(10000);
  const double step = 2 * bounding_box(one).size().x;
  std::vector<Vec3> all;
  for (std::size_t c = 0; c < copies; ++c)
    for (const Vec3& p : one)
      all.push_back(
          p + Vec3{step * static_cast<double>(c % 10), step * static_cast<double>(c / 10), 0});
  return all;
}

void detection_times(Report& report, const std::filesystem::path& data) {
  report.heading(3, "Detection, one core and two");
  report.text(
      "Thesis (Xeon 3.0 GHz): fandisk 41 520 points 19 s, vase 896 000 points 20 min. Best of a "
      "few "
      "runs; wall seconds, CPU seconds of the one-core run in brackets.");
  std::vector<std::vector<std::string>> rows;
  const auto measure = [&](const std::string& name, const std::vector<Vec3>& points, int runs) {
    for (const bool sheets : {true, false}) {
      const DetectOptions options = sheets ? DetectOptions{} : thesis_method();
      const Times one = time_detection(points, options, 1, runs),
                  two = time_detection(points, options, 2, runs);
      rows.push_back({name, std::to_string(points.size()), sheets ? "`sheets`" : "`gauss-map`",
                      number(one.wall, 2) + " (" + number(one.cpu, 2) + ")", number(two.wall, 2),
                      number(one.wall / two.wall, 2), number(one.index, 2), number(one.detect, 2),
                      number(static_cast<double>(points.size()) / one.wall / 1000, 0)});
    }
  };
  if (!data.empty())
    measure("fandisk, random samples", sample_mesh(read_mesh(data / "fandisk.off"), 41500, 1), 5);
  measure("hole, same proportions", hole(41500), 5);
  measure("hole, same proportions", hole(896000), 2);
  for (const std::size_t copies : {1u, 10u, 100u})
    measure("hole of 10 000 points, " + std::to_string(copies) + " times", side_by_side(copies), 1);
  report.table({"cloud", "points", "method", "one core [s]", "two cores [s]", "speed-up",
                "of it index [s]", "of it detect [s]", "1000 points/s, one core"},
               rows);
}

struct Adaptor {
  const std::vector<Vec3>& points;
  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const { return points[i][axis]; }
  template <class BoundingBox>
  bool kdtree_get_bbox(BoundingBox&) const {
    return false;
  }
};

double nanoflann_seconds(const std::vector<Vec3>& points, std::size_t k) {
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Adaptor>,
                                                   Adaptor, 3>;
  const Adaptor adaptor{points};
  Tree tree(3, adaptor, nanoflann::KDTreeSingleIndexAdaptorParams(10));
  tree.buildIndex();
  std::vector<std::size_t> index(k + 1);
  std::vector<double> squared(k + 1);
  const double start = cpu_seconds();
  for (const Vec3& p : points) {
    nanoflann::KNNResultSet<double> result(k + 1);
    result.init(index.data(), squared.data());
    tree.findNeighbors(result, &p.x, nanoflann::SearchParams());
  }
  return cpu_seconds() - start;
}

void neighbor_times(Report& report) {
  report.heading(3, "k nearest neighbors of all points, one core");
  report.text(
      "CPU seconds of the search alone; both search the same points in the same (Morton) order, "
      "doubles, ties not resolved by nanoflann.");
  const OrderedCloud cloud = order_cloud(hole(1000000));
  const KdTree tree(cloud);
  Job job;
  job.threads = 1;
  std::vector<std::vector<std::string>> rows;
  for (const std::size_t k : {8u, 16u, 20u, 32u}) {
    double ours = infinity, theirs = infinity;
    for (int run = 0; run < 2; ++run) {
      const double start = cpu_seconds();
      find_neighborhoods(tree, k, job);
      ours = std::min(ours, cpu_seconds() - start);
      theirs = std::min(theirs, nanoflann_seconds(cloud.points, k));
    }
    const auto millions = static_cast<double>(cloud.size()) / 1e6;
    rows.push_back({std::to_string(k), number(millions / ours, 2), number(millions / theirs, 2),
                    number(theirs / ours, 2)});
  }
  report.table({"k", "spigolo [M points/s]", "nanoflann [M points/s]", "ratio"}, rows);
}

std::vector<Vec3> random_samples(const std::string& shape, std::size_t points, double noise = 0) {
  SynthOptions options;
  options.shape = shape;
  options.sampling = Sampling::random;
  options.points = points;
  options.noise = noise;
  return make_cloud(options).cloud.points;
}

// Of the k nearest neighbors of all points, on one core, the tree apart.
double search_seconds(std::span<const Vec3> points, std::size_t k) {
  Job job;
  job.threads = 1;
  const OrderedCloud cloud = order_cloud(points, job);
  const KdTree tree(cloud);
  const double start = cpu_seconds();
  find_neighborhoods(tree, k, job);
  return cpu_seconds() - start;
}

void stage_table(Report& report) {
  report.heading(3, "Detection by stage");
  report.text(
      "One core, no noise: CPU microseconds a point, and in brackets what that is of a plain "
      "search "
      "of the 16 nearest neighbors of all points in the same run. The first three stages are the "
      "floor: no method that looks at neighbors can do without them.");
  struct Cloud {
    std::string name;
    std::vector<Vec3> points;
  };
  const std::vector<Cloud> clouds = {{"box, random", random_samples("box", 1000000)},
                                     {"hole, lattice", hole(896000)},
                                     {"torus, random", random_samples("torus", 1000000)}};
  std::vector<std::string> head = {"stage"};
  std::vector<std::vector<std::string>> rows(stage_names.size() + 1);
  for (std::size_t s = 0; s < stage_names.size(); ++s) rows[s].emplace_back(stage_names[s]);
  rows.back().emplace_back("all");
  Job job;
  job.threads = 1;
  for (const Cloud& cloud : clouds) {
    const double search = search_seconds(cloud.points, 16), n = 1e-6 * double(cloud.points.size());
    head.push_back(cloud.name + ", " + std::to_string(cloud.points.size()));
    const auto entry = [&](double s) {
      return number(s / n, 3) + " (" + number(s / search, 2) + ")";
    };
    double all = 0;
    const auto seconds = stage_seconds(cloud.points, job);
    for (std::size_t s = 0; s < seconds.size(); ++s) {
      rows[s].push_back(entry(seconds[s]));
      all += seconds[s];
    }
    rows.back().push_back(entry(all));
  }
  report.table(head, rows);
}

void size_table(Report& report, bool large) {
  report.heading(3, "Detection by size");
  report.text(
      "Random samples of a box, detect() as a whole. Search: 16 nearest neighbors of all points, "
      "one core; nanoflann the same in the same order. Alone: share of the CPU time of the run on "
      "two threads in which only one was at work, as what one thread used more than the other. "
      "Memory: resident at its highest, beyond the points and beyond what stood before.");
  std::vector<std::vector<std::string>> rows;
  for (const std::size_t n : {10000u, 100000u, 1000000u, 10000000u}) {
    if (n > 1000000 && !large) continue;
    const std::vector<Vec3> points = random_samples("box", n);
    const double search = search_seconds(points, 16), count = static_cast<double>(n);
    const double theirs = nanoflann_seconds(order_cloud(points).points, 16);
    Job job;
    job.threads = 1;
    const Meter one;
    detect(points, {}, job);
    const double cpu = one.cpu();
    const auto bytes = static_cast<double>(one.peak_bytes());
    job.threads = 2;
    const Meter two;
    detect(points, {}, job);
    rows.push_back({std::to_string(n), number(1e6 * cpu / count, 2), number(cpu / search, 2),
                    number(theirs / search, 2), number(count / cpu / 1e6, 2), number(two.wall(), 2),
                    number(two.cpu(), 2), number(100 * two.alone(2) / two.cpu()) + " %",
                    n < 100000 ? "" : number(bytes / count)});
  }
  report.table({"points", "detect [us a point]", "of a search", "nanoflann, of a search",
                "M points/s, one core", "two threads, wall [s]", "CPU [s]", "alone",
                "memory [bytes a point]"},
               rows);
}

void noisy_table(Report& report) {
  report.heading(3, "Detection with noise");
  report.text("Random samples of a box, 50 000 points, one core: CPU microseconds a point.");
  std::vector<std::vector<std::string>> rows(1, {"us a point"});
  std::vector<std::string> head = {"noise [spacings]"};
  Job job;
  job.threads = 1;
  for (const double noise : {0.0, 0.06, 0.25, 0.5}) {
    const std::vector<Vec3> points = random_samples("box", 50000, noise);
    const double start = cpu_seconds();
    detect(points, {}, job);
    head.push_back(number(noise, 2));
    rows[0].push_back(
        number(1e6 * (cpu_seconds() - start) / static_cast<double>(points.size()), 1));
  }
  report.table(head, rows);
}

}  // namespace

void speed(Report& report, const std::filesystem::path& data, bool large) {
  report.heading(2, "Speed");
  detection_times(report, data);
  stage_table(report);
  size_table(report, large);
  noisy_table(report);
  neighbor_times(report);
}

}  // namespace spigolo::bench
