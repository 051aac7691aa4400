// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/light.cpp - two lamps, hollows darkened by depth (after screen-space occlusion and
// eye-dome lighting), dark outlines, blocks averaged in linear light
#include "spigolo/render/light.h"

#include <array>

#include "spigolo/core/parallel.h"

namespace spigolo {
namespace {

struct Lamp {
  Vec3 to;  // unit vector from the scene to the lamp, view space
  double strength;
};

const std::array<Lamp, 2> lamps = {
    {{normalized({-0.55, 0.7, -0.62}), 0.62}, {normalized({0.5, -0.2, -0.8}), 0.17}}};
constexpr double ambient = 0.36;
constexpr double mark_ambient = 0.62;  // marks keep their colour in any light
constexpr double hollow_strength = 1.15;
constexpr double outline_strength = 0.55;
// Rings of the hollow test, as shares of the picture's height.
constexpr std::array<double, 4> rings = {0.0035, 0.008, 0.018, 0.04};

constexpr std::size_t diameters = 4;

// One half of a diameter of a ring; the other is its mirror image.
struct Probe {
  int dx, dy;
  double radius;
};
using Probes = std::array<Probe, rings.size() * diameters>;

Probes probes_of(int height) {
  Probes probes;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    const std::size_t ring = i / diameters, k = i % diameters;
    const double radius = std::max(1.5, rings[ring] * height);
    const double a = (static_cast<double>(k) + 0.25 * static_cast<double>(ring)) * pi / diameters;
    probes[i] = {static_cast<int>(std::lround(radius * std::cos(a))),
                 static_cast<int>(std::lround(radius * std::sin(a))), radius};
  }
  return probes;
}

// How hollow the surface is at a pixel, 0 for planes: on both ends of each diameter of a ring, how
// far the surface comes towards the eye. Only its excess over a plane counts, so slopes are not
// dark.
double hollow(const GBuffer& buffer, const Camera& camera, const Probes& probes, int x, int y) {
  const double z = static_cast<double>(buffer.depth_at(x, y));
  const double unit = camera.pixel_size(z);
  double sum = 0;
  for (const Probe& probe : probes) {
    const auto nearer = [&](int px, int py) {
      const double d = (z - static_cast<double>(buffer.depth_at(px, py))) / (probe.radius * unit);
      if (!(d > -1e6)) return -1.5;
      // What is far before the surface does not shade it, or every outline had a wide halo.
      return d > 3 ? std::max(0.0, 1.5 - 0.25 * (d - 3)) : std::clamp(d, -1.5, 1.5);
    };
    sum += std::max(0.0,
                    nearer(x + probe.dx, y + probe.dy) + nearer(x - probe.dx, y - probe.dy) - 0.04);
  }
  return sum / static_cast<double>(probes.size());
}

// 1 at the rim of what is seen, where the next pixels show nothing or something far behind.
double outline(const GBuffer& buffer, const Camera& camera, int x, int y, int reach) {
  const double z = static_cast<double>(buffer.depth_at(x, y));
  const double step = 12.0 * reach * camera.pixel_size(z);
  int open = 0;
  for (const auto& [dx, dy] :
       std::array<std::array<int, 2>, 4>{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}}) {
    const double there = static_cast<double>(buffer.depth_at(x + dx * reach, y + dy * reach));
    const double back = static_cast<double>(buffer.depth_at(x - dx * reach, y - dy * reach));
    if (there - z > step + 2 * std::max(0.0, z - back)) ++open;
  }
  return open > 0 ? 1 : 0;
}

double lamp_light(const Normal& n, double base) {
  double sum = base;
  const Vec3 normal{static_cast<double>(n.x), static_cast<double>(n.y), static_cast<double>(n.z)};
  for (const Lamp& lamp : lamps) {
    const double d = std::max(0.0, dot(normal, lamp.to));
    sum += (1 - base) / (1 - ambient) * lamp.strength * d;
  }
  return sum;
}

struct Light {
  double r = 0, g = 0, b = 0;
};

double linear(std::uint8_t c) { return std::pow(c / 255.0, 2.2); }

std::uint8_t encoded(double v) {
  return static_cast<std::uint8_t>(255 * std::pow(std::clamp(v, 0.0, 1.0), 1 / 2.2) + 0.5);
}

class Lighter {
 public:
  Lighter(const GBuffer& buffer, const Camera& camera, int samples)
      : buffer_(buffer),
        camera_(camera),
        samples_(samples),
        probes_(probes_of(buffer.grid.height)) {
    for (std::size_t c = 0; c < linear_.size(); ++c)
      linear_[c] = linear(static_cast<std::uint8_t>(c));
  }

  Color pixel(int x, int y, const Color& background) const {
    Light sum;
    int covered = 0;
    double dark = -1;  // of the hollow, once for all samples of a pixel
    for (int sy = 0; sy < samples_; ++sy)
      for (int sx = 0; sx < samples_; ++sx) {
        const int px = x * samples_ + sx, py = y * samples_ + sy;
        if (buffer_.depth_at(px, py) == no_depth) continue;
        if (dark < 0) dark = std::exp(-hollow_strength * hollow(buffer_, camera_, probes_, px, py));
        add(sum, px, py, dark);
        ++covered;
      }
    if (covered == 0) return background;
    const double all = samples_ * samples_, rest = all - covered;
    return {encoded((sum.r + rest * linear_[background.r]) / all),
            encoded((sum.g + rest * linear_[background.g]) / all),
            encoded((sum.b + rest * linear_[background.b]) / all)};
  }

 private:
  void add(Light& sum, int px, int py, double dark) const {
    const std::size_t i = buffer_.index(px, py);
    const bool mark = buffer_.material[i] == Material::mark;
    double light = lamp_light(buffer_.normal[i], mark ? mark_ambient : ambient);
    light *= mark ? 0.5 + 0.5 * dark : dark;
    light *= 1 - outline_strength * outline(buffer_, camera_, px, py, samples_);
    const Color& c = buffer_.color[i];
    sum.r += light * linear_[c.r], sum.g += light * linear_[c.g], sum.b += light * linear_[c.b];
  }

  const GBuffer& buffer_;
  const Camera& camera_;
  int samples_;
  Probes probes_;
  std::array<double, 256> linear_{};
};

}  // namespace

void light(Image& image, const GBuffer& buffer, const Camera& camera, int samples, const Job& job) {
  const Lighter lighter(buffer, camera, samples);
  const auto height = static_cast<std::size_t>(image.height);
  parallel_for(job, "light", height, 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y)
      for (int x = 0; x < image.width; ++x) {
        Color& c = image.at(x, static_cast<int>(y));
        c = lighter.pixel(x, static_cast<int>(y), c);
      }
  });
}

}  // namespace spigolo
