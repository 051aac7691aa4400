// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/heights_simd.cpp - a point a lane; compiled once per instruction set
#include "spigolo/sheets/heights.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "spigolo/sheets/heights_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "spigolo/sheets/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace spigolo {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

Lanes3 same3(const Vec3& v) {
  const LaneTag d;
  return {hn::Set(d, v.x), hn::Set(d, v.y), hn::Set(d, v.z)};
}

void heights_of(const Sheet& sheet, std::span<const Vec3> points, double* out) {
  const LaneTag d;
  const std::size_t lanes = hn::Lanes(d);
  const Lanes3 origin = same3(sheet.origin), u = same3(sheet.u), v = same3(sheet.v),
               n = same3(sheet.n);
  const auto spacing = hn::Set(d, sheet.spacing);
  Coefficients a;
  for (std::size_t c = 0; c < 6; ++c) a[c] = hn::Set(d, sheet.a[c]);
  const auto height_of = [&](const Vec3* at) HWY_ATTR {
    Lanes3 p;
    hn::LoadInterleaved3(d, &at->x, p.x, p.y, p.z);
    const Lanes3 q = divide(subtract(p, origin), spacing);
    return height(a, dot(q, u), dot(q, v), dot(q, n));
  };
  std::size_t i = 0;
  for (; i + lanes <= points.size(); i += lanes) hn::StoreU(height_of(&points[i]), d, out + i);
  if (i == points.size()) return;
  std::array<Vec3, max_lanes> rest{};
  std::copy(points.begin() + static_cast<std::ptrdiff_t>(i), points.end(), rest.begin());
  HWY_ALIGN double value[max_lanes] = {};
  hn::Store(height_of(rest.data()), d, value);
  std::copy(value, value + (points.size() - i), out + i);
}

}  // namespace HWY_NAMESPACE
}  // namespace spigolo
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace spigolo {

HWY_EXPORT(heights_of);

void heights(const Sheet& sheet, std::span<const Vec3> points, double* out) {
  HWY_DYNAMIC_DISPATCH(heights_of)(sheet, points, out);
}

}  // namespace spigolo
#endif  // HWY_ONCE
