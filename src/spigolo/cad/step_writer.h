// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/cad/step_writer.h - curves, points and faces as files that CAD programs read
#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "spigolo/cad/nurbs_face.h"

namespace spigolo {

/// A straight piece from a to b, which differ.
struct CadLine {
  Vec3 a, b;
};

/// Part of a circle, from angle `begin` to `end` [rad], begin < end <= begin + 2 pi; the whole
/// circle is 0 to 2 pi. x, y: unit and perpendicular to each other; angles turn from x to y.
struct CadArc {
  Vec3 center, x, y;
  double radius = 1;
  double begin = 0, end = 2 * pi;
};

using CadCurve = std::variant<CadLine, CadArc, NurbsCurve>;

/// The side of a round cylinder, as an analytic surface: u is the angle from x towards
/// axis cross x, v the way along the axis, from 0 to height. axis, x: unit, perpendicular.
struct CadCylinder {
  Vec3 origin, axis, x;
  double radius = 1, height = 1;
};

struct CadFace {
  std::variant<NurbsSurface, CadCylinder> surface;
  /// Closed polygons in the parameters of the surface, the outer one first and counterclockwise,
  /// holes clockwise; empty: the whole surface.
  std::vector<TrimCurve> loops{};
};

struct StepContent {
  std::vector<CadCurve> curves{};
  std::vector<Vec3> points{};
  std::vector<CadFace> faces{};
  std::string name = "spigolo";  // of the product in the file
};

/// The text of a STEP file (AP214). unit: "mm", "cm", "m", "inch"; coordinates are written as they
/// are. The same bytes every time. Throws UsageError for an unknown unit, NoResultError if there is
/// nothing to write, Error for a curve or face that is not valid.
std::string step_text(const StepContent& content, const std::string& unit = "mm");

/// The same into a file, whole or not at all. Throws as step_text and AtomicFile do.
void write_step(const std::filesystem::path& path, const StepContent& content,
                const std::string& unit = "mm");

/// The same content as IGES 5.3.
std::string iges_text(const StepContent& content, const std::string& unit = "mm");

}  // namespace spigolo
