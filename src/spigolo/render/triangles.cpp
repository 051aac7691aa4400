// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/triangles.cpp
#include "spigolo/render/triangles.h"

#include <array>

#include "spigolo/core/parallel.h"

namespace spigolo {
namespace {

constexpr double wire_strength = 0.55;  // how much of the colour a wire takes away

struct Corner {
  Projected p;
  Vec3 normal;  // view space, not scaled
  Vec3 color;
};
using Corners = std::array<Corner, 3>;

Vec3 to_view(const Camera& camera, const Vec3& v) {
  return {dot(v, camera.right), dot(v, camera.up), dot(v, camera.forward)};
}

Vec3 as_vector(const Color& c) { return {double(c.r), double(c.g), double(c.b)}; }

Color as_color(const Vec3& v) {
  const auto channel = [](double x) {
    return static_cast<std::uint8_t>(std::clamp(x + 0.5, 0.0, 255.0));
  };
  return {channel(v.x), channel(v.y), channel(v.z)};
}

// Turned to the eye, which looks along `ray`.
Normal facing(const Vec3& normal, const Vec3& ray) {
  const Vec3 n = normalized(dot(normal, ray) > 0 ? -normal : normal);
  return {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(std::min(n.z, 0.0))};
}

// Area-weighted sums over the triangles round each vertex.
std::vector<Vec3> vertex_normals(const MeshLayer& mesh) {
  std::vector<Vec3> normals(mesh.points.size());
  for (const auto& t : mesh.triangles) {
    const Vec3 n =
        cross(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]]);
    if (is_finite(n))
      for (const std::uint32_t v : t) normals[v] += n;
  }
  return normals;
}

class MeshPainter {
 public:
  MeshPainter(GBuffer& buffer, const MeshLayer& mesh, const Camera& camera, double line_width,
              const Job& job)
      : buffer_(buffer), mesh_(mesh), camera_(camera), line_width_(line_width) {
    projected_.resize(mesh.points.size());
    parallel_for(job, "", mesh.points.size(), 16384, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        projected_[i] = is_finite(mesh.points[i]) ? camera.project(mesh.points[i])
                                                  : Projected{0, 0, not_a_number};
    });
    if (mesh.smooth) normals_ = vertex_normals(mesh);
  }

  PixelBox box(std::size_t triangle) const {
    Box box;
    for (const std::uint32_t v : mesh_.triangles[triangle]) {
      const Projected& p = projected_[v];
      if (!(p.z > 0 && std::abs(p.x) < 1e8 && std::abs(p.y) < 1e8)) return {};
      box.add({p.x, p.y, 0});
    }
    return {static_cast<int>(std::floor(box.min.x)), static_cast<int>(std::floor(box.min.y)),
            static_cast<int>(std::floor(box.max.x)) + 1,
            static_cast<int>(std::floor(box.max.y)) + 1};
  }

  void draw(std::size_t triangle, const PixelBox& tile) {
    const Corners c = corners(triangle);
    const auto side = [](const Projected& a, const Projected& b, double x, double y) {
      return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
    };
    const double area = side(c[0].p, c[1].p, c[2].p.x, c[2].p.y);
    if (area == 0) return;
    const PixelBox b = intersection(box(triangle), tile);
    for (int y = b.y0; y < b.y1; ++y)
      for (int x = b.x0; x < b.x1; ++x) {
        const double px = x + 0.5, py = y + 0.5;
        const Vec3 w{side(c[1].p, c[2].p, px, py) / area, side(c[2].p, c[0].p, px, py) / area,
                     side(c[0].p, c[1].p, px, py) / area};
        if (w.x >= 0 && w.y >= 0 && w.z >= 0) shade(c, w, area, x, y);
      }
  }

 private:
  Corners corners(std::size_t triangle) const {
    const auto& t = mesh_.triangles[triangle];
    const Vec3 flat =
        cross(mesh_.points[t[1]] - mesh_.points[t[0]], mesh_.points[t[2]] - mesh_.points[t[0]]);
    Corners c;
    for (std::size_t i = 0; i < 3; ++i)
      c[i] = {projected_[t[i]], to_view(camera_, normalized(mesh_.smooth ? normals_[t[i]] : flat)),
              as_vector(mesh_.colors.empty() ? mesh_.color : mesh_.colors[t[i]])};
    return c;
  }

  // w: shares of the corners on the screen; inside the model they go by 1 / depth.
  void shade(const Corners& c, Vec3 w, double area, int x, int y) {
    const double wire = mesh_.wireframe ? wire_share(c, w, area) : 0;
    if (camera_.perspective) {
      w = {w.x / c[0].p.z, w.y / c[1].p.z, w.z / c[2].p.z};
      w = w / (w.x + w.y + w.z);
    }
    const double z = w.x * c[0].p.z + w.y * c[1].p.z + w.z * c[2].p.z;
    const std::size_t i = buffer_.index(x, y);
    if (!(static_cast<float>(z) < buffer_.depth[i])) return;
    const Vec3 normal = w.x * c[0].normal + w.y * c[1].normal + w.z * c[2].normal;
    const Vec3 color = w.x * c[0].color + w.y * c[1].color + w.z * c[2].color;
    const Vec3 ray = camera_.perspective ? camera_.unproject(x + 0.5, y + 0.5, z) : Vec3{0, 0, 1};
    buffer_.set(i, {static_cast<float>(z), facing(normal, ray),
                    as_color(color * (1 - wire_strength * wire)), Material::surface, 1});
  }

  // 1 on an edge of the triangle, 0 from half a line width (and a pixel of blur) on.
  double wire_share(const Corners& c, const Vec3& w, double area) const {
    double nearest = infinity;
    for (std::size_t i = 0; i < 3; ++i) {
      const Projected &a = c[(i + 1) % 3].p, &b = c[(i + 2) % 3].p;
      nearest = std::min(nearest, w[i] * std::abs(area) / std::hypot(b.x - a.x, b.y - a.y));
    }
    return std::clamp(0.5 * line_width_ + 0.5 - nearest, 0.0, 1.0);
  }

  GBuffer& buffer_;
  const MeshLayer& mesh_;
  const Camera& camera_;
  double line_width_;
  std::vector<Projected> projected_;
  std::vector<Vec3> normals_;
};

}  // namespace

void draw_mesh(GBuffer& buffer, const MeshLayer& mesh, const Camera& camera, double line_width,
               const Job& job) {
  MeshPainter painter(buffer, mesh, camera, line_width, job);
  const TileBins bins(
      buffer.grid, mesh.triangles.size(), [&](std::size_t i) { return painter.box(i); }, job);
  for_each_tile(buffer.grid, "draw mesh", job, [&](std::size_t tile, const PixelBox& box) {
    for (const std::uint32_t item : bins.items(tile)) painter.draw(item, box);
  });
}

}  // namespace spigolo
