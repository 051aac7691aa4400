// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/triangle_contact.cpp
#include "spigolo/mesh/triangle_contact.h"

#include <utility>

#include "spigolo/mesh/predicates.h"

namespace spigolo {
namespace {

// The axis a triangle's plane is best seen along.
std::size_t dominant_axis(const TrianglePoints& t) {
  const Vec3 n = cross(t[1] - t[0], t[2] - t[0]);
  const double x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
  return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}

// Closed segments in a plane seen along `axis`, by the signs of their four turns.
bool segments_cross(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, std::size_t axis) {
  const int pa = orient2d(p, q, a, axis), pb = orient2d(p, q, b, axis);
  const int ap = orient2d(a, b, p, axis), aq = orient2d(a, b, q, axis);
  if (pa * pb > 0 || ap * aq > 0) return false;
  if (pa != 0 || pb != 0 || ap != 0 || aq != 0) return true;
  for (std::size_t k = 0; k < 3; ++k)  // on one line: their boxes tell
    if (k != axis && (std::max(p[k], q[k]) < std::min(a[k], b[k]) ||
                      std::max(a[k], b[k]) < std::min(p[k], q[k])))
      return false;
  return true;
}

bool inside(const Vec3& p, const TrianglePoints& t, std::size_t axis) {
  const int a = orient2d(t[0], t[1], p, axis), b = orient2d(t[1], t[2], p, axis),
            c = orient2d(t[2], t[0], p, axis);
  return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}

bool coplanar_segment_meets(const Vec3& p, const Vec3& q, const TrianglePoints& t) {
  const std::size_t axis = dominant_axis(t);
  if (inside(p, t, axis)) return true;
  for (std::size_t i = 0; i < 3; ++i)
    if (segments_cross(p, q, t[i], t[(i + 1) % 3], axis)) return true;
  return false;
}

// Closed segment and closed triangle.
bool segment_meets(const Vec3& p, const Vec3& q, const TrianglePoints& t) {
  const int sp = orient3d(t[0], t[1], t[2], p), sq = orient3d(t[0], t[1], t[2], q);
  if (sp * sq > 0) return false;
  if (sp == 0 && sq == 0) return coplanar_segment_meets(p, q, t);
  const int a = orient3d(p, q, t[0], t[1]), b = orient3d(p, q, t[1], t[2]),
            c = orient3d(p, q, t[2], t[0]);
  return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}

// Turned so that the corners both have in common come first, in the same order.
std::size_t align_shared(TrianglePoints& a, TrianglePoints& b) {
  std::size_t shared = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = shared; j < 3; ++j)
      if (a[i] == b[j]) {
        std::swap(a[i], a[shared]);
        std::swap(b[j], b[shared]);
        ++shared;
        break;
      }
  return shared;
}

// All corners of b strictly on one side of a's plane, those it shares left out.
bool clear_of_plane(const TrianglePoints& a, const TrianglePoints& b, std::size_t first) {
  int side = 0;
  for (std::size_t i = first; i < 3; ++i) {
    const int s = orient3d(a[0], a[1], a[2], b[i]);
    if (s == 0 || s == -side) return false;
    side = s;
  }
  return true;
}

// They share an edge: only a fold onto each other is contact.
bool folded(const TrianglePoints& a, const TrianglePoints& b) {
  if (orient3d(a[0], a[1], a[2], b[2]) != 0) return false;
  const std::size_t axis = dominant_axis(a);
  return orient2d(a[0], a[1], a[2], axis) == orient2d(a[0], a[1], b[2], axis);
}

}  // namespace

bool run_into_each_other(const TrianglePoints& first, const TrianglePoints& second) {
  TrianglePoints a = first, b = second;
  const std::size_t shared = align_shared(a, b);
  if (shared == 3) return true;
  if (shared == 2) return folded(a, b);
  if (clear_of_plane(a, b, shared) || clear_of_plane(b, a, shared)) return false;
  // With one corner shared, whatever more they share reaches the edge opposite to it in one of
  // them.
  if (shared == 1) return segment_meets(a[1], a[2], b) || segment_meets(b[1], b[2], a);
  for (std::size_t i = 0; i < 3; ++i)
    if (segment_meets(a[i], a[(i + 1) % 3], b) || segment_meets(b[i], b[(i + 1) % 3], a))
      return true;
  return false;
}

}  // namespace spigolo
