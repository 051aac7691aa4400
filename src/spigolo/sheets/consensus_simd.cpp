// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/consensus_simd.cpp - a plane a lane; compiled once per instruction set
#include "spigolo/sheets/consensus.h"

#include <algorithm>
#include <array>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "spigolo/sheets/consensus_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "spigolo/sheets/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace spigolo {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t hypothesis_points = 20;  // neighbors that planes are put through
constexpr double needle_sine = 0.25;           // planes through thinner triangles say little
constexpr std::size_t most_points = 128;

// Offsets from the point, and those of the neighbors that make planes, one array an axis.
struct Around {
  std::array<double, most_points> x, y, z;
  std::array<double, most_points + max_lanes> hx, hy, hz;
  std::size_t size = 0, hypotheses = 0;

  explicit Around(std::span<const Vec3> points) : size(points.size()) {
    for (std::size_t t = 0; t < size; ++t) {
      const Vec3 d = points[t] - points[0];
      x[t] = d.x, y[t] = d.y, z[t] = d.z;
    }
    const std::size_t step = std::max<std::size_t>(1, (size - 1) / hypothesis_points);
    for (std::size_t t = 1; t < size; t += step, ++hypotheses)
      hx[hypotheses] = x[t], hy[hypotheses] = y[t], hz[hypotheses] = z[t];
    for (std::size_t l = 0; l < max_lanes; ++l)
      hx[hypotheses + l] = hy[hypotheses + l] = hz[hypotheses + l] = 0;
  }
};

struct Best {
  double agreement = -1;
  Vec3 normal;
};

// Each point counts 1 on the plane, less off it, nothing from a distance of 1 on.
LaneVec agreement(const Around& around, const Lanes3& scaled) {
  const LaneTag d;
  const auto one = hn::Set(d, 1.0), none = hn::Zero(d);
  auto sum = hn::Zero(d);
  for (std::size_t t = 0; t < around.size; ++t) {
    const Lanes3 p = {hn::Set(d, around.x[t]), hn::Set(d, around.y[t]), hn::Set(d, around.z[t])};
    const auto off = dot(scaled, p);
    const auto share = hn::Sub(one, hn::Mul(off, off));
    sum = hn::Add(sum, hn::IfThenElse(hn::Gt(share, none), share, none));
  }
  return sum;
}

// The planes through the point, hypothesis i and those from j on, as many as there are lanes.
void try_planes(const Around& around, std::size_t i, std::size_t j, double tolerance, Best& best) {
  const LaneTag d;
  const std::size_t n = std::min(hn::Lanes(d), around.hypotheses - j);
  const Lanes3 a = {hn::Set(d, around.hx[i]), hn::Set(d, around.hy[i]), hn::Set(d, around.hz[i])};
  const Lanes3 b = {hn::LoadU(d, &around.hx[j]), hn::LoadU(d, &around.hy[j]),
                    hn::LoadU(d, &around.hz[j])};
  const Lanes3 normal = cross(a, b);
  const auto area = hn::Sqrt(dot(normal, normal));
  const auto least = hn::Mul(hn::Mul(hn::Set(d, needle_sine * needle_sine), dot(a, a)), dot(b, b));
  const auto needle = hn::Lt(hn::Mul(area, area), least);
  if (hn::AllTrue(d, needle)) return;
  const Lanes3 scaled = divide(normal, hn::Mul(area, hn::Set(d, tolerance)));
  // A needle's agreement is worse than any.
  const auto found = hn::IfThenElse(needle, hn::Set(d, -2.0), agreement(around, scaled));
  HWY_ALIGN double value[max_lanes] = {};
  hn::Store(found, d, value);
  std::size_t lane = max_lanes;
  for (std::size_t l = 0; l < n; ++l)
    if (value[l] > best.agreement) best.agreement = value[l], lane = l;
  if (lane == max_lanes) return;
  HWY_ALIGN double x[max_lanes] = {}, y[max_lanes] = {}, z[max_lanes] = {};
  const Lanes3 unit = divide(normal, area);
  hn::Store(unit.x, d, x);
  hn::Store(unit.y, d, y);
  hn::Store(unit.z, d, z);
  best.normal = {x[lane], y[lane], z[lane]};
}

Vec3 consensus(std::span<const Vec3> points, double tolerance) {
  const Around around(points);
  Best best;
  for (std::size_t i = 0; i + 1 < around.hypotheses; ++i)
    for (std::size_t j = i + 1; j < around.hypotheses; j += hn::Lanes(LaneTag()))
      try_planes(around, i, j, tolerance, best);
  return best.normal;
}

}  // namespace HWY_NAMESPACE
}  // namespace spigolo
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace spigolo {

HWY_EXPORT(consensus);

Vec3 consensus_plane(std::span<const Vec3> points, double tolerance) {
  return HWY_DYNAMIC_DISPATCH(consensus)(points, tolerance);
}

}  // namespace spigolo
#endif  // HWY_ONCE
