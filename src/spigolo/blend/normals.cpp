// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/normals.cpp
#include "spigolo/blend/normals.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "spigolo/core/parallel.h"
#include "spigolo/core/symmetric3.h"

namespace spigolo {
namespace {

constexpr std::size_t fit_points = 12, grain = 4096;
constexpr std::size_t levels = 16;  // of flatness, of a step from sample to sample
constexpr std::uint32_t no_piece = 0xffffffffu;

Vec3 plane_normal(const CloudSide& cloud, std::size_t i) {
  const auto row = cloud.neighbors(i);
  const std::size_t count = std::min(fit_points, row.size());
  Vec3 mean;
  for (std::size_t k = 0; k < count; ++k) mean += cloud.points()[row[k]] - cloud.points()[i];
  mean = cloud.points()[i] + mean / static_cast<double>(count + 1);
  Symmetric3 scatter;
  scatter.add(cloud.points()[i] - mean);
  for (std::size_t k = 0; k < count; ++k) scatter.add(cloud.points()[row[k]] - mean);
  return smallest_axis(scatter).axis;
}

struct Step {
  std::uint32_t from, to;
};

// Steps waiting to be taken, the flattest level first, within a level the last one put in.
class Waiting {
 public:
  void push(const Step& step, double flatness) {
    const auto level = std::min(levels - 1, static_cast<std::size_t>(flatness * levels));
    waiting_[level].push_back(step);
    top_ = std::max(top_, level);
  }
  bool pop(Step& step) {
    while (waiting_[top_].empty()) {
      if (top_ == 0) return false;
      --top_;
    }
    step = waiting_[top_].back();
    waiting_[top_].pop_back();
    return true;
  }

 private:
  std::array<std::vector<Step>, levels> waiting_;
  std::size_t top_ = 0;
};

// Cosine between b's normal and a's, mirrored in the plane between a and b: on a circle, and across
// a symmetric edge, it is 1 or -1.
double carried(const CloudSide& cloud, const std::vector<Vec3>& normal, const Step& s) {
  const Vec3 way = normalized(cloud.points()[s.to] - cloud.points()[s.from]);
  const Vec3& n = normal[s.from];
  return dot(n - way * (2 * dot(n, way)), normal[s.to]);
}

}  // namespace

CloudNormals find_normals(const CloudSide& cloud, const Job& job) {
  const std::size_t n = cloud.points().size();
  CloudNormals out;
  out.normal.resize(n);
  out.piece.assign(n, no_piece);
  parallel_for(job, "normals", n, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) out.normal[i] = plane_normal(cloud, i);
  });
  Waiting waiting;
  const auto leave = [&](std::uint32_t i) {
    const auto row = cloud.neighbors(i);
    for (std::size_t k = 0; k < std::min(fit_points, row.size()); ++k)
      if (out.piece[row[k]] == no_piece) {
        const Step step{i, row[k]};
        waiting.push(step, std::abs(carried(cloud, out.normal, step)));
      }
  };
  for (std::uint32_t seed = 0; seed < n; ++seed) {
    if (out.piece[seed] != no_piece) continue;
    out.piece[seed] = static_cast<std::uint32_t>(out.pieces);
    leave(seed);
    for (Step step; waiting.pop(step);) {
      if (out.piece[step.to] != no_piece) continue;
      out.piece[step.to] = static_cast<std::uint32_t>(out.pieces);
      if (carried(cloud, out.normal, step) < 0) out.normal[step.to] = -out.normal[step.to];
      leave(step.to);
    }
    ++out.pieces;
  }
  return out;
}

double winding_number(const CloudSide& cloud, const CloudNormals& normals, const Vec3& p) {
  const double area = cloud.spacing() * cloud.spacing();
  double sum = 0;
  for (std::size_t i = 0; i < cloud.points().size(); ++i) {
    const Vec3 way = cloud.points()[i] - p;
    const double r = std::max(norm(way), cloud.spacing());
    sum += dot(normals.normal[i], way) / (r * r * r);
  }
  return sum * area / (4 * pi);
}

void point_outward(const CloudSide& cloud, std::span<const BorderLoop> loops,
                   CloudNormals& normals) {
  std::vector<double> vote(normals.pieces, 0);
  std::vector<Neighbor> found;
  for (const BorderLoop& loop : loops)
    for (const Strand& s : loop.strands) {
      cloud.tree().nearest(s.beta, 1, found);
      const std::uint32_t i = found.front().index;
      vote[normals.piece[i]] += dot(normals.normal[i], s.beta_normal);
    }
  for (std::size_t i = 0; i < normals.normal.size(); ++i)
    if (vote[normals.piece[i]] < 0) normals.normal[i] = -normals.normal[i];
}

}  // namespace spigolo
