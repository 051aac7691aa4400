// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/index/flattest_half_simd.cpp - a plane a lane; compiled once per instruction set
#include "spigolo/index/flattest_half.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "spigolo/index/flattest_half_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace spigolo {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using PlaneTag = hn::CappedTag<double, 8>;
using PlaneVec = hn::Vec<PlaneTag>;

constexpr std::size_t most_lanes = 8;
constexpr double needle_sine = 0.3;  // planes through thinner triangles say little

struct Around {
  std::array<double, half_of + most_lanes> x{}, y{}, z{}, length{};

  explicit Around(const std::array<Vec3, half_of>& e) {
    for (std::size_t t = 0; t < half_of; ++t)
      x[t] = e[t].x, y[t] = e[t].y, z[t] = e[t].z, length[t] = norm(e[t]);
  }
};

// Distances of all neighbors, one a row, from the planes through the point, neighbor a and those
// from b on. Returns the lanes whose triangle is no needle and to whose plane more than half of the
// neighbors lie closer than `least`.
std::size_t try_planes(const Around& e, std::size_t a, std::size_t b, double least, double* off) {
  const PlaneTag d;
  const auto ax = hn::Set(d, e.x[a]), ay = hn::Set(d, e.y[a]), az = hn::Set(d, e.z[a]);
  const auto bx = hn::LoadU(d, &e.x[b]), by = hn::LoadU(d, &e.y[b]), bz = hn::LoadU(d, &e.z[b]);
  auto nx = hn::Sub(hn::Mul(ay, bz), hn::Mul(az, by));
  auto ny = hn::Sub(hn::Mul(az, bx), hn::Mul(ax, bz));
  auto nz = hn::Sub(hn::Mul(ax, by), hn::Mul(ay, bx));
  const auto length = hn::Sqrt(hn::Add(hn::Add(hn::Mul(nx, nx), hn::Mul(ny, ny)), hn::Mul(nz, nz)));
  const auto widest = hn::Mul(hn::Set(d, needle_sine * e.length[a]), hn::LoadU(d, &e.length[b]));
  const auto wide = hn::AndNot(hn::Lt(length, widest), hn::Gt(length, hn::Zero(d)));
  nx = hn::Div(nx, length), ny = hn::Div(ny, length), nz = hn::Div(nz, length);
  const auto limit = hn::Set(d, least), one = hn::Set(d, 1.0);
  auto closer = hn::Zero(d);
  for (std::size_t t = 0; t < half_of; ++t, off += hn::Lanes(d)) {
    const auto x = hn::Mul(nx, hn::Set(d, e.x[t])), y = hn::Mul(ny, hn::Set(d, e.y[t])),
               z = hn::Mul(nz, hn::Set(d, e.z[t]));
    const auto away = hn::Abs(hn::Add(hn::Add(x, y), z));
    hn::StoreU(away, d, off);
    closer = hn::Add(closer, hn::IfThenElseZero(hn::Lt(away, limit), one));
  }
  constexpr std::size_t middle = half_of / 2;
  const auto half = hn::Gt(closer, hn::Set(d, static_cast<double>(middle)));
  const auto found = hn::And(hn::And(wide, half), hn::FirstN(d, half_of - b));
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(d, found, bits);
  return bits[0];
}

double find(const std::array<Vec3, half_of>& neighbors) {
  const Around e(neighbors);
  const std::size_t lanes = hn::Lanes(PlaneTag());
  double least = infinity;
  std::array<double, half_of * most_lanes> off;
  std::array<double, half_of> sorted;
  for (std::size_t a = 0; a < half_of; ++a) {
    for (std::size_t b = a + 1; b < half_of; b += lanes) {
      const std::size_t found = try_planes(e, a, b, least, off.data());
      for (std::size_t l = 0; l < lanes; ++l) {
        if ((found >> l & 1) == 0) continue;
        for (std::size_t t = 0; t < half_of; ++t) sorted[t] = off[t * lanes + l];
        std::nth_element(sorted.begin(), sorted.begin() + half_of / 2, sorted.end());
        least = std::min(least, sorted[half_of / 2]);
      }
    }
  }
  return least;
}

}  // namespace HWY_NAMESPACE
}  // namespace spigolo
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace spigolo {

HWY_EXPORT(find);

double flattest_half(const std::array<Vec3, half_of>& neighbors) {
  return HWY_DYNAMIC_DISPATCH(find)(neighbors);
}

}  // namespace spigolo
#endif  // HWY_ONCE
