// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/splats.cpp - two-pass surface splatting (Botsch, Kobbelt 2003), layer by layer
// where a surface ends in front of another
#include "spigolo/render/splats.h"

#include <array>

#include "spigolo/core/parallel.h"
#include "spigolo/render/pinholes.h"

namespace spigolo {
namespace {

constexpr float core_size = 1.6f;    // in spacings: a disc that hides what lies behind
constexpr float blend_size = 1.9f;   // in spacings: reach of the blend
constexpr float least_core = 0.71f;  // [pixel] the middle of some pixel is always hit
constexpr float flat_depth = 1.3f;   // in spacings: points this near in depth are one surface
constexpr float blind_depth =
    3.5f;                    // the same for discs that face the eye, whatever the surface does
constexpr float rim = 1.0f;  // in spacings: where the blended points lie this far to one side of a
                             // pixel, the pixel lies past the end of the surface
constexpr float bead_lift = 0.5f;  // in radii, to the eye
constexpr int most_layers = 3;
constexpr double least_cosine = 0.15;  // of the angle at which a disc is seen

float core_radius(const Splat& s) { return std::max(core_size * s.radius, least_core); }
float blend_radius(const Splat& s) { return std::max(blend_size * s.radius, 1.1f); }

struct Offset {
  float dx, dy, dz;  // [pixel] from the splat to the point of its plane behind a pixel
  float square;
  std::size_t in_tile;
};

// Calls visit(pixel index, offset) for the pixels of the disc inside the tile.
template <class Visit>
void visit_disc(const TileGrid& grid, const PixelBox& tile, const Splat& s, float radius,
                const Visit& visit) {
  const PixelBox b = intersection(box_around(s.x, s.y, radius), tile);
  for (int y = b.y0; y < b.y1; ++y) {
    const float dy = static_cast<float>(y) + 0.5f - s.y;
    const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.width);
    const auto in_row = static_cast<std::size_t>((y - tile.y0) * TileGrid::side);
    for (int x = b.x0; x < b.x1; ++x) {
      const float dx = static_cast<float>(x) + 0.5f - s.x;
      const float dz = s.slope_x * dx + s.slope_y * dy, flat = dx * dx + dy * dy;
      const float square = flat + dz * dz;
      if (square < radius * radius || flat < least_core * least_core)
        visit(row + static_cast<std::size_t>(x),
              Offset{dx, dy, dz, square, in_row + static_cast<std::size_t>(x - tile.x0)});
    }
  }
}

TileBins bin_discs(const TileGrid& grid, std::span<const Splat> splats,
                   float (*radius)(const Splat&), const Job& job) {
  return {grid, splats.size(),
          [&](std::size_t i) {
            const Splat& s = splats[i];
            return s.radius > 0 ? box_around(s.x, s.y, radius(s)) : PixelBox{};
          },
          job};
}

// Sums of a pixel's blend.
struct Blend {
  float weight = 0, depth = 0, scale = 0, side_x = 0, side_y = 0, side_z = 0;
  std::array<float, 3> color{};
  Normal normal{0, 0, 0};

  void add(float w, const Splat& s, float z, const Offset& o) {
    weight += w, depth += w * z, scale += w * s.radius;
    side_x += w * o.dx, side_y += w * o.dy, side_z += w * o.dz;
    color[0] += w * s.color.r, color[1] += w * s.color.g, color[2] += w * s.color.b;
    normal.x += w * s.normal.x, normal.y += w * s.normal.y, normal.z += w * s.normal.z;
  }
  bool past_the_end() const {
    const float reach = rim * std::max(scale, weight);
    return side_x * side_x + side_y * side_y + side_z * side_z > reach * reach;
  }
  Fragment mean() const {
    const auto channel = [&](std::size_t c) {
      return static_cast<std::uint8_t>(color[c] / weight + 0.5f);
    };
    const float length = std::sqrt(normal.x * normal.x + normal.y * normal.y + normal.z * normal.z);
    const float inverse = length > 0 ? 1 / length : 0;
    return {depth / weight,
            {normal.x * inverse, normal.y * inverse, normal.z * inverse},
            {channel(0), channel(1), channel(2)},
            Material::surface,
            scale / weight};
  }
};

class SurfacePainter {
 public:
  SurfacePainter(GBuffer& buffer, std::span<const Splat> splats, const Camera& camera,
                 const Job& job)
      : buffer_(buffer),
        splats_(splats),
        camera_(camera),
        bins_(bin_discs(buffer.grid, splats, blend_radius, job)),
        front_(buffer.size(), no_depth),
        behind_(buffer.size(), -no_depth) {}

