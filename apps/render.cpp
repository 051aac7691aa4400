// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/render.cpp - spigolo render: a picture without a screen
#include "spigolo/render/render.h"

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <utility>

#include "files.h"
#include "picture_scene.h"
#include "report.h"
#include "run.h"
#include "spigolo/core/error.h"
#include "verbs.h"

namespace spigolo {
namespace {

constexpr std::size_t bytes_per_point = 300;

const VerbHelp help = {"render",
                       "A PNG picture: points coloured by kind, meshes, deviations. Several files "
                       "stand side by side.",
                       "spigolo render scan.ply features.ply -o both.png --view 30,25 --zoom 1.5"};

struct RenderCommand {
  CommonOptions common;
  std::vector<std::string> files, panel_titles;
  std::string output;
  std::string size = "1600x1200", view = "auto", target, range;
  int colors = 0;
  bool overlay = false, flat = false, no_legend = false, no_axes = false, no_scale_bar = false;
  SceneOptions scene;
  RenderOptions picture;
};

void declare_view(CommandLine& line, RenderCommand& c) {
  line.parameter("--size", c.size, "width and height in pixels")->type_name("WxH");
  line.parameter("--view", c.view, "auto, iso, front, back, left, right, top, bottom or AZ,EL")
      ->type_name("HOW");
  line.parameter("--zoom", c.picture.view.zoom, "2 shows half the width")->type_name("X");
  line.parameter("--target", c.target, "this place in the middle")->type_name("X,Y,Z");
  line.parameter("--radius", c.picture.view.radius, "what must fit round the target; 0: all")
      ->type_name("R");
  line.switch_parameter("--orthographic", c.flat, "parallel projection");
}

void declare_look(CommandLine& line, RenderCommand& c) {
  line.parameter("--color", c.scene.color, "auto, kind, rgb, none or the name of an attribute")
      ->type_name("HOW");
  line.parameter("--range", c.range, "values at the ends of an attribute's colours")
      ->type_name("LOW,HIGH");
  line.parameter("--point-size", c.picture.point_size, "times the one that closes the surface")
      ->type_name("X");
  line.parameter("--supersampling", c.picture.supersampling, "samples a side of a pixel, 1 to 4")
      ->type_name("N");
  line.parameter("--colors", c.colors, "a small file: a palette of 2 to 256; 0: all colours")
      ->type_name("N");
  line.parameter("--title", c.picture.title, "over the picture")->type_name("TEXT");
  line.parameter("--panel-title", c.panel_titles, "of one file; repeat it for the next")
      ->take_all()
      ->expected(1)
      ->type_name("TEXT");
  line.switch_parameter("--overlay", c.overlay, "all files in one scene, not side by side");
  line.switch_parameter("--smooth", c.scene.smooth, "meshes shaded smoothly");
  line.switch_parameter("--wireframe", c.scene.wireframe, "meshes with the edges of triangles");
  line.switch_parameter("--no-legend", c.no_legend, "without legend and colour bar");
  line.switch_parameter("--no-axes", c.no_axes, "without the tripod");
  line.switch_parameter("--no-scale-bar", c.no_scale_bar, "without the scale bar");
}

void declare(CommandLine& line, RenderCommand& c) {
  line.app()
      .add_option("FILE", c.files, "clouds, meshes and lines; - is standard input")
      ->required();
  line.app().add_option("-o,--output", c.output, "the picture")->required()->type_name("PIC.png");
  declare_view(line, c);
  declare_look(line, c);
}

// `count` numbers between separators, or UsageError.
std::vector<double> numbers(const std::string& option, const std::string& text, char separator,
                            std::size_t count) {
  std::vector<double> values;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) {
    char* end = nullptr;
    values.push_back(std::strtod(part.c_str(), &end));
    if (part.empty() || *end != '\0') values.push_back(not_a_number);
  }
  bool sound = values.size() == count;
  for (const double value : values) sound = sound && std::isfinite(value);
  if (!sound)
    throw UsageError(option + " " + text + ": expected " + std::to_string(count) +
                     " numbers separated by '" + separator + "'");
  return values;
}

void settle(RenderCommand& c) {
  if (c.output != "-" && lower_extension(c.output) != ".png")
    throw UsageError("render writes PNG: name the output " + c.output + ".png");
  check_output(c.output, c.common);
  const auto size = numbers("--size", c.size, 'x', 2);
  for (const double side : size)
    if (!(side >= 16 && side <= 16384))
      throw UsageError("--size must be 16 to 16384 pixels a side");
  c.picture.width = static_cast<int>(size[0]), c.picture.height = static_cast<int>(size[1]);
  c.picture.view.direction = parse_view_direction(c.view);
  if (!c.target.empty()) {
    const auto at = numbers("--target", c.target, ',', 3);
    c.picture.view.target = Vec3{at[0], at[1], at[2]};
  }
  if (!c.range.empty()) {
    const auto ends = numbers("--range", c.range, ',', 2);
    c.scene.range = std::pair(ends[0], ends[1]);
  }
  if (c.colors != 0 && (c.colors < 2 || c.colors > 256))
    throw UsageError("--colors must be 2 to 256, or 0 for all");
  c.picture.view.perspective = !c.flat;
  c.picture.legend = !c.no_legend;
  c.picture.axes = !c.no_axes;
  c.picture.scale_bar = !c.no_scale_bar;
}

std::string panel_title(const RenderCommand& c, std::size_t i) {
  if (i < c.panel_titles.size()) return c.panel_titles[i];
  return c.files.size() == 1 ? "" : std::filesystem::path(c.files[i]).filename().string();
}

Scene read_scene(const std::string& path, const SceneOptions& options, Run& run) {
  ReadReport seen;
  FileLines lines;
  const TriangleMesh mesh = read_surface(path, run, seen, &lines);
  run.check_memory(mesh.vertices.size(), bytes_per_point);
  if (bounding_box(mesh.vertices.points).empty())
    run.warn(path + " has no point with finite coordinates; there is nothing to see of it");
  warn(seen, path, run);
  if (mesh.triangles.empty() && !lines.empty()) return make_line_scene(mesh.vertices.points, lines);
  return make_scene(mesh, options);
}

std::vector<Panel> read_panels(const RenderCommand& c, Run& run) {
  std::vector<Panel> panels;
  for (std::size_t i = 0; i < c.files.size(); ++i) {
    Scene scene = read_scene(c.files[i], c.scene, run);
    if (c.overlay && i > 0)
      merge(panels.front().scene, std::move(scene));
    else
      panels.push_back({std::move(scene), panel_title(c, i)});
  }
  return panels;
}

Image draw(const RenderCommand& c, const std::vector<Panel>& panels, const Job& job) {
  if (panels.size() > 1) return render_panels(panels, c.picture, job);
  RenderOptions options = c.picture;
  if (options.title.empty() && !c.overlay) options.title = panels.front().title;
  return render(panels.front().scene, options, job);
}

}  // namespace

void run_render(const std::vector<std::string>& arguments) {
  RenderCommand c;
  CommandLine line(help, c.common);
  declare(line, c);
  if (!line.parse(arguments)) return;
  settle(c);

  Run run(c.common);
  const std::vector<Panel> panels = read_panels(c, run);
  const double seconds_read = run.lap();
  const std::vector<std::byte> png = encode_png(draw(c, panels, run.job()), c.colors);
  AtomicFile file(c.output);
  file.write({reinterpret_cast<const char*>(png.data()), png.size()});
  file.commit();
  save_parameters(c.common, help, line.parameters());

  const Json json = {
      {"output", c.output},
      {"width", c.picture.width},
      {"height", c.picture.height},
      {"panels", panels.size()},
      {"seconds", {{"read", seconds_read}, {"draw", run.lap()}, {"total", run.total_seconds()}}}};
  run.print(json, c.output + ": " + c.size + " pixels\n", c.output == "-");
}

}  // namespace spigolo
