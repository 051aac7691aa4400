// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/shape.cpp - exact distances to a shape and its features
#include "spigolo/synth/shape.h"

namespace spigolo {

double area(const Shape& shape) {
  double sum = 0;
  for (const Patch& patch : shape.patches) sum += patch.area;
  return sum;
}

double surface_distance(const Shape& shape, const Vec3& p) {
  double best = infinity;
  for (const Patch& patch : shape.patches) best = std::min(best, distance(p, patch.nearest(p)));
  return best;
}

CreaseFoot nearest_crease(const Shape& shape, const Vec3& p) {
  CreaseFoot best;
  for (std::size_t i = 0; i < shape.creases.size(); ++i) {
    const ExactCrease& crease = shape.creases[i];
    const double t = crease.curve.nearest(p);
    const Vec3 q = crease.curve.at(t);
    if (const double d = distance(p, q); d < best.distance)
      best = {i, q, d, crease.deviation(t), crease.convex};
  }
  return best;
}

double edge_distance(const Shape& shape, const Vec3& p) {
  double best = tip_distance(shape, p);
  for (const ExactCrease& crease : shape.creases)
    best = std::min(best, distance(p, nearest_point(crease.curve, p)));
  return best;
}

double corner_distance(const Shape& shape, const Vec3& p) {
  double best = infinity;
  for (const Corner& corner : shape.corners) best = std::min(best, distance(p, corner.position));
  return best;
}

double tip_distance(const Shape& shape, const Vec3& p) {
  double best = infinity;
  for (const Vec3& tip : shape.tips) best = std::min(best, distance(p, tip));
  return best;
}

double border_distance(const Shape& shape, const Vec3& p) {
  double best = infinity;
  for (const Curve& border : shape.borders)
    best = std::min(best, distance(p, nearest_point(border, p)));
  return best;
}

std::function<double(double)> constant(double deviation) {
  return [deviation](double) { return deviation; };
}

}  // namespace spigolo
