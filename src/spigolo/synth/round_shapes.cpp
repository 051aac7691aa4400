// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/round_shapes.cpp - shapes with curved faces: turned, drilled, crossing, open
#include "spigolo/synth/catalogue.h"
#include "spigolo/synth/polyhedron.h"

namespace spigolo {
namespace {

constexpr std::size_t usual_points = 10000;

Frame at_height(double z) { return {{0, 0, z}}; }

Patch disk(const Frame& frame, double radius) { return planar_patch(frame, {{}, {}, radius}); }

ExactCrease rim(const Frame& frame, double radius, double deviation) {
  return {circle(frame, radius), constant(deviation), 1};
}

/// Two cylinders through the origin: the thick one along z, the thin one along x.
struct Crossing {
  double thick = 0.4, thin = 0.25;           // radii
  double thick_half = 0.6, thin_half = 0.8;  // half lengths
  double ratio() const { return thin / thick; }
  /// Where the crossing curve runs at angle a round the thin one: its distance from the z axis'
  /// plane.
  double reach(double a) const {
    const double y = thin * std::cos(a);
    return std::sqrt(thick * thick - y * y);
  }
};

/// Mean over a full turn; the trapezoidal rule converges like a power series for a smooth f.
template <class F>
double mean_over_turn(const F& f) {
  constexpr int steps = 256;
  double sum = 0;
  for (int i = 0; i < steps; ++i) sum += f(2 * pi * i / steps);
  return sum / steps;
}

ExactCrease crossing_curve(const Crossing& c, int side) {
  auto at = [c, side](double t) {
    const double a = 2 * pi * t;
    return Vec3{side * c.reach(a), c.thin * std::cos(a), c.thin * std::sin(a)};
  };
  auto deviation = [c](double t) {
    const double cosine = std::cos(2 * pi * t);
    return std::acos(c.ratio() * cosine * cosine);
  };
  return {parametric(at, true, 64), deviation, -1};
}

void add_walls(const Crossing& c, Shape& shape) {
  const std::vector<Curve> border{shape.creases[0].curve, shape.creases[1].curve};
  // y = thin sin(t): the opening's width 2 thin cos(t), its element of arc thin cos(t) / cos(phi)
  const double opening =
      pi * 2 * mean_over_turn([&](double t) {
        const double s = c.ratio() * std::sin(t);
        return c.thin * c.thin * std::cos(t) * std::cos(t) / std::sqrt(1 - s * s);
      });
  const Patch thick = cylinder_patch(at_height(-c.thick_half), c.thick, 2 * c.thick_half);
  shape.patches.push_back(
      trimmed_patch(thick, {thick.area - 2 * opening,
                            [c](const Vec3& p) { return std::hypot(p.y, p.z) > c.thin; }, border}));

  const Frame along_x{{-c.thin_half, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
  const Patch thin = cylinder_patch(along_x, c.thin, 2 * c.thin_half);
  const double mean_reach = mean_over_turn([&](double a) { return c.reach(a); });
  shape.patches.push_back(
      trimmed_patch(thin, {4 * pi * c.thin * (c.thin_half - mean_reach),
                           [c](const Vec3& p) { return std::hypot(p.x, p.y) > c.thick; }, border}));
}

}  // namespace

Construction make_sphere(const SynthOptions&) {
  Shape shape{.name = "sphere", .radius = 0.5};
  shape.patches.push_back(turned_arc({}, {{}, 0.5, -half_pi, half_pi}));
  return {shape, {}, usual_points};
}

Construction make_torus(const SynthOptions&) {
  Shape shape{.name = "torus", .radius = 0.7};
  shape.patches.push_back(turned_arc({}, {{0.5, 0}, 0.2, 0, 2 * pi}));
  return {shape, {}, usual_points};
}

Construction make_cylinder(const SynthOptions&) {
  constexpr double r = 0.4, height = 1;
  Shape shape{.name = "cylinder", .radius = std::hypot(r, height / 2)};
  shape.patches.push_back(cylinder_patch({}, r, height));
  for (const double z : {0.0, height}) {
    shape.patches.push_back(disk(at_height(z), r));
    shape.creases.push_back(rim(at_height(z), r, half_pi));
  }
  return {shape, {}, usual_points};
}

Construction make_cylinder_hole(const SynthOptions&) {
  constexpr double inner = 0.3, outer = 0.5, height = 0.8;
  Shape shape{.name = "cylinder-hole", .radius = std::hypot(outer, height / 2)};
  for (const double r : {inner, outer}) shape.patches.push_back(cylinder_patch({}, r, height));
  for (const double z : {0.0, height}) {
    const Frame frame = at_height(z);
    shape.patches.push_back(planar_patch(frame, {{}, {}, outer}, {{{}, {}, inner}}));
    for (const double r : {inner, outer}) shape.creases.push_back(rim(frame, r, half_pi));
  }
  return {shape, {}, usual_points};
}

Construction make_cone(const SynthOptions&) {
  constexpr double r = 0.5, height = 1;
  Shape shape{.name = "cone", .radius = (r * r + height * height) / (2 * height)};
  shape.patches.push_back(turned_segment({}, {r, 0}, {0, height}));
  shape.patches.push_back(disk({}, r));
  shape.creases.push_back(rim({}, r, std::acos(-r / std::hypot(r, height))));
  shape.tips.push_back({0, 0, height});
  return {shape, {}, usual_points};
}

Construction make_spike(const SynthOptions& options) {
  check_angle(options);
  constexpr double r = 0.5;
  const double half = options.angle / 2, height = r / std::tan(half);
  Shape shape{.name = "spike"};
  shape.radius = height > r ? (r * r + height * height) / (2 * height) : r;
  shape.patches.push_back(turned_segment({}, {r, 0}, {0, height}));
  shape.patches.push_back(disk({}, r));
  shape.creases.push_back(rim({}, r, half_pi + half));
  shape.tips.push_back({0, 0, height});
  return {shape, {}, usual_points};
}

Construction make_cap(const SynthOptions&) {
  constexpr double r = 0.5, cut = -0.2;  // of the plane, from the center
  const double from = std::asin(cut / r), rim_radius = r * std::cos(from);
  Shape shape{.name = "cap", .radius = r};
  shape.patches.push_back(turned_arc({}, {{}, r, from, half_pi}));
  shape.patches.push_back(disk(at_height(cut), rim_radius));
  shape.creases.push_back(rim(at_height(cut), rim_radius, std::acos(-cut / r)));
  return {shape, {}, usual_points};
}

Construction make_lens(const SynthOptions&) {
  constexpr double offset = 0.8, rim_radius = 0.6;  // of spheres of radius 1
  const double from = std::asin(offset);
  Shape shape{.name = "lens", .radius = rim_radius};
  shape.patches.push_back(turned_arc(at_height(-offset), {{}, 1, from, half_pi}));
  shape.patches.push_back(turned_arc(at_height(offset), {{}, 1, -half_pi, -from}));
  shape.creases.push_back(rim({}, rim_radius, 2 * from));
  return {shape, {}, usual_points};
}

Construction make_boxhole(const SynthOptions&) {
  return {drilled_box("boxhole", {1, 0.8, 0.6}, 0.2), {}, usual_points};
}

Construction make_cylinders(const SynthOptions&) {
  const Crossing c;
  Shape shape{.name = "cylinders"};
  shape.radius = std::max(std::hypot(c.thick, c.thick_half), std::hypot(c.thin, c.thin_half));
  for (const int side : {-1, 1}) shape.creases.push_back(crossing_curve(c, side));
  add_walls(c, shape);
  for (const int side : {-1, 1}) {
    const Frame thick = at_height(side * c.thick_half);
    const Frame thin{{side * c.thin_half, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
    shape.patches.push_back(disk(thick, c.thick));
    shape.patches.push_back(disk(thin, c.thin));
    shape.creases.push_back(rim(thick, c.thick, half_pi));
    shape.creases.push_back(rim(thin, c.thin, half_pi));
  }
  return {shape, {}, usual_points};
}

Construction make_patch(const SynthOptions&) {
  constexpr double twist = 1.2;  // z = twist x y over the unit square about the origin
  auto line = [](double y) {
    return [y](double u) { return Vec3{u - 0.5, y, twist * (u - 0.5) * y}; };
  };
  auto element = [](double u, double v) {
    return std::sqrt(1 + twist * twist * ((u - 0.5) * (u - 0.5) + (v - 0.5) * (v - 0.5)));
  };
  Shape shape{.name = "patch"};
  shape.patches.push_back(ruled_patch({line(-0.5), line(0.5), element, element(0, 0), 32}));
  const std::vector<Vec3> corners{line(-0.5)(0), line(-0.5)(1), line(0.5)(1), line(0.5)(0)};
  for (std::size_t i = 0; i < 4; ++i)
    shape.borders.push_back(segment(corners[i], corners[(i + 1) % 4]));
  shape.radius = bounding_radius(corners);
  return {shape, {}, usual_points};
}

Construction make_dome(const SynthOptions&) {
  Shape shape{.name = "dome", .radius = 0.5};
  shape.patches.push_back(turned_arc({}, {{}, 0.5, 0, half_pi}));
  shape.borders.push_back(circle({}, 0.5));
  return {shape, {}, usual_points};
}

}  // namespace spigolo
