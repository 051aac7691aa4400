// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/chapter4_pictures.cpp - figures 58, 59, 61, 62 and 66 with our data
#include "picture.h"
#include "projection.h"
#include "sections.h"
#include "spigolo/detect/detect.h"

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

  void write(const std::filesystem::path& path, int width, int height,
             const std::optional<Vec3>& direction) const {
    RenderOptions options = bare_look(width, height);
    options.view.direction = direction;
    save_picture(path, render_panels(panels, options));
  }
};

// A cloud with all it takes to project it.
struct Subject {
  std::vector<Vec3> points;
  MlsCloud cloud;
  std::vector<PointKind> kind;

  explicit Subject(const SynthOptions& options)
      : points(make_cloud(options).cloud.points),
        cloud(points),
        kind(detect(points).features.kind) {}

  std::vector<Vec3> projected(const std::string& method, const MlsOptions& options) const {
    const Projection project = projection_method(method).make(cloud, kind, options);
    std::vector<Vec3> result;
    for (const Vec3& p : points) result.push_back(project(p).position);
    return result;
  }
};

MlsOptions mls(std::size_t k, double h, double spacing) {
  MlsOptions options;
  options.k = k;
  options.smoothing = h / spacing;
  return options;
}

constexpr double hole_spacing = .111, planes_spacing = .1;  // in the thesis's units, as h is

std::string percent(double noise) { return number(noise, 1) + " % noise"; }

void figures_58_and_62(const std::filesystem::path& folder, const std::string& method) {
  Sheet sheet;
  for (const double noise : {0.5, 1.0, 2.0}) {
    const Subject s({.shape = "planes", .noise_percent = noise});
    sheet.add(percent(noise), s.points);
    sheet.add(method + ", k 20, h .1", s.projected(method, mls(20, .1, planes_spacing)));
    sheet.add(method + ", k 40, h .5", s.projected(method, mls(40, .5, planes_spacing)));
    sheet.add(method + ", by the noise", s.projected(method, {}));
  }
  sheet.write(folder / ("figure58-" + method + ".png"), 2000, 1000, std::nullopt);
}

void figures_59_and_61(const std::filesystem::path& folder, const std::string& method) {
  Sheet sheet;
  for (const double noise : {0.0, 0.5, 1.0}) {
    const Subject s({.shape = "hole", .noise_percent = noise});
    sheet.add(percent(noise), s.points);
    for (const double h : {.1, .5, .9})
      sheet.add(method + ", h " + number(h, 1), s.projected(method, mls(20, h, hole_spacing)));
    sheet.add(method + ", by the noise", s.projected(method, {}));
  }
  sheet.write(folder / ("figure59-" + method + ".png"), 2400, 1400, view_direction(0.6, 0.6));
}

void figure_66(const std::filesystem::path& folder, const std::string& method) {
  const Subject s(
      {.shape = "boxhole", .sampling = Sampling::blue, .points = 30000, .density_gradient = 30});
  Sheet sheet;
  sheet.add("density x 30 from one side to the other", s.points);
  sheet.add(method, s.projected(method, {}));
  sheet.write(folder / ("figure66-" + method + ".png"), 1600, 700, view_direction(0.6, 0.6));
}

}  // namespace

void chapter4_pictures(Report& report, const std::filesystem::path& pictures) {
  std::filesystem::create_directories(pictures);
  for (const ProjectionMethod& method : projection_methods()) {
    figures_58_and_62(pictures, method.name);
    figures_59_and_61(pictures, method.name);
    figure_66(pictures, method.name);
  }
  report.heading(3, "Figures 58, 59, 61, 62 and 66");
  report.text(
      "Left on disk by the run, in the folder of `--pictures` (out/bench): figure58-METHOD.png "
      "(also 62: planes at .5, 1 and 2 % noise), figure59-METHOD.png (also 61: hole at 0, .5 and "
      "1 % noise, h = .1, .5, .9), figure66-METHOD.png (uneven density).");
}

}  // namespace spigolo::bench
