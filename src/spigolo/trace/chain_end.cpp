// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/chain_end.cpp
#include "spigolo/trace/chain_end.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace spigolo {
namespace {

constexpr double model_length = 6;         // [spacings] of the chain that tells how it goes on
constexpr double noisy_model_length = 12;  // [scatters] more
constexpr std::size_t bent_from = 5;       // places; fewer say nothing about a bend
constexpr double parallel_sine2 = 0.01;    // of ends that run side by side
constexpr int newton_steps = 8;
constexpr double anchor = 1e-6;  // weight of the place itself in a common point

LocalCurve model_of(const Chain& chain, int side, double scatter) {
  const auto& all = chain.places;
  const auto at = [&](std::size_t i) { return side == 0 ? all[i] : all[all.size() - 1 - i]; };
  const double limit = model_length + noisy_model_length * scatter;
  std::vector<Vec3> near = {at(0)};
  double length = 0;
  for (std::size_t i = 1; i < all.size(); ++i) {
    length += distance(at(i), at(i - 1));
    if (length > limit && near.size() >= 3) break;
    near.push_back(at(i));
  }
  // From the second to last place outward, lest the outermost one turns the frame.
  const Vec3 inner = near[std::min<std::size_t>(near.size() - 1, 3)];
  const Vec3 outward = normalized(near.front() - inner);
  return fit_local_curve(near, near.front(), outward, {near.size() < bent_from ? 1 : 2, 1e-5});
}

}  // namespace

std::vector<ChainEnd> find_ends(std::span<const Chain> chains, double scatter) {
  std::vector<ChainEnd> ends;
  for (std::size_t c = 0; c < chains.size(); ++c)
    for (int side = 0; side < 2 && !chains[c].closed; ++side)
      ends.push_back({c, side, model_of(chains[c], side, scatter), no_junction});
  return ends;
}

Passing passing(const ChainEnd& end, const Vec3& place) {
  Passing result;
  for (int step = 0; step < newton_steps; ++step) {
    const Vec3 slope = end.model.tangent + end.model.bend * result.u;
    result.u += dot(place - end.model.at(result.u), slope) / squared_norm(slope);
  }
  result.distance = distance(end.model.at(result.u), place);
  return result;
}

double meeting_tolerance(double u, double scatter) {
  return 0.15 + 1.5 * scatter + (0.05 + 0.1 * scatter) * std::max(0.0, u);
}

std::optional<Meeting> meeting(const ChainEnd& a, const ChainEnd& b) {
  Meeting m;
  for (int step = 0; step < newton_steps; ++step) {
    const Vec3 sa = a.model.tangent + a.model.bend * m.u, sb = b.model.tangent + b.model.bend * m.v;
    const Vec3 d = b.model.at(m.v) - a.model.at(m.u);
    const double aa = squared_norm(sa), bb = squared_norm(sb), ab = dot(sa, sb);
    const double determinant = aa * bb - ab * ab;
    if (determinant < parallel_sine2 * aa * bb) return std::nullopt;
    m.u += (dot(sa, d) * bb - dot(sb, d) * ab) / determinant;
    m.v += (dot(sa, d) * ab - dot(sb, d) * aa) / determinant;
    if (!(std::abs(m.u) < 100 && std::abs(m.v) < 100)) return std::nullopt;
  }
  const Vec3 p = a.model.at(m.u), q = b.model.at(m.v);
  m.place = (p + q) / 2;
  m.gap = distance(p, q);
  return m;
}

Vec3 common_point(std::span<const ChainEnd> ends, std::span<const std::size_t> chosen,
                  const Vec3& near) {
  Eigen::Matrix3d m = anchor * Eigen::Matrix3d::Identity();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const std::size_t e : chosen) {
    const double u = passing(ends[e], near).u;
    const Vec3 t = ends[e].model.along(u), d = ends[e].model.at(u) - near;
    const Eigen::Vector3d tangent(t.x, t.y, t.z), offset(d.x, d.y, d.z);
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - tangent * tangent.transpose();
    m += across;
    right += across * offset;
  }
  const Eigen::Vector3d x = m.ldlt().solve(right);
  return near + Vec3{x.x(), x.y(), x.z()};
}

}  // namespace spigolo
