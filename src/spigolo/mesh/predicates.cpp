// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/predicates.cpp - floating-point filters, then exact expansions (J. R. Shewchuk,
// Adaptive precision floating-point arithmetic and fast robust geometric predicates, 1997)
#include "spigolo/mesh/predicates.h"

#include <array>
#include <vector>

namespace spigolo {
namespace {

int sign_of(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

// A number as the exact sum of doubles that do not overlap, smallest first, without zeros.
class Expansion {
 public:
  Expansion() = default;
  /// The exact difference of two doubles.
  Expansion(double a, double b) {
    const double sum = a - b, back = sum - a;
    push((a - (sum - back)) + (-b - back));
    push(sum);
  }
  /// Adds a double: GROW-EXPANSION with zeros dropped.
  void add(double x) {
    std::size_t kept = 0;
    for (const double term : terms_) {
      const double sum = x + term, back = sum - x;
      const double tail = (x - (sum - back)) + (term - back);
      if (tail != 0) terms_[kept++] = tail;
      x = sum;
    }
    terms_.resize(kept);
    push(x);
  }
  void add(const Expansion& other, double factor) {
    for (const double term : other.terms_) add(term * factor);
  }
  int sign() const { return terms_.empty() ? 0 : sign_of(terms_.back()); }

  friend Expansion operator*(const Expansion& a, const Expansion& b) {
    Expansion product;
    for (const double x : a.terms_)
      for (const double y : b.terms_) {
        const double high = x * y;
        product.add(std::fma(x, y, -high));
        product.add(high);
      }
    return product;
  }

 private:
  void push(double x) {
    if (x != 0) terms_.push_back(x);
  }
  std::vector<double> terms_;
};

Expansion minus(Expansion a, const Expansion& b) {
  a.add(b, -1);
  return a;
}

int exact_orient3d(const std::array<const Vec3*, 3>& p, const Vec3& d) {
  std::array<std::array<Expansion, 3>, 3> m;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t axis = 0; axis < 3; ++axis) m[row][axis] = Expansion((*p[row])[axis], d[axis]);
  Expansion sum;
  for (std::size_t row = 0; row < 3; ++row) {
    const auto &next = m[(row + 1) % 3], &last = m[(row + 2) % 3];
    sum.add(m[row][2] * minus(next[0] * last[1], last[0] * next[1]), 1);
  }
  return sum.sign();
}

// The determinant in arithmetic of type T: its sign if that is certain, else 2. error: relative
// error bound of the type, Shewchuk's o3derrboundA with room to spare.
template <class T>
int filtered_orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, T error) {
  const T adx = T(a.x) - T(d.x), ady = T(a.y) - T(d.y), adz = T(a.z) - T(d.z);
  const T bdx = T(b.x) - T(d.x), bdy = T(b.y) - T(d.y), bdz = T(b.z) - T(d.z);
  const T cdx = T(c.x) - T(d.x), cdy = T(c.y) - T(d.y), cdz = T(c.z) - T(d.z);
  const T bc = bdx * cdy, cb = cdx * bdy, ca = cdx * ady, ac = adx * cdy, ab = adx * bdy,
          ba = bdx * ady;
  const T det = adz * (bc - cb) + bdz * (ca - ac) + cdz * (ab - ba);
  const T size = std::abs(adz) * (std::abs(bc) + std::abs(cb)) +
                 std::abs(bdz) * (std::abs(ca) + std::abs(ac)) +
                 std::abs(cdz) * (std::abs(ab) + std::abs(ba));
  if (size == 0) return 0;
  if (det > error * size) return 1;
  return -det > error * size ? -1 : 2;
}

constexpr double error_double = 8e-16;                                               // 7.2 ulp / 2
constexpr long double error_long = 8 * std::numeric_limits<long double>::epsilon();  // likewise

}  // namespace

int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  int sign = filtered_orient3d<double>(a, b, c, d, error_double);
  if (sign != 2) return sign;
  sign = filtered_orient3d<long double>(a, b, c, d, error_long);
  return sign != 2 ? sign : exact_orient3d({&a, &b, &c}, d);
}

int orient2d(const Vec3& a, const Vec3& b, const Vec3& c, std::size_t axis) {
  const std::size_t x = (axis + 1) % 3, y = (axis + 2) % 3;
  const double left = (a[x] - c[x]) * (b[y] - c[y]), right = (a[y] - c[y]) * (b[x] - c[x]);
  const double det = left - right, size = std::abs(left) + std::abs(right);
  if (std::abs(det) > 4e-16 * size) return sign_of(det);
  return minus(Expansion(a[x], c[x]) * Expansion(b[y], c[y]),
               Expansion(a[y], c[y]) * Expansion(b[x], c[x]))
      .sign();
}

}  // namespace spigolo
