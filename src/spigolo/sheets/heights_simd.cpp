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

struct LaneSheet {
  Lanes3 origin, u, v, n;
  LaneVec spacing;
  Coefficients a;

  explicit LaneSheet(const Sheet& s)
      : origin(same3(s.origin)), u(same3(s.u)), v(same3(s.v)), n(same3(s.n)) {
    const LaneTag d;
    spacing = hn::Set(d, s.spacing);
    for (std::size_t c = 0; c < 6; ++c) a[c] = hn::Set(d, s.a[c]);
  }

  LaneVec height_from(const Lanes3& offset) const {
    const Lanes3 q = divide(offset, spacing);
    return height(a, dot(q, u), dot(q, v), dot(q, n));
  }
};

// out[i] = value_of(points[i] - origin), as many points at once as there are lanes.
template <class Value>
void for_offsets(const Lanes3& origin, std::span<const Vec3> points, double* out,
                 const Value& value_of) {
  const LaneTag d;
  const std::size_t lanes = hn::Lanes(d);
  const auto at = [&](const Vec3* first) HWY_ATTR {
    Lanes3 p;
    hn::LoadInterleaved3(d, &first->x, p.x, p.y, p.z);
    return value_of(subtract(p, origin));
  };
  std::size_t i = 0;
  for (; i + lanes <= points.size(); i += lanes) hn::StoreU(at(&points[i]), d, out + i);
  if (i == points.size()) return;
  std::array<Vec3, max_lanes> rest{};
  std::copy(points.begin() + static_cast<std::ptrdiff_t>(i), points.end(), rest.begin());
  HWY_ALIGN double value[max_lanes] = {};
  hn::Store(at(rest.data()), d, value);
  std::copy(value, value + (points.size() - i), out + i);
}

void heights_of(const Sheet& sheet, std::span<const Vec3> points, double* out) {
  const LaneSheet s(sheet);
  for_offsets(s.origin, points, out,
              [&](const Lanes3& offset) HWY_ATTR { return s.height_from(offset); });
}

void explained_by(const Sheet& sheet, std::span<const Vec3> points, const SheetTrust& trust,
                  double* out) {
  const LaneTag d;
  const LaneSheet s(sheet);
  const auto none = hn::Zero(d), one = hn::Set(d, 1.0), limit = hn::Set(d, trust.limit),
             growth = hn::Set(d, trust.growth), known = hn::Set(d, trust.known),
             spacing = hn::Set(d, trust.spacing);
  for_offsets(s.origin, points, out, [&](const Lanes3& offset) HWY_ATTR {
    const auto away = hn::Div(hn::Sqrt(dot(offset, offset)), spacing);
    const auto beyond = hn::Max(none, hn::Sub(away, known));
    const auto allowed = hn::Add(limit, hn::Mul(hn::Mul(growth, beyond), beyond));
    const auto off = hn::Div(s.height_from(offset), allowed);
    return hn::Max(none, hn::Sub(one, hn::Mul(off, off)));
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace spigolo
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace spigolo {

HWY_EXPORT(heights_of);
HWY_EXPORT(explained_by);

void heights(const Sheet& sheet, std::span<const Vec3> points, double* out) {
  HWY_DYNAMIC_DISPATCH(heights_of)(sheet, points, out);
}

void explained(const Sheet& sheet, std::span<const Vec3> points, const SheetTrust& trust,
               double* out) {
  HWY_DYNAMIC_DISPATCH(explained_by)(sheet, points, trust, out);
}

}  // namespace spigolo
#endif  // HWY_ONCE
