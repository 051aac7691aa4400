// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/speed.cpp - seconds of both methods on one core and two, nearest neighbors beside nanoflann
#include "common.h"
#include "meter.h"
#include "plain_search.h"
#include "sample_mesh.h"
#include "sections.h"
#include "spigolo/index/neighborhoods.h"
#include "spigolo/io/cloud_file.h"

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
  SynthOptions options{.shape = "hole", .points = points};
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
  for (const std::size_t copies : {1u, 10u})
    measure("hole of 10 000 points, " + std::to_string(copies) + " times", side_by_side(copies), 1);
  report.table({"cloud", "points", "method", "one core [s]", "two cores [s]", "speed-up",
                "of it index [s]", "of it detect [s]", "1000 points/s, one core"},
               rows);
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

}  // namespace

void speed(Report& report, const std::filesystem::path& data, const std::filesystem::path& pictures,
           bool large) {
  report.heading(2, "Speed");
  detection_times(report, data);
  speed_by_size(report, pictures, large);
  neighbor_times(report);
}

}  // namespace spigolo::bench
