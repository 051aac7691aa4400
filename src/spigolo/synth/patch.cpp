// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/patch.cpp - flat pieces: polygons and disks with holes
#include "spigolo/synth/patch.h"

namespace spigolo {
namespace {

double length2(const Vec2& a) { return a.x * a.x + a.y * a.y; }
Vec2 minus(const Vec2& a, const Vec2& b) { return {a.x - b.x, a.y - b.y}; }

double loop_area(const Loop& loop) {
  if (loop.radius > 0) return pi * loop.radius * loop.radius;
  double twice = 0;
  for (std::size_t i = 0, n = loop.corners.size(); i < n; ++i) {
    const Vec2 &a = loop.corners[i], &b = loop.corners[(i + 1) % n];
    twice += a.x * b.y - a.y * b.x;
  }
  return std::abs(twice) / 2;
}

bool inside_loop(const Loop& loop, const Vec2& p) {
  if (loop.radius > 0) return length2(minus(p, loop.center)) < loop.radius * loop.radius;
  bool inside = false;
  for (std::size_t i = 0, n = loop.corners.size(); i < n; ++i) {
    const Vec2 &a = loop.corners[i], &b = loop.corners[(i + 1) % n];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

Vec2 nearest_on_segment(const Vec2& a, const Vec2& b, const Vec2& p) {
  const Vec2 d = minus(b, a), e = minus(p, a);
  const double t = std::clamp((e.x * d.x + e.y * d.y) / length2(d), 0.0, 1.0);
  return {a.x + t * d.x, a.y + t * d.y};
}

Vec2 nearest_on_loop(const Loop& loop, const Vec2& p) {
  if (loop.radius > 0) {
    const Vec2 d = minus(p, loop.center);
    const double n = std::sqrt(length2(d));
    if (n == 0) return {loop.center.x + loop.radius, loop.center.y};
    return {loop.center.x + d.x / n * loop.radius, loop.center.y + d.y / n * loop.radius};
  }
  Vec2 best = loop.corners[0];
  for (std::size_t i = 0, n = loop.corners.size(); i < n; ++i) {
    const Vec2 q = nearest_on_segment(loop.corners[i], loop.corners[(i + 1) % n], p);
    if (length2(minus(q, p)) < length2(minus(best, p))) best = q;
  }
  return best;
}

struct Region {
  Loop outer;
  std::vector<Loop> holes;

  bool contains(const Vec2& p) const {
    if (!inside_loop(outer, p)) return false;
    return std::none_of(holes.begin(), holes.end(),
                        [&](const Loop& hole) { return inside_loop(hole, p); });
  }
  Vec2 nearest(const Vec2& p) const {
    if (contains(p)) return p;
    Vec2 best = nearest_on_loop(outer, p);
    for (const Loop& hole : holes) {
      const Vec2 q = nearest_on_loop(hole, p);
      if (length2(minus(q, p)) < length2(minus(best, p))) best = q;
    }
    return best;
  }
  double area() const {
    double a = loop_area(outer);
    for (const Loop& hole : holes) a -= loop_area(hole);
    return a;
  }
};

Box loop_box(const Loop& loop) {
  Box box;
  for (const Vec2& c : loop.corners) box.add({c.x, c.y, 0});
  if (loop.radius > 0) {
    box.add({loop.center.x - loop.radius, loop.center.y - loop.radius, 0});
    box.add({loop.center.x + loop.radius, loop.center.y + loop.radius, 0});
  }
  return box;
}

}  // namespace

Patch planar_patch(const Frame& frame, const Loop& outer, const std::vector<Loop>& holes) {
  const Region region{outer, holes};
  const Box box = loop_box(outer);
  auto sample = [frame, region, box](Random& random) {
    for (;;) {
      const double x = random.uniform(box.min.x, box.max.x);
      const double y = random.uniform(box.min.y, box.max.y);
      if (region.contains({x, y})) return frame.world(x, y, 0);
    }
  };
  auto nearest = [frame, region](const Vec3& p) {
    const Vec3 q = frame.local(p);
    const Vec2 foot = region.nearest({q.x, q.y});
    return frame.world(foot.x, foot.y, 0);
  };
  return {region.area(), sample, nearest};
}

Frame polygon_frame(const std::vector<Vec3>& corners) {
  Vec3 normal;  // Newell's sum: right for polygons with inward corners too
  for (std::size_t i = 0, n = corners.size(); i < n; ++i)
    normal += cross(corners[i] - corners[0], corners[(i + 1) % n] - corners[0]);
  const Vec3 z = normalized(normal), x = normalized(corners[1] - corners[0]);
  return {corners[0], x, cross(z, x), z};
}

Patch polygon_patch(const std::vector<Vec3>& corners, const std::vector<Loop>& holes) {
  const Frame frame = polygon_frame(corners);
  Loop outer;
  for (const Vec3& c : corners) {
    const Vec3 q = frame.local(c);
    outer.corners.push_back({q.x, q.y});
  }
  return planar_patch(frame, outer, holes);
}

}  // namespace spigolo
