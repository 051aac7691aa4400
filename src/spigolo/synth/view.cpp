// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/view.cpp - what scanners around a shape see of it
#include <optional>

#include "spigolo/core/parallel.h"
#include "spigolo/synth/sampling.h"

namespace spigolo {
namespace {

constexpr double away = 4;          // scanner's distance from the middle, in radii
constexpr int most_steps = 600;     // of a ray; one that creeps along a face is given up
constexpr double near = 1e-4;       // share of the radius where steps follow the tangent plane
constexpr double exact = 1e-13;     // share of the radius that is rounding
constexpr std::size_t coarse = 48;  // rays across, to find the share of them that hits

struct Ball {
  Vec3 center;
  double radius = 0;
};

Ball ball_about(const Shape& shape) {
  const Box box = sampled_box(shape);
  return {box.center(), 0.55 * norm(box.size())};
}

struct Foot {
  Vec3 point;
  double distance = infinity;
};

Foot nearest_foot(const Shape& shape, const Vec3& p) {
  Foot best;
  for (const Patch& patch : shape.patches) {
    const Vec3 q = patch.nearest(p);
    if (const double d = distance(p, q); d < best.distance) best = {q, d};
  }
  return best;
}

/// First point of the surface on a ray, by steps of the distance to the surface (sphere tracing).
std::optional<Vec3> first_hit(const Shape& shape, const Ball& ball, const Vec3& from,
                              const Vec3& direction) {
  const double closest = dot(ball.center - from, direction);
  double t = closest - ball.radius;
  for (int i = 0; i < most_steps && t < closest + ball.radius; ++i) {
    const Vec3 p = from + t * direction;
    const Foot foot = nearest_foot(shape, p);
    if (foot.distance <= exact * ball.radius) return foot.point;
    double step = foot.distance;
    if (step < near * ball.radius) {  // a plane is met exactly; no more than twice the safe step
      const double facing = dot(foot.point - p, direction) / foot.distance;
      step /= std::clamp(facing, 0.5, 1.0);
    }
    t += step;
  }
  return std::nullopt;
}

/// A scanner: rays through the square grid of a plane in front of it.
struct Scanner {
  Frame frame;               // z looks at the middle of the shape
  double half_width = 0;     // of the part of the plane at distance 1 that the shape fills
  double shift[2] = {0, 0};  // of the grid, in its steps
};

/// Directions evenly round the sphere, turned so that none looks along an axis.
Vec3 view_direction(std::size_t i, std::size_t views) {
  const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(views);
  const double turn = static_cast<double>(i) * pi * (3 - std::sqrt(5.0)), r = std::sqrt(1 - z * z);
  const Frame askew = frame_along({}, {0.45, -0.7, 1});
  return normalized(askew.world(r * std::cos(turn + 0.6), r * std::sin(turn + 0.6), z));
}

Scanner make_scanner(const Ball& ball, const Vec3& direction, Random& random) {
  Scanner scanner;
  scanner.frame = frame_along(ball.center + away * ball.radius * direction, -direction);
  scanner.half_width = 1 / std::sqrt(away * away - 1);
  for (double& s : scanner.shift) s = random.uniform();
  return scanner;
}

/// Hits of across x across rays, row by row.
std::vector<Vec3> look(const Shape& shape, const Ball& ball, const Scanner& scanner,
                       std::size_t across, const Job& job) {
  std::vector<std::optional<Vec3>> hits(across * across);
  const double step = 2 * scanner.half_width / static_cast<double>(across);
  parallel_for(job, "scan", across, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      for (std::size_t j = 0; j < across; ++j) {
        const double x = (static_cast<double>(i) + scanner.shift[0]) * step - scanner.half_width;
        const double y = (static_cast<double>(j) + scanner.shift[1]) * step - scanner.half_width;
        const Frame& f = scanner.frame;
        hits[i * across + j] =
            first_hit(shape, ball, f.origin, normalized(x * f.x + y * f.y + f.z));
      }
  });
  std::vector<Vec3> points;
  for (const auto& hit : hits)
    if (hit) points.push_back(*hit);
  return points;
}

}  // namespace

std::vector<Vec3> sample_view(const Shape& shape, std::size_t count, std::size_t views,
                              Random& random, const Job& job) {
  const Ball ball = ball_about(shape);
  std::vector<Scanner> scanners;
  for (std::size_t i = 0; i < views; ++i)
    scanners.push_back(make_scanner(ball, view_direction(i, views), random));
  std::size_t hits = 0;
  for (const Scanner& scanner : scanners) hits += look(shape, ball, scanner, coarse, job).size();
  const double more =
      static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(hits, 1));
  const auto across = static_cast<std::size_t>(std::ceil(coarse * std::sqrt(more)));
  std::vector<Vec3> points;
  for (const Scanner& scanner : scanners) {
    const std::vector<Vec3> seen = look(shape, ball, scanner, across, job);
    points.insert(points.end(), seen.begin(), seen.end());
  }
  return points;
}

}  // namespace spigolo
