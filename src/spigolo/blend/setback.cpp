// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/setback.cpp
#include "spigolo/blend/setback.h"

#include <algorithm>
#include <cmath>

#include "spigolo/blend/curve_distance.h"
#include "spigolo/core/error.h"

namespace spigolo {
namespace {

// Lengths in spacings.
constexpr double usual_radius = 3, radius_per_smoothing = 2;
constexpr double usual_height = 3;  // of the linear collar; its width is sqrt(2) times that, so
                                    // that on a plane both setbacks are equal
constexpr double least_setback = 2.5, least_possible = 1.5;
constexpr double window_per_radius = 6;  // half of the smoothing window along X
constexpr double room_to_start = 1;      // the face goes on this far behind the collar
constexpr double touching = 0.05;        // sine of the angle of two surfaces that nearly touch
constexpr double sharpest = 1e-3;        // [rad] angles below count as this
constexpr int line_samples = 256;

std::string spacings_text(double x) {
  const double rounded = std::round(x * 100) / 100;
  std::string text = std::to_string(rounded);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

Vec3 along_curve(const BorderLoop& loop, std::size_t i) {
  const std::size_t n = loop.strands.size();
  const std::size_t before = i > 0 ? i - 1 : loop.closed ? n - 1 : 0;
  const std::size_t after = i + 1 < n ? i + 1 : loop.closed ? 0 : n - 1;
  return normalized(loop.strands[after].x - loop.strands[before].x);
}

// How far the face goes on from X to the start, straight.
double room(const Isolines& isolines, const Strand& s) {
  double farthest = 0;
  for (int i = 0; i <= line_samples; ++i) {
    const double at = s.at + (s.line.begin - s.at) * i / line_samples;
    farthest = std::max(farthest, distance(isolines.at(s.line.cross, at).point, s.x));
  }
  return farthest;
}

// Mean over the strands within the window, each weighted by its part of the curve.
std::vector<double> smoothed(const std::vector<double>& values, const std::vector<double>& part,
                             double reach, bool closed) {
  const std::size_t n = values.size();
  std::vector<double> out(n);
  for (std::size_t i = 0; i < n; ++i) {
    double sum = values[i] * part[i], weight = part[i];
    for (const bool forward : {true, false}) {
      double way = 0;
      for (std::size_t step = 1; step < n / 2; ++step) {
        if (!closed && (forward ? i + step >= n : step > i)) break;
        const std::size_t j = forward ? (i + step) % n : (i + n - step) % n;
        way += part[j];
        if (way > reach) break;
        const double w = part[j] * (1 - way / reach);
        sum += values[j] * w, weight += w;
      }
    }
    out[i] = weight > 0 ? sum / weight : values[i];
  }
  return out;
}

std::vector<double> parts_of(const BorderLoop& loop) {
  const std::size_t n = loop.strands.size();
  std::vector<double> part(n, 0);
  for (std::size_t i = 0; i + (loop.closed ? 0 : 1) < n; ++i) {
    const double length = distance(loop.strands[i].x, loop.strands[(i + 1) % n].x);
    part[i] += length / 2;
    part[(i + 1) % n] += length / 2;
  }
  return part;
}

void require_room(double room, double wanted, double spacing, const Isolines& isolines) {
  if (room >= wanted) return;
  throw NoResultError("the collar is wider than the face it runs on: from the intersection to " +
                      isolines.start().name + " there are " + spacings_text(room / spacing) +
                      " spacings, and it needs " + spacings_text(wanted / spacing) +
                      "; take a smaller radius or height, or start farther away");
}

}  // namespace

void set_directions(BorderLoop& loop) {
  for (std::size_t i = 0; i < loop.strands.size(); ++i) {
    Strand& s = loop.strands[i];
    Vec3 along = cross(s.face_normal, s.cloud_normal);
    along = norm(along) > touching ? normalized(along) : along_curve(loop, i);
    const Vec3 in_face = normalized(cross(along, s.face_normal));
    // The line comes from the side of the cloud's normal.
    s.toward_face = dot(in_face, s.cloud_normal) < 0 ? -in_face : in_face;
    const Vec3 in_cloud = normalized(cross(along, s.cloud_normal));
    const bool out = dot(in_cloud, s.face_normal) * loop.side > 0;
    s.toward_cloud = out ? in_cloud : -in_cloud;
    s.angle = std::max(angle_between(s.toward_face, s.toward_cloud), sharpest);
  }
}

Setbacks choose_setbacks(const BlendOptions& options, const CloudSide& cloud) {
  const double d = cloud.spacing();
  if (options.height > 0) return {0, options.height * d, options.width * d};
  if (options.method == BlendMethod::linear)
    return {0, usual_height * d, usual_height * std::sqrt(2.0) * d};
  const double chosen = std::max(usual_radius, radius_per_smoothing * cloud.smoothing());
  return {(options.radius > 0 ? options.radius : chosen) * d, 0, 0};
}

void set_lengths(const Isolines& isolines, const Setbacks& setbacks, double spacing,
                 std::span<const Vec3> others, BorderLoop& loop) {
  const std::size_t n = loop.strands.size();
  std::vector<double> length(n), most(n);
  std::vector<Neighbor> scratch;
  for (std::size_t i = 0; i < n; ++i) {
    const Strand& s = loop.strands[i];
    most[i] = room(isolines, s) - room_to_start * spacing;
    if (setbacks.radius > 0)
      length[i] = std::max(setbacks.radius / std::tan(s.angle / 2), least_setback * spacing);
    else
      length[i] = setbacks.height;
    require_room(most[i], setbacks.radius > 0 ? least_possible * spacing : length[i], spacing,
                 isolines);
    length[i] = std::min(length[i], most[i]);
  }
  if (others.size() > 1) {
    const CurveDistance gap(others, false);
    for (std::size_t i = 0; i < n; ++i)
      length[i] = std::min(length[i], gap.nearest(loop.strands[i].x, scratch).distance / 2);
  }
  if (setbacks.radius > 0)
    length = smoothed(length, parts_of(loop), window_per_radius * setbacks.radius, loop.closed);
  for (std::size_t i = 0; i < n; ++i) {
    loop.strands[i].height = std::min(length[i], most[i]);
    loop.strands[i].width = setbacks.radius > 0 ? length[i] : setbacks.width;
  }
}

}  // namespace spigolo
