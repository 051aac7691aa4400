// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/report.h - results as JSON, with the key names of the documentation, and as text
#pragma once

#include <string>

#include "command_line.h"
#include "spigolo/core/geometry.h"
#include "spigolo/core/point_cloud.h"
#include "spigolo/detect/detect.h"
#include "spigolo/index/summary.h"
#include "spigolo/measure/distance.h"
#include "spigolo/mesh/check.h"

namespace spigolo {

struct DetectTimes {
  double read = 0, write = 0, total = 0;  // [s] those of the library are in Detection
};

Json to_json(const Vec3& v);
Json to_json(const DistanceStats& stats);
Json to_json(const CloudSummary& summary);
Json to_json(const MeshCheck& check);
Json attributes_json(const PointCloud& cloud);
Json detect_json(const Detection& detection, const std::string& method, const Json& parameters,
                 const DetectTimes& times);

/// Numbers for people: "12345" as "12 345", lengths with six digits.
std::string count_text(std::size_t n);
std::string number_text(double x);
std::string seconds_text(double seconds);

/// Several lines, each with its end.
std::string detect_text(const Detection& detection, const std::string& method,
                        const DetectTimes& times);
std::string summary_text(const CloudSummary& summary);
std::string check_text(const MeshCheck& check);

/// "float64" and so on.
const char* type_name(ScalarType type);

}  // namespace spigolo
