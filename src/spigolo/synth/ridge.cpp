// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/ridge.cpp - two ruled sheets along a straight edge
#include "spigolo/synth/ridge.h"

#include "spigolo/synth/polyhedron.h"

namespace spigolo {
namespace {

double half_angle(const Ridge& ridge, double u) {
  return (ridge.from + (ridge.to - ridge.from) * u) / 2;
}

}  // namespace

Vec3 ridge_direction(const Ridge& ridge, double u, int side) {
  const double a = half_angle(ridge, u);
  return {0, side * std::sin(a), std::cos(a)};
}

Shape ridge_shape(const std::string& name, const Ridge& ridge) {
  Shape shape;
  shape.name = name;
  const Vec3 edge{ridge.length, 0, 0};
  const double twist = (ridge.to - ridge.from) / 2, width = ridge.width;
  for (const int side : {-1, 1}) {
    auto outer = [=](double u) { return u * edge + width * ridge_direction(ridge, u, side); };
    auto element = [=](double, double v) {
      return width * std::hypot(ridge.length, width * v * twist);
    };
    shape.patches.push_back(
        ruled_patch({[=](double u) { return u * edge; }, outer, element, element(0, 1), 32}));
    shape.borders.push_back(parametric(outer, false, 32));
    for (const double u : {0.0, 1.0}) shape.borders.push_back(segment(u * edge, outer(u)));
  }
  shape.creases.push_back(
      {segment({}, edge), [=](double u) { return pi - 2 * half_angle(ridge, u); }, 1});
  // the ends of the long borders lie farthest out
  shape.radius = bounding_radius({shape.borders[0].at(0),
                                  shape.borders[0].at(1),
                                  shape.borders[3].at(0),
                                  shape.borders[3].at(1),
                                  {},
                                  edge});
  return shape;
}

}  // namespace spigolo
