// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/gbuffer.h - what is seen at every pixel, before light falls on it
#pragma once

#include <cstdint>
#include <vector>

#include "spigolo/render/palette.h"
#include "spigolo/render/tiles.h"

namespace spigolo {

inline constexpr float no_depth = std::numeric_limits<float>::infinity();

/// View space: x right, y up, z away from the eye; a seen normal has z <= 0.
struct Normal {
  float x = 0, y = 0, z = -1;
};

enum class Material : std::uint8_t { surface, mark };  // marks are lit brightly, for their colour

/// What one pixel shows.
struct Fragment {
  float depth = no_depth;
  Normal normal{0, 0, 0};  // zero: to be found from the depths round the pixel
  Color color;
  Material material = Material::surface;
  float scale = 1;  // [pixel] size of the samples, the step at which normals are found
};

/// Fragments as arrays; depth no_depth where nothing is seen.
struct GBuffer {
  TileGrid grid;
  std::vector<float> depth;
  std::vector<Normal> normal;
  std::vector<Color> color;
  std::vector<Material> material;
  std::vector<float> scale;

  GBuffer(int width, int height)
      : grid{width, height},
        depth(size(), no_depth),
        normal(size(), Normal{0, 0, 0}),
        color(size()),
        material(size()),
        scale(size(), 1.0f) {}

  std::size_t size() const {
    return static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height);
  }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.width) +
           static_cast<std::size_t>(x);
  }
  /// no_depth outside the picture.
  float depth_at(int x, int y) const {
    return x < 0 || y < 0 || x >= grid.width || y >= grid.height ? no_depth : depth[index(x, y)];
  }
  void set(std::size_t i, const Fragment& f) {
    depth[i] = f.depth, normal[i] = f.normal, color[i] = f.color;
    material[i] = f.material, scale[i] = f.scale;
  }
  /// Keeps the nearer; of two at the same depth the one drawn first.
  void draw(std::size_t i, const Fragment& f) {
    if (f.depth < depth[i]) set(i, f);
  }
};

}  // namespace spigolo
