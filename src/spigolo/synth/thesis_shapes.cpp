// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/thesis_shapes.cpp - the test sets of the thesis (section 3.7)
#include "spigolo/synth/catalogue.h"
#include "spigolo/synth/lattice.h"
#include "spigolo/synth/polyhedron.h"
#include "spigolo/synth/ridge.h"

namespace spigolo {
namespace {

/// A cube about the origin with a hole along z: n samples an edge, m round each rim.
struct HoleLattice {
  std::size_t n, m;
  double h;

  double half() const { return static_cast<double>(n - 1) * h / 2; }
  double radius() const { return static_cast<double>(m) * h / (2 * pi); }
  double at(std::size_t i) const { return (static_cast<double>(i) - double(n - 1) / 2) * h; }
  /// A cap sample; those nearer to the rim than half a spacing give way to it.
  bool keeps(std::size_t i, std::size_t j) const {
    return std::hypot(at(i), at(j)) > radius() + h / 2;
  }
};

std::size_t count(const HoleLattice& s) {
  std::size_t cap = 0;
  for (std::size_t i = 0; i < s.n; ++i)
    for (std::size_t j = 0; j < s.n; ++j) cap += s.keeps(i, j);
  return 2 * cap + 4 * (s.n - 1) * (s.n - 2) + s.m * s.n;
}

std::vector<Vec3> points(const HoleLattice& s) {
  std::vector<Vec3> result;
  const std::size_t last = s.n - 1;
  for (std::size_t i = 0; i <= last; ++i)
    for (std::size_t j = 0; j <= last; ++j)
      for (std::size_t k = 0; k <= last; ++k) {
        const bool cap = (k == 0 || k == last) && s.keeps(i, j);
        if (cap || i == 0 || j == 0 || i == last || j == last)
          result.push_back({s.at(i), s.at(j), s.at(k)});
      }
  for (std::size_t k = 0; k <= last; ++k)
    for (std::size_t a = 0; a < s.m; ++a) {
      const double angle = 2 * pi * static_cast<double>(a) / static_cast<double>(s.m);
      result.push_back({s.radius() * std::cos(angle), s.radius() * std::sin(angle), s.at(k)});
    }
  return result;
}

Construction hole_construction(const std::string& name, const HoleLattice& s) {
  return {drilled_box(name, 2 * s.half() * Vec3{1, 1, 1}, s.radius()), [s] { return points(s); },
          count(s)};
}

/// Interior angle of `planes` from one end of its edge to the other.
constexpr double planes_from = radians(45), planes_to = radians(140);

/// Rows of samples parallel to an edge of `along` samples: `rows` on each side and the edge itself.
std::vector<Vec3> sheet_lattice(std::size_t along, std::size_t rows,
                                const std::function<Vec3(double u, int side)>& direction) {
  std::vector<Vec3> result;
  for (std::size_t i = 0; i < along; ++i) {
    const double x = static_cast<double>(i), u = x / static_cast<double>(along - 1);
    for (std::size_t j = rows; j > 0; --j)
      result.push_back(Vec3{x, 0, 0} + static_cast<double>(j) * direction(u, -1));
    result.push_back({x, 0, 0});
    for (std::size_t j = 1; j <= rows; ++j)
      result.push_back(Vec3{x, 0, 0} + static_cast<double>(j) * direction(u, 1));
  }
  return result;
}

}  // namespace

std::size_t nearest_count(std::size_t wanted, std::size_t usual,
                          const std::function<std::size_t(std::size_t n)>& count) {
  if (wanted == 0) return usual;
  std::size_t low = 2, high = 3;
  while (count(high) < wanted) low = high, high *= 2;
  while (high - low > 1) {
    const std::size_t middle = (low + high) / 2;
    (count(middle) < wanted ? low : high) = middle;
  }
  const auto off = [&](std::size_t n) {
    const std::size_t c = count(n);
    return c < wanted ? wanted - c : c - wanted;
  };
  return off(high) < off(low) ? high : low;
}

Construction make_cube(const SynthOptions& options) {
  auto total = [](std::size_t steps) { return 6 * steps * steps + 2; };
  const std::size_t steps = nearest_count(options.points, 41, total);
  const double side = static_cast<double>(steps);
  auto lattice = [=] { return surface_lattice(block(1, 1, 1), static_cast<int>(steps), side); };
  return {polyhedron_shape("cube", box_polyhedron({}, {side, side, side})), lattice, total(steps)};
}

Construction make_planes(const SynthOptions& options) {
  auto along = [](std::size_t rows) { return (rows * 256 + 6) / 12; };
  const std::size_t rows =
      nearest_count(options.points, 12, [&](std::size_t r) { return along(r) * (2 * r + 1); });
  const std::size_t n = along(rows);
  const Ridge ridge{static_cast<double>(n - 1), static_cast<double>(rows), planes_from, planes_to};
  auto direction = [=](double u, int side) { return ridge_direction(ridge, u, side); };
  return {ridge_shape("planes", ridge), [=] { return sheet_lattice(n, rows, direction); },
          n * (2 * rows + 1)};
}

Construction make_hole(const SynthOptions& options) {
  auto of_edge = [](std::size_t n) { return HoleLattice{n, (137 * (n - 1) + 45) / 90, 1}; };
  const std::size_t n =
      nearest_count(options.points, 91, [&](std::size_t e) { return count(of_edge(e)); });
  return hole_construction("hole", of_edge(n));
}

Construction make_hole17k(const SynthOptions& options) {
  auto of_edge = [](std::size_t n) {
    return HoleLattice{n, (133 * (n - 1) + 24) / 48, 12 / static_cast<double>(n - 1)};
  };
  const std::size_t n =
      nearest_count(options.points, 49, [&](std::size_t e) { return count(of_edge(e)); });
  Construction made = hole_construction("hole17k", of_edge(n));
  made.shape.radius = 8.5;  // as section 3.7.5 states it; the true one is 6 sqrt(3)
  return made;
}

Construction make_wedge(const SynthOptions& options) {
  check_angle(options);
  const std::size_t rows =
      nearest_count(options.points, 20, [](std::size_t r) { return 3 * r * (2 * r + 1); });
  const std::size_t along = 3 * rows;
  const double s = std::sin(options.angle / 2), c = std::cos(options.angle / 2);
  auto direction = [=](double, int side) { return Vec3{0, side * s, c}; };
  const double width = static_cast<double>(rows);
  const Vec3 end{static_cast<double>(along - 1), 0, 0};
  const Vec3 right = width * direction(0, 1), left = width * direction(0, -1);
  const Polyhedron sheets{{{}, end, right, end + right, left, end + left},
                          {{0, 2, 3, 1}, {0, 1, 5, 4}}};
  return {polyhedron_shape("wedge", sheets), [=] { return sheet_lattice(along, rows, direction); },
          along * (2 * rows + 1)};
}

}  // namespace spigolo
