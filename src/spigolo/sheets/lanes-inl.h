// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/lanes-inl.h - the arithmetic of sheet.cpp and symmetric3.cpp, a point a lane
//
// Every formula has the shape and order it has there, so that each lane gets the very bits that
// the scalar code gets. Included once per instruction set.
#include <array>
#include <cmath>
#include <cstddef>

#include "spigolo/core/geometry.h"

#if defined(SPIGOLO_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SPIGOLO_LANES_INL_H
#undef SPIGOLO_LANES_INL_H
#else
#define SPIGOLO_LANES_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace spigolo {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using LaneTag = hn::CappedTag<double, 8>;
using LaneVec = hn::Vec<LaneTag>;
using LaneMask = hn::Mask<LaneTag>;

inline constexpr std::size_t max_lanes = 8;
inline constexpr double lane_curvature_weight = 1e-7;  // as in sheet.cpp
inline constexpr double lane_parallel = 1e-7;          // as in symmetric3.cpp

struct Lanes3 {
  LaneVec x, y, z;
};

inline Lanes3 zero3() {
  const LaneTag d;
  return {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
}
inline Lanes3 add(const Lanes3& a, const Lanes3& b) {
  return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
inline Lanes3 subtract(const Lanes3& a, const Lanes3& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
inline Lanes3 divide(const Lanes3& a, LaneVec s) {
  return {hn::Div(a.x, s), hn::Div(a.y, s), hn::Div(a.z, s)};
}
inline LaneVec dot(const Lanes3& a, const Lanes3& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
inline Lanes3 cross(const Lanes3& a, const Lanes3& b) {
  return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)),
          hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
          hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}
inline Lanes3 select(LaneMask m, const Lanes3& a, const Lanes3& b) {
  return {hn::IfThenElse(m, a.x, b.x), hn::IfThenElse(m, a.y, b.y), hn::IfThenElse(m, a.z, b.z)};
}
inline Lanes3 longer(const Lanes3& a, const Lanes3& b) {  // a of two that are alike
  return select(hn::Lt(dot(a, a), dot(b, b)), b, a);
}

// any_perpendicular; n is a unit vector.
inline Lanes3 perpendicular(const Lanes3& n) {
  const LaneTag d;
  const auto one = hn::Set(d, 1.0), none = hn::Zero(d);
  const auto x = hn::Abs(n.x), y = hn::Abs(n.y), z = hn::Abs(n.z);
  const auto by_x = hn::And(hn::Le(x, y), hn::Le(x, z));
  const auto by_y = hn::AndNot(by_x, hn::Le(y, z));
  const Lanes3 axis = {hn::IfThenElse(by_x, one, none), hn::IfThenElse(by_y, one, none),
                       hn::IfThenElse(hn::Or(by_x, by_y), none, one)};
  const Lanes3 side = cross(n, axis);
  return divide(side, hn::Sqrt(dot(side, side)));
}

struct Frame {
  Lanes3 u, v, n;
  LaneMask sound;  // false where the scalar code has to decide
};

// Symmetric3 of a lane each, and its smallest axis.
struct LaneScatter {
  LaneVec xx, xy, xz, yy, yz, zz;

  void add_outer(const Lanes3& v) {
    xx = hn::Add(xx, hn::Mul(v.x, v.x)), xy = hn::Add(xy, hn::Mul(v.x, v.y));
    xz = hn::Add(xz, hn::Mul(v.x, v.z)), yy = hn::Add(yy, hn::Mul(v.y, v.y));
    yz = hn::Add(yz, hn::Mul(v.y, v.z)), zz = hn::Add(zz, hn::Mul(v.z, v.z));
  }

  LaneVec smallest_eigenvalue() const {
    const LaneTag d;
    const auto mean = hn::Div(hn::Add(hn::Add(xx, yy), zz), hn::Set(d, 3.0));
    const auto a = hn::Sub(xx, mean), b = hn::Sub(yy, mean), c = hn::Sub(zz, mean);
    const auto off = hn::Add(hn::Add(hn::Mul(xy, xy), hn::Mul(xz, xz)), hn::Mul(yz, yz));
    const auto two = hn::Set(d, 2.0);
    const auto p = hn::Sqrt(hn::Div(
        hn::Add(hn::Add(hn::Add(hn::Mul(a, a), hn::Mul(b, b)), hn::Mul(c, c)), hn::Mul(two, off)),
        hn::Set(d, 6.0)));
    const auto determinant = hn::Add(hn::Sub(hn::Mul(a, hn::Sub(hn::Mul(b, c), hn::Mul(yz, yz))),
                                             hn::Mul(xy, hn::Sub(hn::Mul(xy, c), hn::Mul(yz, xz)))),
                                     hn::Mul(xz, hn::Sub(hn::Mul(xy, yz), hn::Mul(b, xz))));
    const auto twice = hn::Mul(two, p);
    HWY_ALIGN double value[max_lanes] = {};
    hn::Store(hn::Div(determinant, hn::Mul(hn::Mul(twice, p), p)), d, value);
    for (std::size_t l = 0; l < hn::Lanes(d); ++l) {
      const double third = std::acos(std::clamp(value[l], -1.0, 1.0)) / 3;
      value[l] = std::cos(third + 2 * pi / 3);
    }
    const auto root = hn::Add(mean, hn::Mul(twice, hn::Load(d, value)));
    return hn::IfThenElse(hn::Eq(p, hn::Zero(d)), mean, root);
  }
};

inline Frame frame_across(const LaneScatter& m) {
  const LaneTag d;
  const auto value = m.smallest_eigenvalue();
  const Lanes3 r0 = {hn::Sub(m.xx, value), m.xy, m.xz}, r1 = {m.xy, hn::Sub(m.yy, value), m.yz},
               r2 = {m.xz, m.yz, hn::Sub(m.zz, value)};
  const Lanes3 best = longer(longer(cross(r0, r1), cross(r0, r2)), cross(r1, r2));
  const Lanes3 widest = longer(longer(r0, r1), r2);
  const auto length = hn::Sqrt(dot(best, best));
  Frame frame;
  frame.sound = hn::Gt(length, hn::Mul(hn::Set(d, lane_parallel), dot(widest, widest)));
  frame.n = divide(best, length);
  frame.u = perpendicular(frame.n);
  frame.v = cross(frame.n, frame.u);
  return frame;
}

using Coefficients = std::array<LaneVec, 6>;

// Signed distance to a quadric, to first order: height() of sheet.cpp.
inline LaneVec height(const Coefficients& a, LaneVec u, LaneVec v, LaneVec w) {
  const LaneTag d;
  const auto two = hn::Set(d, 2.0);
  const auto gu = hn::Add(hn::Add(a[1], hn::Mul(hn::Mul(two, a[3]), u)), hn::Mul(a[4], v));
  const auto gv = hn::Add(hn::Add(a[2], hn::Mul(a[4], u)), hn::Mul(hn::Mul(two, a[5]), v));
  const auto by_u = hn::Mul(u, hn::Add(hn::Add(a[1], hn::Mul(a[3], u)), hn::Mul(a[4], v)));
  const auto by_v = hn::Mul(v, hn::Add(a[2], hn::Mul(a[5], v)));
  const auto off = hn::Sub(w, hn::Add(hn::Add(a[0], by_u), by_v));
  const auto slope = hn::Add(hn::Add(hn::Set(d, 1.0), hn::Mul(gu, gu)), hn::Mul(gv, gv));
  return hn::Div(off, hn::Sqrt(slope));
}

// Sums for the least-squares quadric; the lower triangle, as in fit_quadric().
class NormalEquations {
 public:
  NormalEquations() {
    const LaneTag d;
    for (auto& row : m_) row.fill(hn::Zero(d));
    x_.fill(hn::Zero(d));
  }

  void add(LaneVec u, LaneVec v, LaneVec w) {
    const LaneTag d;
    const Coefficients row = {hn::Set(d, 1.0), u, v, hn::Mul(u, u), hn::Mul(u, v), hn::Mul(v, v)};
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j <= i; ++j) m_[i][j] = hn::Add(m_[i][j], hn::Mul(row[i], row[j]));
      x_[i] = hn::Add(x_[i], hn::Mul(row[i], w));
    }
  }

  // Clears `sound` where the matrix is not positive.
  Coefficients solve(LaneMask& sound) {
    const LaneTag d;
    auto trace = hn::Zero(d);
    for (std::size_t i = 0; i < 6; ++i) trace = hn::Add(trace, m_[i][i]);
    const auto ridge = hn::Mul(hn::Set(d, lane_curvature_weight), trace);
    for (std::size_t i = 3; i < 6; ++i) m_[i][i] = hn::Add(m_[i][i], ridge);
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        auto sum = m_[i][j];
        for (std::size_t k = 0; k < j; ++k) sum = hn::Sub(sum, hn::Mul(m_[i][k], m_[j][k]));
        if (i == j) sound = hn::And(sound, hn::Gt(sum, hn::Zero(d)));
        m_[i][j] = i == j ? hn::Sqrt(sum) : hn::Div(sum, m_[j][j]);
      }
    }
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t k = 0; k < i; ++k) x_[i] = hn::Sub(x_[i], hn::Mul(m_[i][k], x_[k]));
      x_[i] = hn::Div(x_[i], m_[i][i]);
    }
    for (std::size_t i = 6; i-- > 0;) {
      for (std::size_t k = i + 1; k < 6; ++k) x_[i] = hn::Sub(x_[i], hn::Mul(m_[k][i], x_[k]));
      x_[i] = hn::Div(x_[i], m_[i][i]);
    }
    return x_;
  }

 private:
  std::array<Coefficients, 6> m_;
  Coefficients x_;
};

}  // namespace HWY_NAMESPACE
}  // namespace spigolo
HWY_AFTER_NAMESPACE();

#endif  // SPIGOLO_LANES_INL_H
