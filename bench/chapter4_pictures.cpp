// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/chapter4_pictures.cpp - figures 58, 59, 61, 62 and 66 with our data
#include "picture.h"
#include "projection.h"
#include "sections.h"
#include "spigolo/detect/detect.h"
#include "spigolo/pipeline/mesh.h"

namespace spigolo::bench {
namespace {

struct Sheet {
  std::vector<Panel> panels;

  void add(const std::string& title, const std::vector<Vec3>& points) {
    Panel panel{{}, title};
    panel.scene.points.push_back({});
    panel.scene.points.back().points = points;
    panels.push_back(std::move(panel));
  }

  void add(const std::string& title, MeshLayer surface) {
    Panel panel{{}, title};
    panel.scene.meshes.push_back(std::move(surface));
    panels.push_back(std::move(panel));
  }

  void write(const std::filesystem::path& path, int width, int height, const View& view) const {
    RenderOptions options = bare_look(width, height);
    options.view = view;
    save_picture(path, render_panels(panels, options));
  }
};

// A cloud with all it takes to project onto its surface.
struct Subject {
  std::vector<Vec3> points;
  MlsCloud cloud;
  std::vector<PointKind> kind;

  explicit Subject(const SynthOptions& options)
      : points(make_cloud(options).cloud.points),
        cloud(points),
        kind(detect(points).features.kind) {}

  // A mesh of the exact surface, each vertex moved onto the surface that the method sees: points
  // alone would be drawn as disks, whose rims hide the edges.
  MeshLayer surface(const TriangleMesh& exact, const std::string& method,
                    const MlsOptions& options) const {
    const Projection project = projection_method(method).make(cloud, kind, options);
    MeshLayer layer;
    for (const Vec3& p : exact.vertices.points) layer.points.push_back(project(p).position);
    layer.triangles = exact.triangles;
    return layer;
  }
};

TriangleMesh exact_mesh(SynthOptions options) {
  options.noise_percent = 0, options.density_gradient = 1;
  return mesh_cloud(make_cloud(options).cloud.points).sharp.mesh;
}

View close_up(const Vec3& direction, const Vec3& target, double radius) {
  View view;
  view.direction = direction, view.target = target, view.radius = radius;
  return view;
}

MlsOptions mls(std::size_t k, double h, double spacing) {
  MlsOptions options;
  options.k = k;
  options.smoothing = h / spacing;
  return options;
}

constexpr double hole_spacing = .111, planes_spacing = .1;  // in the thesis's units, as h is

std::string percent(double noise) { return number(noise, 1) + " % noise"; }

void figures_58_and_62(const std::filesystem::path& folder, const std::string& method,
                       const TriangleMesh& exact) {
  Sheet sheet;
  for (const double noise : {0.5, 1.0, 2.0}) {
    const Subject s({.shape = "planes", .noise_percent = noise});
    sheet.add(percent(noise), s.points);
    sheet.add(method + ", k 20, h .1", s.surface(exact, method, mls(20, .1, planes_spacing)));
    sheet.add(method + ", k 40, h .5", s.surface(exact, method, mls(40, .5, planes_spacing)));
    sheet.add(method + ", by the noise", s.surface(exact, method, {}));
  }
  sheet.write(folder / ("figure58-" + method + ".png"), 2000, 1000, {});
}

void figures_59_and_61(const std::filesystem::path& folder, const std::string& method,
                       const TriangleMesh& exact) {
  const Box box = bounding_box(exact.vertices.points);
  Sheet sheet;
  for (const double noise : {0.0, 0.5, 1.0}) {
    const Subject s({.shape = "hole", .noise_percent = noise});
    sheet.add(percent(noise), s.points);
    for (const double h : {.1, .5, .9})
      sheet.add(method + ", h " + number(h, 1), s.surface(exact, method, mls(20, h, hole_spacing)));
    sheet.add(method + ", by the noise", s.surface(exact, method, {}));
  }
  // Between the corner of the cube that this direction looks at and the rim beside it.
  const Vec3 direction = view_direction(0.6, 0.6);
  const Vec3 aside{0.25 * box.size().x, 0, 0}, corner{box.max.x, box.min.y, box.max.z};
  sheet.write(folder / ("figure59-" + method + ".png"), 2400, 1400,
              close_up(direction, corner - aside, 0.33 * norm(box.size())));
}

const SynthOptions uneven{
    .shape = "boxhole", .sampling = Sampling::blue, .points = 30000, .density_gradient = 30};

void figure_66(const std::filesystem::path& folder, const std::string& method,
               const TriangleMesh& exact) {
  const Subject s(uneven);
  View view;
  view.direction = view_direction(0.6, 0.6);
  Sheet sheet;
  sheet.add("density x 30 from one side to the other", s.points);
  sheet.add(method, s.surface(exact, method, {}));
  sheet.write(folder / ("figure66-" + method + ".png"), 1600, 700, view);
}

}  // namespace

void chapter4_pictures(Report& report, const std::filesystem::path& pictures) {
  std::filesystem::create_directories(pictures);
  const TriangleMesh planes = exact_mesh({.shape = "planes"}), hole = exact_mesh({.shape = "hole"}),
                     box = exact_mesh(uneven);
  for (const ProjectionMethod& method : projection_methods()) {
    figures_58_and_62(pictures, method.name, planes);
    figures_59_and_61(pictures, method.name, hole);
    figure_66(pictures, method.name, box);
  }
  report.heading(3, "Figures 58, 59, 61, 62 and 66");
  report.text(
      "Left on disk by the run, in the folder of `--pictures` (out/bench): figure58-METHOD.png "
      "(also 62: planes at .5, 1 and 2 % noise), figure59-METHOD.png (also 61: hole at 0, .5 and "
      "1 % noise, h = .1, .5, .9), figure66-METHOD.png (uneven density). Surfaces are a mesh of "
      "the "
      "exact shape whose vertices the method has projected; figure 59 is a corner and the rim.");
}

}  // namespace spigolo::bench
