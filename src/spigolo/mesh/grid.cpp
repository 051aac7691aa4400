// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/grid.cpp - determinants in doubles with an error bound, else in 128-bit integers
#include "spigolo/mesh/grid.h"

#include "spigolo/core/random.h"

namespace spigolo {
namespace {

__extension__ using Wide = __int128;
using Int = std::int64_t;

int sign_of(Wide x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

// Coordinates differ by less than 2^23: products of two take 46 bits, of three 70 bits.
struct IntVec {
  Int x, y, z;
  IntVec(const GridPoint& a, const GridPoint& b)
      : x(static_cast<Int>(a.x - b.x)),
        y(static_cast<Int>(a.y - b.y)),
        z(static_cast<Int>(a.z - b.z)) {}
  Int lift() const { return x * x + y * y + z * z; }
};

Wide determinant(const IntVec& a, const IntVec& b, const IntVec& c) {
  return Wide{a.x} * (b.y * c.z - b.z * c.y) + Wide{a.y} * (b.z * c.x - b.x * c.z) +
         Wide{a.z} * (b.x * c.y - b.y * c.x);
}

int exact_in_sphere(const IntVec& a, const IntVec& b, const IntVec& c, const IntVec& d) {
  // expanded along the column of squared lengths: below 2^121
  return sign_of(a.lift() * determinant(b, c, d) - b.lift() * determinant(a, c, d) +
                 c.lift() * determinant(a, b, d) - d.lift() * determinant(a, b, c));
}

double largest(double a, double b, double c, double d) {
  return std::max(std::max(std::abs(a), std::abs(b)), std::max(std::abs(c), std::abs(d)));
}

}  // namespace

GridPoint Grid::place(const Vec3& p, double jitter, std::uint64_t seed) const {
  Random random(seed);
  const Vec3 q = (p - origin) * scale;
  const auto snap = [&](double x) { return std::round(x + random.uniform(-jitter, jitter)); };
  const double x = snap(q.x), y = snap(q.y), z = snap(q.z);
  return {x, y, z};
}

Grid make_grid(const Box& bounds) {
  const Vec3 size = bounds.size();
  const double side = std::max({size.x, size.y, size.z});
  return {bounds.empty() ? Vec3{} : bounds.center(), side > 0 ? grid_reach / 2.2 / side : 1};
}

int grid_orient(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d) {
  const Vec3 u = b - a, v = c - a, w = d - a;
  const Vec3 m = cross(v, w);  // exact: 46 bits
  const double det = dot(u, m);
  const double size = std::abs(u.x * m.x) + std::abs(u.y * m.y) + std::abs(u.z * m.z);
  if (std::abs(det) > 1e-15 * size) return det > 0 ? 1 : -1;
  return sign_of(determinant(IntVec(b, a), IntVec(c, a), IntVec(d, a)));
}

int grid_in_sphere(const GridPoint& pa, const GridPoint& pb, const GridPoint& pc,
                   const GridPoint& pd, const GridPoint& e) {
  const Vec3 a = pa - e, b = pb - e, c = pc - e, d = pd - e;
  // minors of x and y and squared lengths are exact; the rest errs by some units of 2^-53
  const double ab = a.x * b.y - b.x * a.y, bc = b.x * c.y - c.x * b.y, cd = c.x * d.y - d.x * c.y;
  const double da = d.x * a.y - a.x * d.y, ac = a.x * c.y - c.x * a.y, bd = b.x * d.y - d.x * b.y;
  const double abc = a.z * bc - b.z * ac + c.z * ab, bcd = b.z * cd - c.z * bd + d.z * bc;
  const double cda = c.z * da + d.z * ac + a.z * cd, dab = d.z * ab + a.z * bd + b.z * da;
  const double la = squared_norm(a), lb = squared_norm(b), lc = squared_norm(c),
               ld = squared_norm(d);
  const double det = (la * bcd - lb * cda) + (lc * dab - ld * abc);
  const double bound = 3e-14 * largest(a.x, b.x, c.x, d.x) * largest(a.y, b.y, c.y, d.y) *
                       largest(a.z, b.z, c.z, d.z) * largest(la, lb, lc, ld);
  if (std::abs(det) > bound) return det > 0 ? 1 : -1;
  return exact_in_sphere(IntVec(pa, e), IntVec(pb, e), IntVec(pc, e), IntVec(pd, e));
}

}  // namespace spigolo
