// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/render.cpp
#include "spigolo/render/render.h"

#include "spigolo/core/error.h"
#include "spigolo/render/auto_view.h"
#include "spigolo/render/camera.h"
#include "spigolo/render/gbuffer.h"
#include "spigolo/render/light.h"
#include "spigolo/render/overlay.h"
#include "spigolo/render/sampling.h"
#include "spigolo/render/splats.h"
#include "spigolo/render/triangles.h"
#include "spigolo/render/tubes.h"

namespace spigolo {
namespace {

constexpr double bead_radius = 0.62;  // in spacings of the surface the beads lie on
constexpr double least_bead = 2.4;    // [pixel of the picture] radius
constexpr double most_bead = 7.0;     // [pixel of the picture] radius
constexpr double lone_point =
    0.006;  // radius as a share of the picture, where nothing tells a spacing
constexpr double tilt_from = 0.9;   // [pixel of the picture] spacing from which discs are tilted
constexpr double wire_width = 1.1;  // [pixel of the picture]

void check(const RenderOptions& o) {
  const auto require = [](bool sound, const char* what) {
    if (!sound) throw UsageError(what);
  };
  require(o.width >= 16 && o.width <= 16384 && o.height >= 16 && o.height <= 16384,
          "a picture's width and height must be 16 to 16384 pixels");
  require(o.supersampling >= 1 && o.supersampling <= 4, "supersampling must be 1 to 4");
  require(o.point_size > 0 && std::isfinite(o.point_size), "the point size must be positive");
  require(o.view.zoom > 0 && std::isfinite(o.view.zoom), "the zoom must be positive");
  require(o.view.radius >= 0 && (!o.view.target || is_finite(*o.view.target)),
          "the view's target and radius must be finite");
}

Image background(const RenderOptions& o) {
  Image image(o.width, o.height);
  for (int y = 0; y < o.height; ++y) {
    const double t = (y + 0.5) / o.height;
    const auto mix = [&](std::uint8_t a, std::uint8_t b) {
      return static_cast<std::uint8_t>(a + (b - a) * t + 0.5);
    };
    const Color c{mix(o.top.r, o.bottom.r), mix(o.top.g, o.bottom.g), mix(o.top.b, o.bottom.b)};
    for (int x = 0; x < o.width; ++x) image.at(x, y) = c;
  }
  return image;
}

// Where the scene goes, in pixels of the picture.
Frame frame_of(const Image& image, const Scene& scene, const RenderOptions& o) {
  const double size = letter_size(o.width, o.height);
  const std::vector<LegendEntry> none;
  const double top = heading_height(image, o.title, o.legend ? scene.legend : none);
  const double bottom = o.scale_bar || o.axes ? 4.0 * size : 2.0 * size;
  const double right = o.legend && scene.color_bar ? color_bar_width(image) : 2.5 * size;
  return {2.5 * size, top + size, o.width - right, o.height - bottom};
}

Frame scaled(const Frame& f, double s) { return {f.x0 * s, f.y0 * s, f.x1 * s, f.y1 * s}; }

double median(std::vector<float> values) {
  std::erase_if(values, [](float v) { return !(v > 0); });
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return static_cast<double>(*middle);
}

class SceneDrawer {
 public:
  SceneDrawer(GBuffer& buffer, const Camera& camera, const RenderOptions& options, const Job& job)
      : buffer_(buffer), camera_(camera), options_(options), job_(job) {}

  void draw(const Scene& scene) {
    draw_surfaces(scene);
    for (const MeshLayer& layer : scene.meshes)
      draw_mesh(buffer_, layer, camera_, wire_width * options_.supersampling, job_);
    find_normals(buffer_, camera_, job_);
    for (const LineLayer& layer : scene.lines)
      draw_lines(buffer_, layer, camera_, layer.width * options_.supersampling, job_);
    draw_features(scene);
  }

 private:
  // [model unit] of this many pixels of the picture in the middle of the scene.
  double pixels(double count) const {
    return count * options_.supersampling * camera_.pixel_size(camera_.distance);
  }

  // Discs of about a pixel look the same however they lie.
  Surfels surfels_of(const PointLayer& layer) const {
    Surfels surfels;
    surfels.spacings = layer.spacing > 0 ? std::vector<float>{static_cast<float>(layer.spacing)}
                                         : local_spacings(layer.points, job_);
    const double typical = median(surfels.spacings);
    if (typical == 0)
      surfels.spacings = {static_cast<float>(pixels(lone_point * options_.height))};
    else if (typical * options_.point_size > tilt_from * pixels(1))
      surfels = find_surfels(layer.points, job_);
    return surfels;
  }

  void draw_surfaces(const Scene& scene) {
    std::vector<Splat> splats;
    for (const PointLayer& layer : scene.points) {
      if (layer.style != PointStyle::surface || layer.points.empty()) continue;
      Surfels surfels = surfels_of(layer);
      if (spacing_ == 0) spacing_ = median(surfels.spacings);
      for (float& s : surfels.spacings) s *= static_cast<float>(options_.point_size);
      project_points(splats, layer, surfels, camera_, job_);
    }
    draw_surface(buffer_, splats, camera_, job_);
  }

  void draw_features(const Scene& scene) {
    std::vector<Splat> splats;
    for (const PointLayer& layer : scene.points) {
      if (layer.style != PointStyle::beads || layer.points.empty()) continue;
      const double spacing = layer.spacing > 0 ? layer.spacing : spacing_;
      const double radius =
          std::clamp(bead_radius * spacing, pixels(least_bead), pixels(most_bead));
      const auto size = static_cast<float>(options_.point_size * radius);
      project_points(splats, layer, {{size}, {}}, camera_, job_);
    }
    draw_beads(buffer_, splats, camera_, job_);
  }

  GBuffer& buffer_;
  const Camera& camera_;
  const RenderOptions& options_;
  const Job& job_;
  double spacing_ = 0;  // of the first surface layer
};

void draw_overlay(Image& image, const Scene& scene, const Camera& camera, const RenderOptions& o) {
  const std::vector<LegendEntry> none;
  draw_heading(image, o.title, o.legend ? scene.legend : none);
  if (o.legend && scene.color_bar) draw_color_bar(image, *scene.color_bar);
  if (o.scale_bar) draw_scale_bar(image, camera.pixel_size(camera.distance) * o.supersampling);
  if (o.axes) draw_axes(image, camera);
}

}  // namespace

Image render(const Scene& scene, const RenderOptions& options, const Job& job) {
  check(options);
  validate(scene);
  Image image = background(options);
  const Vec3 direction =
      options.view.direction ? *options.view.direction : best_direction(scene, options.view);
  const int samples = options.supersampling;
  const Frame frame = scaled(frame_of(image, scene, options), samples);
  const Camera camera = fit_camera(positions_of(scene), options.view, direction, frame, job);
  GBuffer buffer(samples * options.width, samples * options.height);
  SceneDrawer(buffer, camera, options, job).draw(scene);
  light(image, buffer, camera, samples, job);
  draw_overlay(image, scene, camera, options);
  return image;
}

}  // namespace spigolo