  void draw(const Job& job) {
    for (int layer = 0; layer < most_layers; ++layer) {
      for_each_tile(buffer_.grid, "draw points", job,
                    [&](std::size_t tile, const PixelBox& box) { find_front(tile, box); });
      if (layer == 0) close_pinholes(front_, buffer_.grid, typical_radius(splats_), camera_, job);
      for_each_tile(buffer_.grid, "blend points", job,
                    [&](std::size_t tile, const PixelBox& box) { blend(tile, box); });
    }
  }

 private:
  float unit(const Splat& s) const { return static_cast<float>(camera_.pixel_size(s.z)); }

  // The nearest disc of each pixel that is still open; done pixels have behind_ at no_depth.
  void find_front(std::size_t tile, const PixelBox& box) {
    bool open = false;
    for (int y = box.y0; y < box.y1; ++y)
      for (int x = box.x0; x < box.x1; ++x) {
        const std::size_t i = buffer_.index(x, y);
        front_[i] = no_depth;
        open = open || behind_[i] < no_depth;
      }
    if (!open) return;
    for (const std::uint32_t item : bins_.items(tile)) {
      const Splat& s = splats_[item];
      const float scale = unit(s);
      visit_disc(buffer_.grid, box, s, core_radius(s), [&](std::size_t i, const Offset& o) {
        const float z = s.z + scale * o.dz;
        if (z > behind_[i]) front_[i] = std::min(front_[i], z);
      });
    }
  }

  static float depth_reach(const Splat& s) {
    const float steep = std::sqrt(s.slope_x * s.slope_x + s.slope_y * s.slope_y);
    return (s.normal.z == 0 ? blind_depth : flat_depth + 0.4f * steep) * std::max(s.radius, 1.0f);
  }

  bool any_front(const PixelBox& box) const {
    for (int y = box.y0; y < box.y1; ++y)
      for (int x = box.x0; x < box.x1; ++x)
        if (front_[buffer_.index(x, y)] < no_depth) return true;
    return false;
  }

  void blend(std::size_t tile, const PixelBox& box) {
    if (!any_front(box)) return;
    std::array<Blend, TileGrid::side * TileGrid::side> blends;
    for (const std::uint32_t item : bins_.items(tile)) {
      const Splat& s = splats_[item];
      const float radius = blend_radius(s), inverse = 1 / (radius * radius), scale = unit(s);
      const float reach = depth_reach(s) * scale;
      visit_disc(buffer_.grid, box, s, radius, [&](std::size_t i, const Offset& o) {
        const float z = s.z + scale * o.dz;
        if (!(std::abs(z - front_[i]) <= reach)) return;  // also where nothing is in front
        const float t = std::max(1 - o.square * inverse, 0.03f);
        blends[o.in_tile].add(t * t, s, z, o);
      });
    }
    settle(box, blends);
  }

