// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// Samples put on the edges, as the vertices of meshes are: every edge has them, nothing else is
// one.
#include <gtest/gtest.h>

#include <cmath>

#include "spigolo/core/random.h"
#include "spigolo/detect/detect.h"

namespace spigolo {
namespace {

constexpr int half_length = 14;
constexpr double away_from_borders = 9;

struct Profile {
  std::vector<Vec3> points;
  std::vector<bool> edge;
  Random random{5};

  // Samples along y on the line through (x, z): regular on an edge, shaken along y elsewhere.
  void add_row(double x, double z, bool is_edge) {
    const double shift = is_edge ? 0 : random.uniform();
    for (int j = -half_length; j <= half_length; ++j) {
      const double shake = is_edge ? 0 : random.uniform(-0.25, 0.25);
      points.push_back({x, j + shift + shake, z});
      edge.push_back(is_edge);
    }
  }

  // Rows between two edges, `steps` apart, without its ends.
  void add_wall(const Vec3& from, const Vec3& to, int steps) {
    for (int s = 1; s < steps; ++s) {
      const Vec3 at = from + (to - from) * (s / static_cast<double>(steps));
      add_row(at.x, at.z, false);
    }
  }

  // Between two heights.
  void expect_edges_only(double low, double high) const {
    const Features f = detect(points).features;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec3& p = points[i];
      if (std::abs(p.y) > away_from_borders || std::abs(p.x) > away_from_borders || p.z < low ||
          p.z > high)
        continue;
      const bool marked = f.kind[i] == PointKind::edge || f.kind[i] == PointKind::corner;
      EXPECT_EQ(marked, edge[i]) << p.x << " " << p.y << " " << p.z;
    }
  }
};

// The floor goes on behind the rib, one spacing away, and its walls are as close to each other.
TEST(Placed, RootsAndCrestsOfARibOneSpacingThickAreEdges) {
  Profile cloud;
  cloud.add_wall({-12, 0, 0}, {0, 0, 0}, 12);
  cloud.add_wall({1, 0, 0}, {13, 0, 0}, 12);
  for (const double x : {0.0, 1.0}) {
    cloud.add_row(x, 0, true);
    cloud.add_wall({x, 0, 0}, {x, 0, 6}, 6);
    cloud.add_row(x, 6, true);
  }
  cloud.expect_edges_only(-1, 7);
}

// Steps below it have samples on their edges: so the facets of a rounding, which cross between its
// rows, make no edge of the rows inside.
TEST(Placed, RowsInsideARoundingAreNoEdges) {
  Profile cloud;
  const double radius = 1.7, turn = radians(90);
  cloud.add_wall({-12, 0, 0}, {0, 0, 0}, 12);
  for (int row = 0; row <= 3; ++row) {
    const double a = turn * row / 3;
    cloud.add_row(radius * std::sin(a), radius * std::cos(a) - radius, false);
  }
  cloud.add_wall({radius, 0, -radius}, {radius, 0, -radius - 6}, 6);
  double z = -radius - 6;  // steps from there down, eight edges
  for (int step = 0; step < 4; ++step, z -= 6) {
    const double x = radius + 6 * step;
    cloud.add_row(x, z, true);
    cloud.add_wall({x, 0, z}, {x + 6, 0, z}, 6);
    cloud.add_row(x + 6, z, true);
    cloud.add_wall({x + 6, 0, z}, {x + 6, 0, z - 6}, 6);
  }
  cloud.expect_edges_only(-radius + 0.1, 1);
}

}  // namespace
}  // namespace spigolo
