// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/smoothers.cpp
#include "smoothers.h"

#include <fstream>

#include "projection.h"
#include "report.h"
#include "spigolo/detect/detect.h"
#include "spigolo/io/cloud_file.h"

namespace spigolo::bench {
namespace {

std::optional<OrientedPoints> read_ply(const fs::path& path) {
  if (!fs::exists(path)) return std::nullopt;
  const PointCloud cloud = read_cloud(path);
  OrientedPoints result{cloud.points, std::vector<Vec3>(cloud.size())};
  for (const std::size_t axis : {0u, 1u, 2u})
    if (const Attribute* n = cloud.find(std::string("n") + "xyz"[axis]))
      for (std::size_t i = 0; i < cloud.size(); ++i) result.normals[i][axis] = n->values[i];
  return result;
}

/// The rows of the points, then those of the queries.
std::optional<Projected> split(const std::optional<OrientedPoints>& rows, const SmoothTask& task) {
  const std::size_t n = task.points.size();
  if (!rows || rows->points.size() != n + task.queries.size()) return std::nullopt;
  const auto at = static_cast<std::ptrdiff_t>(n);
  Projected result;
  result.points.points.assign(rows->points.begin(), rows->points.begin() + at);
  result.points.normals.assign(rows->normals.begin(), rows->normals.begin() + at);
  result.queries.assign(rows->points.begin() + at, rows->points.end());
  return result;
}

std::vector<Vec3> with_queries(const SmoothTask& task) {
  std::vector<Vec3> all = task.points;
  all.insert(all.end(), task.queries.begin(), task.queries.end());
  return all;
}

/// More places than the points go through the library: the program moves the points only.
std::vector<Vec3> project_queries(const std::string& method, const SmoothTask& task) {
  const MlsCloud cloud(task.points);
  const std::vector<PointKind> kind = detect(task.points).features.kind;
  const Projection project = projection_method(method).make(cloud, kind, {});
  std::vector<Vec3> result;
  for (const Vec3& query : task.queries) {
    const SurfacePoint on = project(query);
    result.push_back(on_surface(on.status) ? on.position : Vec3{infinity, infinity, infinity});
  }
  return result;
}

SmoothVariant ours(const std::string& method) {
  return {method, [method](const RivalPlaces& places, const SmoothTask& task) {
            const fs::path out = places.file("smooth.ply");
            fs::remove(out);
            std::optional<Projected> result;
            if (run_rival(places, {places.spigolo, "smooth", places.file("cloud.xyz").string(),
                                   "-o", out.string(), "--method", method, "--quiet"}))
              if (auto rows = read_ply(out))
                result = Projected{*rows, project_queries(method, task)};
            return result;
          }};
}

SmoothVariant pcl(double radius) {
  return {"radius " + number(radius, 1),
          [radius](const RivalPlaces& places, const SmoothTask& task) {
            const fs::path out = places.file("mls.xyz"), all = places.file("all.xyz");
            fs::remove(out);
            write_xyz(all, with_queries(task));
            run_rival(places, {places.program("pcl_mls"), places.file("cloud.xyz").string(),
                               all.string(), out.string(), number(radius * task.spacing, 12)});
            return split(read_xyz(out), task);
          }};
}

/// own: the parameters that only this one of the two filters has.
SmoothVariant meshlab(const std::string& filter, double scale, const std::string& own) {
  const std::string script = "<filter name=\"MLS projection (" + filter + ")\">\n" +
                             filter_parameter("ControlMesh", "RichMesh", "0") +
                             filter_parameter("ProxyMesh", "RichMesh", "1") +
                             filter_parameter("SelectionOnly", "RichBool", "false") +
                             filter_parameter("FilterScale", "RichFloat", number(scale, 2)) +
                             filter_parameter("ProjectionAccuracy", "RichFloat", "0.0001") +
                             filter_parameter("MaxProjectionIters", "RichInt", "15") + own +
                             filter_parameter("MaxSubdivisions", "RichInt", "0") +
                             filter_parameter("ThAngleInDegree", "RichFloat", "2") + "</filter>\n";
  return {"filter scale " + number(scale, 1),
          [script](const RivalPlaces& places, const SmoothTask& task) -> std::optional<Projected> {
            if (!task.oriented) return std::nullopt;
            const fs::path out = places.file("meshlab.ply"), all = places.file("all.xyz");
            fs::remove(out);
            const std::vector<Vec3> proxy = with_queries(task);
            write_xyz(all, proxy, std::vector<Vec3>(proxy.size(), Vec3{0, 0, 1}));
            if (!run_meshlab(places, {places.file("oriented.xyz"), all}, out, script))
              return std::nullopt;
            return split(read_ply(out), task);
          }};
}

SmoothVariant rimls(double scale) { return meshlab("RIMLS", scale, rimls_parameters()); }

SmoothVariant apss(double scale) { return meshlab("APSS", scale, apss_parameters()); }

SmoothVariant bilateral(int k, int rounds) {
  return {
      "k " + std::to_string(k) + ", " + std::to_string(rounds) + " rounds",
      [k, rounds](const RivalPlaces& places, const SmoothTask& task) -> std::optional<Projected> {
        if (!task.oriented) return std::nullopt;
        const fs::path out = places.file("bilateral.xyz");
        fs::remove(out);
        run_rival(places,
                  {places.program("cgal_points"), "bilateral", places.file("oriented.xyz").string(),
                   out.string(), std::to_string(k), "25", std::to_string(rounds)});
        const auto rows = read_xyz(out);
        if (!rows || rows->points.size() != task.points.size()) return std::nullopt;
        return Projected{*rows, {}};
      }};
}

}  // namespace

std::string filter_parameter(const char* name, const char* type, const std::string& value) {
  return std::string("<Param name=\"") + name + "\" type=\"" + type + "\" value=\"" + value +
         "\"/>\n";
}

std::string rimls_parameters() {
  return filter_parameter("SigmaN", "RichFloat", "0.75") +
         filter_parameter("MaxRefittingIters", "RichInt", "3");
}

std::string apss_parameters() {
  return filter_parameter("SphericalParameter", "RichFloat", "1") +
         filter_parameter("AccurateNormal", "RichBool", "true");
}

std::vector<Smoother> smoothers() {
  return {
      {"`smooth --method sheets`", {ours("sheets")}},
      {"`smooth --method feature-line` (thesis)", {ours("feature-line")}},
      {"`smooth --method plain`", {ours("plain")}},
      {"PCL MLS", {pcl(1.5), pcl(2), pcl(3), pcl(4)}},
      {"MeshLab RIMLS", {rimls(1), rimls(1.5), rimls(2), rimls(3), rimls(4)}},
      {"MeshLab APSS", {apss(1), apss(1.5), apss(2), apss(3), apss(4)}},
      {"CGAL bilateral", {bilateral(10, 1), bilateral(16, 1), bilateral(32, 1), bilateral(32, 3)}}};
}

SmoothTask prepare_task(const RivalPlaces& places, std::vector<Vec3> points,
                        std::vector<Vec3> queries, double spacing, int k) {
  SmoothTask task{std::move(points), std::move(queries), spacing, false};
  const fs::path cloud = places.file("cloud.xyz"), oriented = places.file("oriented.xyz");
  write_xyz(cloud, task.points);
  fs::remove(oriented);
  task.oriented = run_rival(places, {places.program("cgal_points"), "normals", cloud.string(),
                                     oriented.string(), std::to_string(k)}) &&
                  fs::exists(oriented);
  return task;
}

bool run_meshlab(const RivalPlaces& places, const std::vector<fs::path>& inputs,
                 const fs::path& output, const std::string& filter) {
  const fs::path script = places.file("filter.mlx");
  std::ofstream(script) << "<!DOCTYPE FilterScript>\n<FilterScript>\n"
                        << filter << "</FilterScript>\n";
  std::vector<std::string> command = {"xvfb-run", "-a", "meshlabserver", "-i"};
  for (const fs::path& input : inputs) command.push_back(input.string());
  command.insert(command.end(), {"-o", output.string(), "-m", "vn", "-s", script.string()});
  return run_rival(places, command);
}

}  // namespace spigolo::bench