  void settle(const PixelBox& box, std::span<const Blend> blends) {
    for (int y = box.y0; y < box.y1; ++y)
      for (int x = box.x0; x < box.x1; ++x) {
        const std::size_t i = buffer_.index(x, y);
        const Blend& b =
            blends[static_cast<std::size_t>((y - box.y0) * TileGrid::side + x - box.x0)];
        if (front_[i] == no_depth || !(b.weight > 0)) {
          behind_[i] = no_depth;
        } else if (b.past_the_end()) {
          const double z = static_cast<double>(front_[i]);
          behind_[i] = front_[i] + 2 * flat_depth * b.scale / b.weight *
                                       static_cast<float>(camera_.pixel_size(z));
        } else {
          buffer_.draw(i, b.mean());
          behind_[i] = no_depth;
        }
      }
  }

  GBuffer& buffer_;
  std::span<const Splat> splats_;
  const Camera& camera_;
  TileBins bins_;
  std::vector<float> front_, behind_;
};

void draw_bead(GBuffer& buffer, const PixelBox& tile, const Splat& s, const Camera& camera) {
  const auto unit = static_cast<float>(camera.pixel_size(s.z));
  const float radius = s.radius;
  visit_disc(buffer.grid, tile, s, radius, [&](std::size_t i, const Offset& o) {
    const float height = std::sqrt(std::max(radius * radius - o.square, 0.0f));
    const Normal n{o.dx / radius, -o.dy / radius, -height / radius};
    buffer.draw(i,
                {s.z - (height + bead_lift * radius) * unit, n, s.color, Material::mark, radius});
  });
}

// Lays the splat of a point at view-space place p into the plane with this world-space normal.
void tilt(Splat& s, const Vec3& normal, const Vec3& p, const Camera& camera) {
  const Vec3 n{dot(normal, camera.right), dot(normal, camera.up), dot(normal, camera.forward)};
  const Vec3 ray = camera.perspective ? normalized(p) : Vec3{0, 0, 1};
  const double side = dot(n, ray) > 0 ? -1 : 1, cosine = std::abs(dot(n, ray));
  if (!(cosine > 0)) return;
  const double along = -std::max(cosine, least_cosine);
  s.normal = {static_cast<float>(side * n.x), static_cast<float>(side * n.y),
              static_cast<float>(std::min(side * n.z, -1e-6))};
  s.slope_x = static_cast<float>(-side * n.x / along);
  s.slope_y = static_cast<float>(side * n.y / along);
}

}  // namespace

void project_points(std::vector<Splat>& splats, const PointLayer& layer, const Surfels& surfels,
                    const Camera& camera, const Job& job) {
  const std::size_t first = splats.size();
  splats.resize(first + layer.points.size());
  const std::vector<float>& spacings = surfels.spacings;
  parallel_for(job, "", layer.points.size(), 16384, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (!is_finite(layer.points[i])) continue;
      const Projected p = camera.project(layer.points[i]);
      if (!(p.z > 0)) continue;
      const auto spacing = static_cast<double>(spacings[spacings.size() == 1 ? 0 : i]);
      Splat& s = splats[first + i];
      s.x = static_cast<float>(p.x), s.y = static_cast<float>(p.y), s.z = static_cast<float>(p.z);
      s.radius = static_cast<float>(layer.size * spacing / camera.pixel_size(p.z));
      s.color = layer.colors.empty() ? layer.color : layer.colors[i];
      if (!surfels.normals.empty())
        tilt(s, surfels.normals[i], camera.unproject(p.x, p.y, p.z), camera);
    }
  });
}

void draw_surface(GBuffer& buffer, std::span<const Splat> splats, const Camera& camera,
                  const Job& job) {
  if (!splats.empty()) SurfacePainter(buffer, splats, camera, job).draw(job);
}

void draw_beads(GBuffer& buffer, std::span<const Splat> splats, const Camera& camera,
                const Job& job) {
  if (splats.empty()) return;
  const TileBins bins = bin_discs(
      buffer.grid, splats, [](const Splat& s) { return s.radius; }, job);
  for_each_tile(buffer.grid, "draw features", job, [&](std::size_t tile, const PixelBox& box) {
    for (const std::uint32_t item : bins.items(tile)) draw_bead(buffer, box, splats[item], camera);
  });
}

}  // namespace spigolo
