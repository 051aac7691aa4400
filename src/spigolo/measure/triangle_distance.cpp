// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/measure/triangle_distance.cpp - regions of the plane around a triangle
// (C. Ericson, Real-Time Collision Detection, 2005, section 5.1.5, describes them)
#include "spigolo/measure/triangle_distance.h"

namespace spigolo {

TriangleFoot nearest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a;
  const double a1 = dot(ab, p - a), a2 = dot(ac, p - a);
  if (a1 <= 0 && a2 <= 0) return {a, TrianglePart::corner0};
  const double b1 = dot(ab, p - b), b2 = dot(ac, p - b);
  if (b1 >= 0 && b2 <= b1) return {b, TrianglePart::corner1};
  const double c1 = dot(ab, p - c), c2 = dot(ac, p - c);
  if (c2 >= 0 && c1 <= c2) return {c, TrianglePart::corner2};

  // areas of the triangles p makes with the edges; not positive: p lies beyond the edge
  const double in_c = a1 * b2 - b1 * a2;
  if (in_c <= 0 && a1 >= 0 && b1 <= 0) return {a + a1 / (a1 - b1) * ab, TrianglePart::edge0};
  const double in_b = c1 * a2 - a1 * c2;
  if (in_b <= 0 && a2 >= 0 && c2 <= 0) return {a + a2 / (a2 - c2) * ac, TrianglePart::edge2};
  const double in_a = b1 * c2 - c1 * b2;
  const double from_b = b2 - b1, from_c = c1 - c2;
  if (in_a <= 0 && from_b >= 0 && from_c >= 0)
    return {b + from_b / (from_b + from_c) * (c - b), TrianglePart::edge1};
  const double sum = in_a + in_b + in_c;
  return {a + in_b / sum * ab + in_c / sum * ac, TrianglePart::inside};
}

}  // namespace spigolo
