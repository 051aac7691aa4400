// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/normals.cpp
#include <array>

#include "spigolo/render/light.h"

namespace spigolo {
namespace {

constexpr double step_in_spacings = 0.45;
constexpr double slope_tolerance = 0.06;  // differences this alike are averaged against noise

// The slope of depth per pixel along (dx, dy), from both sides, the straighter one counting more.
// ok is false where neither side has depths.
struct Slope {
  double value = 0;
  bool ok = false;
};

Slope slope(const GBuffer& buffer, int x, int y, int dx, int dy, double tolerance) {
  const double z = static_cast<double>(buffer.depth_at(x, y));
  double sum = 0, weights = 0;
  for (const int side : {-1, 1}) {
    const auto at = [&](int k) {
      return static_cast<double>(buffer.depth_at(x + side * k * dx, y + side * k * dy));
    };
    const double near = at(1), far = at(2);
    if (!std::isfinite(near)) continue;
    // Without a second depth the side can only be the last resort.
    const double bend = std::isfinite(far) ? 2 * near - far - z : 100 * (near - z);
    const double weight = 1 / (bend * bend + tolerance * tolerance);
    sum += weight * side * (near - z) / (dx + dy), weights += weight;
  }
  return weights > 0 ? Slope{sum / weights, true} : Slope{};
}

Normal normal_of(const Camera& camera, double x, double y, double z, double zx, double zy) {
  const double unit = camera.pixel_size(z);
  Vec3 along_x{unit, 0, zx}, along_y{0, -unit, zy};
  if (camera.perspective) {
    const Vec3 p = camera.unproject(x, y, z) / z;
    along_x = Vec3{unit, 0, 0} + p * zx, along_y = Vec3{0, -unit, 0} + p * zy;
  }
  Vec3 n = normalized(cross(along_x, along_y));
  if (n.z > 0) n = -n;
  return {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)};
}

Normal normal_at(const GBuffer& buffer, const Camera& camera, int x, int y) {
  const std::size_t i = buffer.index(x, y);
  const double z = static_cast<double>(buffer.depth[i]);
  const int step =
      std::max(1, static_cast<int>(step_in_spacings * static_cast<double>(buffer.scale[i])));
  const double tolerance = slope_tolerance * step * camera.pixel_size(z);
  Slope sx = slope(buffer, x, y, step, 0, tolerance), sy = slope(buffer, x, y, 0, step, tolerance);
  if (!sx.ok) sx = slope(buffer, x, y, 1, 0, tolerance);
  if (!sy.ok) sy = slope(buffer, x, y, 0, 1, tolerance);
  return normal_of(camera, x + 0.5, y + 0.5, z, sx.value, sy.value);
}

bool lacks_normal(const GBuffer& buffer, std::size_t i) {
  const Normal& n = buffer.normal[i];
  return buffer.depth[i] < no_depth && n.x == 0 && n.y == 0 && n.z == 0;
}

// Mean of the normals round a pixel that point about the same way: noise goes, creases stay.
Normal smoothed(const GBuffer& buffer, const std::vector<Normal>& normals, int x, int y) {
  const std::size_t center = buffer.index(x, y);
  const Normal& n = normals[center];
  const int step = std::max(1, static_cast<int>(0.3f * buffer.scale[center]));
  std::array<float, 3> sum{};
  for (int dy = -2; dy <= 2; ++dy)
    for (int dx = -2; dx <= 2; ++dx) {
      const int px = x + dx * step, py = y + dy * step;
      if (buffer.depth_at(px, py) == no_depth) continue;
      const Normal& o = normals[buffer.index(px, py)];
      const float alike = n.x * o.x + n.y * o.y + n.z * o.z;
      if (alike < 0.7f) continue;
      const float w = (alike - 0.7f) * (alike - 0.7f);
      sum[0] += w * o.x, sum[1] += w * o.y, sum[2] += w * o.z;
    }
  const float length = std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
  return length > 0 ? Normal{sum[0] / length, sum[1] / length, sum[2] / length} : n;
}

}  // namespace

void find_normals(GBuffer& buffer, const Camera& camera, const Job& job) {
  std::vector<Normal> raw = buffer.normal;
  const auto each = [&](const auto& f) {
    for_each_tile(buffer.grid, "", job, [&](std::size_t, const PixelBox& box) {
      for (int y = box.y0; y < box.y1; ++y)
        for (int x = box.x0; x < box.x1; ++x)
          if (lacks_normal(buffer, buffer.index(x, y))) f(buffer.index(x, y), x, y);
    });
  };
  each([&](std::size_t i, int x, int y) { raw[i] = normal_at(buffer, camera, x, y); });
  std::vector<Normal> result = raw;
  each([&](std::size_t i, int x, int y) { result[i] = smoothed(buffer, raw, x, y); });
  buffer.normal.swap(result);
}

}  // namespace spigolo
