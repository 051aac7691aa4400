// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/curve_score.cpp
#include "curve_score.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "spigolo/trace/place_grid.h"

namespace spigolo::bench {
namespace {

constexpr double step = 0.2;  // [spacings] between the places that are compared

std::vector<Vec3> along_truth(const Shape& shape, double spacing) {
  std::vector<Vec3> places;
  constexpr int fine = 2000;
  for (const ExactCrease& crease : shape.creases) {
    double length = 0, next = 0;
    Vec3 last = crease.curve.at(0);
    for (int i = 0; i <= fine; ++i) {
      const Vec3 p = crease.curve.at(static_cast<double>(i) / fine);
      length += distance(p, last);
      last = p;
      if (length < next) continue;
      places.push_back(p);
      next = length + step * spacing;
    }
  }
  return places;
}

double true_length(const Shape& shape) {
  double sum = 0;
  constexpr int fine = 4000;
  for (const ExactCrease& crease : shape.creases)
    for (int i = 0; i < fine; ++i)
      sum += distance(crease.curve.at(static_cast<double>(i) / fine),
                      crease.curve.at(static_cast<double>(i + 1) / fine));
  return sum;
}

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 d = b - a;
  const double square = squared_norm(d);
  const double t = square > 0 ? std::clamp(dot(p - a, d) / square, 0.0, 1.0) : 0;
  return distance(p, a + d * t);
}

bool same_valences(const FeatureCurves& network, const Shape& shape) {
  std::map<int, int> found, wanted;
  for (const FeatureCorner& corner : network.corners) ++found[corner.valence];
  for (const Corner& corner : shape.corners) ++wanted[corner.valence];
  return found == wanted;
}

}  // namespace

std::vector<Vec3> places_along(const FeatureCurves& network, CurveKind kind,
                               double distance_apart) {
  std::vector<Vec3> places;
  for (const FeatureCurve& curve : network.curves) {
    if (curve.kind != kind) continue;
    const std::size_t n = curve.points.size(), segments = curve.closed ? n : n - 1;
    for (std::size_t i = 0; i < segments; ++i) {
      const Vec3 a = curve.points[i], d = curve.points[(i + 1) % n] - a;
      const double count = std::max(1.0, std::round(norm(d) / distance_apart));
      for (double k = 0; k < count; ++k) places.push_back(a + d * ((k + 0.5) / count));
    }
  }
  return places;
}

std::vector<double> distances_to_curves(const FeatureCurves& network, CurveKind kind,
                                        std::span<const Vec3> queries, double cell) {
  struct Segment {
    Vec3 a, b;
  };
  std::vector<Segment> segments;
  std::vector<Vec3> middles;
  double longest = 0;
  for (const FeatureCurve& curve : network.curves) {
    if (curve.kind != kind) continue;
    const std::size_t n = curve.points.size();
    for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < n; ++i) {
      segments.push_back({curve.points[i], curve.points[(i + 1) % n]});
      middles.push_back((segments.back().a + segments.back().b) / 2);
      longest = std::max(longest, distance(segments.back().a, segments.back().b));
    }
  }
  const PlaceGrid grid(middles, cell);
  std::vector<double> result;
  for (const Vec3& q : queries) {
    double least = infinity;
    for (double r = cell + longest; least > r - longest && r < 1000 * cell; r *= 2)
      grid.within(q, r, [&](std::uint32_t s) {
        least = std::min(least, distance_to_segment(q, segments[s].a, segments[s].b));
      });
    result.push_back(least);
  }
  return result;
}

CurveScore score_curves(const FeatureCurves& network, const Shape& shape, double spacing) {
  CurveScore score;
  score.corners = network.corners.size();
  double length = 0;
  for (const FeatureCurve& curve : network.curves) {
    (curve.kind == CurveKind::edge ? score.curves : score.borders) += 1;
    if (curve.kind == CurveKind::edge) length += curve.length();
  }
  score.right = score.curves == shape.creases.size() && same_valences(network, shape);
  score.length = shape.creases.empty() ? 0 : length / true_length(shape);
  const std::vector<Vec3> places = places_along(network, CurveKind::edge, step * spacing);
  for (const Vec3& p : places) {
    const double off = edge_distance(shape, p) / spacing;
    score.mean_off += off / static_cast<double>(places.size());
    score.most_off = std::max(score.most_off, off);
  }
  const std::vector<Vec3> truth = along_truth(shape, spacing);
  double near = 0;
  for (const double d : distances_to_curves(network, CurveKind::edge, truth, 2 * spacing)) {
    score.most_true = std::max(score.most_true, d / spacing);
    if (d > spacing) continue;
    near += 1;
    score.mean_true += d / spacing;
  }
  score.mean_true = near > 0 ? score.mean_true / near : infinity;
  score.covered = truth.empty() ? 1 : near / static_cast<double>(truth.size());
  for (const FeatureCorner& corner : network.corners)
    score.corner_off =
        std::max(score.corner_off, corner_distance(shape, corner.position) / spacing);
  return score;
}

}  // namespace spigolo::bench
