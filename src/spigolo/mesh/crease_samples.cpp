// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/crease_samples.cpp - creases cut into equal steps
#include "spigolo/mesh/samples.h"

#include <algorithm>

#include "spigolo/mesh/weld.h"

namespace spigolo {
namespace {

// The place at arc length s of a polyline; at[i] is the arc length of its point i.
Vec3 point_at(const std::vector<Vec3>& line, const std::vector<double>& at, double s) {
  const auto next = std::upper_bound(at.begin(), at.end(), s);
  const std::size_t i =
      std::clamp<std::size_t>(static_cast<std::size_t>(next - at.begin()), 1, line.size() - 1);
  const double length = at[i] - at[i - 1];
  return length > 0 ? line[i - 1] + (line[i] - line[i - 1]) * ((s - at[i - 1]) / length) : line[i];
}

// Creases as vertices and segments.
class CreaseSampler {
 public:
  CreaseSampler(const FeatureCurves& network, MeshSamples& samples)
      : network_(network), samples_(samples), corner_(network.corners.size(), no_index) {}

  void run() {
    for (std::size_t c = 0; c < network_.curves.size(); ++c)
      if (network_.curves[c].kind == CurveKind::edge)
        sample(network_.curves[c], static_cast<std::int32_t>(c));
  }

 private:
  std::uint32_t add(const Vec3& p) {
    samples_.position.push_back(p);
    samples_.normal.emplace_back();
    samples_.length.push_back(samples_.step);
    return static_cast<std::uint32_t>(samples_.position.size() - 1);
  }

  std::uint32_t end_vertex(const FeatureCurve& curve, std::size_t end) {
    const Vec3& p = end == 0 || curve.closed ? curve.points.front() : curve.points.back();
    const std::int32_t c = curve.corner[end];
    if (c == no_corner) return add(p);
    std::uint32_t& v = corner_[static_cast<std::size_t>(c)];
    if (v == no_index) v = add(p);
    return v;
  }

  void sample(const FeatureCurve& curve, std::int32_t number) {
    std::vector<Vec3> line = curve.points;
    if (curve.closed) line.push_back(line.front());
    std::vector<double> at(line.size(), 0);
    for (std::size_t i = 1; i < line.size(); ++i)
      at[i] = at[i - 1] + distance(line[i - 1], line[i]);
    const double length = at.back();
    if (!(length > 0)) return;
    const bool loop =
        curve.closed || (curve.corner[0] != no_corner && curve.corner[0] == curve.corner[1]);
    const auto pieces = std::max(loop ? 3LL : 1LL, std::llround(length / samples_.step));
    const std::uint32_t first = end_vertex(curve, 0);
    std::uint32_t before = first;
    for (long long i = 1; i < pieces; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(pieces);
      const std::uint32_t v = add(point_at(line, at, share * length));
      join(before, v, number);
      before = v;
    }
    join(before, curve.closed ? first : end_vertex(curve, 1), number);
  }

  void join(std::uint32_t a, std::uint32_t b, std::int32_t number) {
    if (a == b) return;
    samples_.creases.push_back({a, b});
    samples_.curve.push_back(number);
  }

  const FeatureCurves& network_;
  MeshSamples& samples_;
  std::vector<std::uint32_t> corner_;  // per corner its vertex
};

}  // namespace

MeshSamples sample_creases(const FeatureCurves& network, double step) {
  MeshSamples samples;
  samples.step = step;
  CreaseSampler(network, samples).run();
  weld_creases(samples);
  samples.on_creases = samples.size();
  return samples;
}

void split_creases(MeshSamples& samples, std::span<const std::size_t> which) {
  const std::size_t old = samples.on_creases;
  std::vector<Vec3> middle;
  for (const std::size_t s : which) {
    const auto [a, b] = samples.creases[s];
    middle.push_back((samples.position[a] + samples.position[b]) * 0.5);
    const auto v = static_cast<std::uint32_t>(old + middle.size() - 1);
    samples.creases[s] = {a, v};
    samples.creases.push_back({v, b});
    samples.curve.push_back(samples.curve[s]);
  }
  const auto at = static_cast<std::ptrdiff_t>(old);
  samples.position.insert(samples.position.begin() + at, middle.begin(), middle.end());
  samples.normal.insert(samples.normal.begin() + at, middle.size(), Vec3{});
  samples.length.insert(samples.length.begin() + at, middle.size(), samples.step);
  samples.on_creases += middle.size();
}

}  // namespace spigolo
