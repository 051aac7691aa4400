// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/blend_report.cpp
#include "blend_report.h"

#include <algorithm>
#include <cstdio>

#include "report.h"

namespace spigolo {
namespace {

Json degrees_json(const MeanMax& value) {
  return {{"mean", degrees(value.mean)}, {"max", degrees(value.max)}};
}

Json border_json(const BorderReport& b) {
  const CollarQuality& q = b.quality;
  return {{"start", b.start},
          {"closed", b.closed},
          {"lines", b.lines},
          {"lines_missed", b.missed},
          {"angle_deg", {{"min", degrees(b.angle_min)}, {"max", degrees(b.angle_max)}}},
          {"height", {{"min", b.height_min}, {"max", b.height_max}}},
          {"width", {{"min", b.width_min}, {"max", b.width_max}}},
          {"gap", q.gap},
          {"normal_error_deg",
           {{"nurbs", degrees_json(q.face_error)}, {"cloud", degrees_json(q.cloud_error)}}},
          {"ripple", q.ripple},
          {"turn_deg", degrees_json(q.turn)},
          {"nearest_cv", q.nearest_cv},
          {"nearest_min", q.nearest_min},
          {"removed", b.removed},
          {"nurbs_points", b.nurbs_points},
          {"collar_points", b.collar_points}};
}

std::string fixed(double value, int digits) {
  char text[48];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::string range_text(double low, double high) {
  const std::string a = fixed(low, 1), b = fixed(high, 1);
  return a == b ? a : a + " to " + b;
}

std::size_t count_of(const Blend& blend, BlendSource source) {
  return static_cast<std::size_t>(std::count(blend.source.begin(), blend.source.end(), source));
}

}  // namespace

Json blend_json(const Blend& blend, const std::string& method, const Json& parameters) {
  Json json = {{"points", blend.points.size()},
               {"spacing", blend.spacing},
               {"noise", blend.noise},
               {"removed", blend.removed},
               {"nurbs_points", count_of(blend, BlendSource::nurbs)},
               {"collar_points", count_of(blend, BlendSource::collar)},
               {"non_finite", blend.non_finite},
               {"method", method},
               {"parameters", parameters}};
  if (blend.radius > 0) json["radius"] = blend.radius;
  json["smoothing"] = blend.smoothing;
  json["borders"] = Json::array();
  for (const BorderReport& border : blend.borders) json["borders"].push_back(border_json(border));
  return json;
}

std::string blend_text(const Blend& blend, const std::string& method, double seconds) {
  std::string text =
      count_text(blend.points.size()) + " points, spacing " + number_text(blend.spacing) + ": " +
      count_text(count_of(blend, BlendSource::cloud)) + " of the cloud (" +
      count_text(blend.removed) + " removed), " + count_text(count_of(blend, BlendSource::nurbs)) +
      " of the face, " + count_text(count_of(blend, BlendSource::collar)) + " of the collar\n";
  for (const BorderReport& b : blend.borders) {
    const CollarQuality& q = b.quality;
    text +=
        b.start + (b.closed ? ", closed" : ", open") + ", angle " +
        range_text(degrees(b.angle_min), degrees(b.angle_max)) + " degrees, height " +
        range_text(b.height_min, b.height_max) + ", width " + range_text(b.width_min, b.width_max) +
        " spacings\n  normals off by " + fixed(degrees(q.face_error.mean), 1) + " (at most " +
        fixed(degrees(q.face_error.max), 1) + ") degrees at the face, " +
        fixed(degrees(q.cloud_error.mean), 1) + " (" + fixed(degrees(q.cloud_error.max), 1) +
        ") at the cloud; ripple " + fixed(q.ripple, 4) + ", gap " + fixed(q.gap, 2) + " spacings\n";
  }
  return text + method + ", " + seconds_text(seconds) + "\n";
}

}  // namespace spigolo
