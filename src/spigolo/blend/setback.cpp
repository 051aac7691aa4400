// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/setback.cpp
#include "spigolo/blend/setback.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "spigolo/blend/curve_distance.h"
#include "spigolo/blend/widen.h"
#include "spigolo/core/error.h"

namespace spigolo {
namespace {

// Lengths in spacings.
constexpr double usual_radius = 3, radius_per_smoothing = 2;
constexpr double usual_height = 3;  // of the linear collar; its width is sqrt(2) times that, so
                                    // that on a plane both setbacks are equal
constexpr double least_setback = 2.5, least_possible = 1.5;
const double widest = radians(170);         // angles above count as this
constexpr double window_per_radius = 1.25;  // half of the smoothing window along X
// A sharp edge of the cloud turns its normals so much within that way to both sides. A large ball
// would carry the edge far into the collar.
const double edge_turn = radians(45);
constexpr double edge_reach = 3.5;
constexpr double room_to_start = 1;  // the face goes on this far behind the collar
constexpr double touching = 0.05;    // sine of the angle of two surfaces that nearly touch
constexpr double sharpest = 1e-3;    // [rad] angles below count as this
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

// A ball touches both sides at R cot(angle / 2) from X: wide angles take a larger one.
double reach_per_radius(const Strand& s) { return 1 / std::tan(std::min(s.angle, widest) / 2); }

// Whether the cloud has a sharp edge near that strand: its normals turn within a short way along X.
bool near_edge(const BorderLoop& loop, std::size_t i, double reach) {
  const std::vector<Strand>& s = loop.strands;
  const std::size_t n = s.size();
  std::array<Vec3, 2> normals;
  for (const bool forward : {false, true}) {
    double way = 0;
    std::size_t at = i;
    for (std::size_t step = 1; step < n && way < reach; ++step) {
      if (!loop.closed && (forward ? i + step >= n : step > i)) break;
      const std::size_t next = forward ? (i + step) % n : (i + n - step) % n;
      way += distance(s[at].x, s[next].x);
      at = next;
    }
    normals[forward] = s[at].cloud_normal;
  }
  return angle_between(normals[0], normals[1]) > edge_turn;
}

// `most`: the ball may touch so far from X.
void set_radii(double usual, double spacing, const std::vector<double>& most, BorderLoop& loop) {
  double sharpest_angle = pi;
  for (const Strand& s : loop.strands) sharpest_angle = std::min(sharpest_angle, s.angle);
  std::vector<double> radius;
  for (const Strand& s : loop.strands) {
    const double least = least_setback * spacing / reach_per_radius(s),
                 wanted = widened(usual, loop.widening, s.angle, sharpest_angle);
    radius.push_back(
        near_edge(loop, radius.size(), edge_reach * spacing) ? least : std::max(wanted, least));
  }
  radius = smoothed(radius, parts_of(loop), window_per_radius * usual, loop.closed);
  for (std::size_t i = 0; i < radius.size(); ++i) {
    Strand& s = loop.strands[i];
    s.radius = std::min(radius[i], most[i] / reach_per_radius(s));
  }
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
  if (options.height > 0) return {0, options.height * d, options.width * d, false};
  if (options.method == BlendMethod::linear)
    return {0, usual_height * d, usual_height * std::sqrt(2.0) * d, false};
  const double chosen = std::max(usual_radius, radius_per_smoothing * cloud.smoothing());
  return {(options.radius > 0 ? options.radius : chosen) * d, 0, 0, options.radius <= 0};
}

void set_lengths(const Isolines& isolines, const Setbacks& setbacks, double spacing,
                 std::span<const Vec3> others, BorderLoop& loop) {
  const double least =
      setbacks.radius > 0 ? least_possible * spacing : std::max(setbacks.height, 0.0);
  std::vector<double> most;
  for (const Strand& s : loop.strands) {
    most.push_back(room(isolines, s) - room_to_start * spacing);
    require_room(most.back(), least, spacing, isolines);
  }
  if (others.size() > 1) {
    const CurveDistance gap(others, false);
    std::vector<Neighbor> scratch;
    for (std::size_t i = 0; i < most.size(); ++i)
      most[i] = std::min(most[i], gap.nearest(loop.strands[i].x, scratch).distance / 2);
  }
  if (setbacks.radius > 0) {
    set_radii(setbacks.radius, spacing, most, loop);
    return;
  }
  for (std::size_t i = 0; i < most.size(); ++i) {
    loop.strands[i].height = std::min(setbacks.height, most[i]);
    loop.strands[i].width = setbacks.width;
  }
}

}  // namespace spigolo
