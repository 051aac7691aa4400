// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/report.cpp
#include "report.h"

#include <array>
#include <cstdio>

#include "spigolo/core/features.h"

namespace spigolo {

Json to_json(const Vec3& v) { return Json::array({v.x, v.y, v.z}); }

Json to_json(const DistanceStats& stats) {
  return {{"mean", stats.mean},
          {"rms", stats.rms},
          {"p95", stats.p95},
          {"max", stats.max},
          {"signed_mean", stats.signed_mean},
          {"count", stats.count},
          {"skipped", stats.skipped}};
}

Json to_json(const CloudSummary& summary) {
  Json json = {{"points", summary.points},
               {"distinct", summary.distinct},
               {"duplicates", summary.duplicates},
               {"non_finite", summary.non_finite}};
  json["bounds"] = summary.bounds.empty() ? Json()
                                          : Json{{"min", to_json(summary.bounds.min)},
                                                 {"max", to_json(summary.bounds.max)}};
  json["spacing"] = summary.spacing;
  json["noise"] = summary.noise;
  return json;
}

Json to_json(const MeshCheck& check) {
  return {{"vertices", check.vertices},
          {"edges", check.edges},
          {"triangles", check.triangles},
          {"closed", check.closed()},
          {"manifold", check.manifold()},
          {"oriented", check.oriented()},
          {"self_intersections", check.self_intersections},
          {"degenerate", check.degenerate},
          {"components", check.components},
          {"euler", check.euler},
          {"border_edges", check.border_edges},
          {"border_loops", check.border_loops},
          {"nonmanifold_edges", check.nonmanifold_edges},
          {"nonmanifold_vertices", check.nonmanifold_vertices},
          {"misoriented_edges", check.misoriented_edges},
          {"area", check.area},
          {"volume", check.closed() && check.oriented() ? Json(check.volume) : Json()}};
}

Json attributes_json(const PointCloud& cloud) {
  Json json = Json::array();
  for (const Attribute& a : cloud.attributes)
    json.push_back({{"name", a.name}, {"type", type_name(a.type)}});
  return json;
}

Json detect_json(const Detection& detection, const std::string& method, const Json& parameters,
                 const DetectTimes& times) {
  Json counts;
  const auto of_kind = detection.features.counts();
  for (std::size_t kind = 0; kind < point_kinds; ++kind)
    counts[point_kind_names[kind]] = of_kind[kind];
  return {{"points", detection.features.size()},
          {"spacing", detection.spacing},
          {"noise", detection.noise},
          {"counts", counts},
          {"method", method},
          {"parameters", parameters},
          {"k_used", detection.k},
          {"candidates", detection.candidates},
          {"duplicates", detection.duplicates},
          {"non_finite", detection.non_finite},
          {"degenerate", detection.degenerate},
          {"seconds",
           {{"read", times.read},
            {"index", detection.seconds_index},
            {"detect", detection.seconds_detect},
            {"write", times.write},
            {"total", times.total}}}};
}

std::string count_text(std::size_t n) {
  std::string text = std::to_string(n);
  for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, 1, ' ');
  return text;
}

std::string number_text(double x) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", x);
  return text.data();
}

std::string seconds_text(double seconds) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f s", seconds);
  return text.data();
}

std::string detect_text(const Detection& detection, const std::string& method,
                        const DetectTimes& times) {
  const auto counts = detection.features.counts();
  std::string text = count_text(detection.features.size()) + " points, spacing " +
                     number_text(detection.spacing) + ", noise " + number_text(detection.noise) +
                     " spacings\n";
  for (std::size_t kind = 0; kind < point_kinds; ++kind) {
    if (kind > 0) text += ", ";
    text.append(point_kind_names[kind]).append(" ").append(count_text(counts[kind]));
  }
  return text + "\n" + method + ", k " + std::to_string(detection.k) + ", " +
         seconds_text(times.total) + "\n";
}

std::string summary_text(const CloudSummary& summary) {
  std::string text = "points      " + count_text(summary.points) + "\n";
  if (summary.duplicates > 0) text += "duplicates  " + count_text(summary.duplicates) + "\n";
  if (summary.non_finite > 0) text += "not finite  " + count_text(summary.non_finite) + "\n";
  if (!summary.bounds.empty()) {
    const auto line = [](const Vec3& v) {
      return number_text(v.x) + "  " + number_text(v.y) + "  " + number_text(v.z) + "\n";
    };
    text += "from        " + line(summary.bounds.min) + "to          " + line(summary.bounds.max) +
            "size        " + line(summary.bounds.size());
  }
  text += "spacing     " + number_text(summary.spacing) + "\n";
  return text + "noise       " + number_text(summary.noise) + " spacings\n";
}

std::string check_text(const MeshCheck& check) {
  const auto counted = [](std::size_t n, const char* what) {
    return n == 0 ? std::string() : ", " + count_text(n) + " " + what;
  };
  std::string text = count_text(check.vertices) + " vertices, " + count_text(check.triangles) +
                     " triangles in " + count_text(check.components) +
                     (check.components == 1 ? " piece" : " pieces") + ", Euler number " +
                     std::to_string(check.euler) + "\n";
  text += check.closed() ? "closed" : "open";
  if (!check.closed())
    text += " (" + count_text(check.border_edges) + " border edges in " +
            count_text(check.border_loops) + " loops)";
  text += check.manifold() ? ", manifold" : ", not manifold";
  text += check.oriented() ? ", oriented" : ", not oriented";
  text += counted(check.nonmanifold_edges, "edges with more than two triangles") +
          counted(check.nonmanifold_vertices, "vertices with more than one fan") +
          counted(check.misoriented_edges, "edges with triangles that face opposite ways") +
          counted(check.degenerate, "degenerate triangles");
  return text + ", " + count_text(check.self_intersections) + " self-intersections\n";
}

const char* type_name(ScalarType type) {
  constexpr std::array<const char*, 8> names = {"int8",  "uint8",  "int16",   "uint16",
                                                "int32", "uint32", "float32", "float64"};
  return names[static_cast<std::size_t>(type)];
}

}  // namespace spigolo
