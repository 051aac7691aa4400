// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/tubes.cpp
#include "spigolo/render/tubes.h"

namespace spigolo {
namespace {

constexpr double lift = 1.0;  // radii towards the eye: lines on a surface drown neither in its
                              // noise nor in the flat facets of a curved one

struct Tube {
  Projected a, b;
  Color color;
};

std::vector<Tube> tubes_of(const LineLayer& layer, const Camera& camera) {
  std::vector<Tube> tubes;
  for (std::size_t i = 0; i < layer.lines.size(); ++i) {
    const auto& line = layer.lines[i];
    const Color color = layer.colors.empty() ? layer.color : layer.colors[i];
    for (std::size_t k = 0; k < line.size(); ++k) {
      const Vec3 &from = line[k], &to = line[std::min(k + 1, line.size() - 1)];
      if (k > 0 && k + 1 == line.size()) break;
      if (!is_finite(from) || !is_finite(to)) continue;
      const Tube tube{camera.project(from), camera.project(to), color};
      if (tube.a.z > 0 && tube.b.z > 0) tubes.push_back(tube);
    }
  }
  return tubes;
}

PixelBox box_of(const Tube& t, double radius) {
  const PixelBox a = box_around(t.a.x, t.a.y, radius), b = box_around(t.b.x, t.b.y, radius);
  if (a.empty() || b.empty()) return {};
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

void draw_tube(GBuffer& buffer, const PixelBox& tile, const Tube& tube, double radius,
               const Camera& camera) {
  const double dx = tube.b.x - tube.a.x, dy = tube.b.y - tube.a.y, length2 = dx * dx + dy * dy;
  const PixelBox box = intersection(box_of(tube, radius), tile);
  for (int y = box.y0; y < box.y1; ++y)
    for (int x = box.x0; x < box.x1; ++x) {
      const double px = x + 0.5 - tube.a.x, py = y + 0.5 - tube.a.y;
      const double t = length2 > 0 ? std::clamp((px * dx + py * dy) / length2, 0.0, 1.0) : 0.0;
      const double ox = (px - t * dx) / radius, oy = (py - t * dy) / radius;
      const double height2 = 1 - ox * ox - oy * oy;
      if (height2 <= 0) continue;
      const double height = std::sqrt(height2);
      const double z = camera.perspective ? 1 / ((1 - t) / tube.a.z + t / tube.b.z)
                                          : (1 - t) * tube.a.z + t * tube.b.z;
      const double depth = z - (height + lift) * radius * camera.pixel_size(z);
      const Normal n{static_cast<float>(ox), static_cast<float>(-oy), static_cast<float>(-height)};
      buffer.draw(buffer.index(x, y),
                  {static_cast<float>(depth), n, tube.color, Material::mark, 1});
    }
}

}  // namespace

void draw_lines(GBuffer& buffer, const LineLayer& layer, const Camera& camera, double width,
                const Job& job) {
  const std::vector<Tube> tubes = tubes_of(layer, camera);
  const double radius = 0.5 * width;
  const TileBins bins(
      buffer.grid, tubes.size(), [&](std::size_t i) { return box_of(tubes[i], radius); }, job);
  for_each_tile(buffer.grid, "draw lines", job, [&](std::size_t tile, const PixelBox& box) {
    for (const std::uint32_t item : bins.items(tile))
      draw_tube(buffer, box, tubes[item], radius, camera);
  });
}

}  // namespace spigolo
