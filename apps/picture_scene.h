// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/picture_scene.h - what of a file is shown, and in which colours
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "spigolo/core/triangle_mesh.h"
#include "spigolo/io/file_lines.h"
#include "spigolo/render/scene.h"

namespace spigolo {

struct SceneOptions {
  /// auto: scalar_kind, scalar_deviation, colours or truth_kind, whichever comes first in the
  /// file's attributes in this order; kind; rgb; none; else the name of an attribute.
  std::string color = "auto";
  std::optional<std::pair<double, double>> range;  // of a scalar's colours; none: from its values
  bool smooth = false, wireframe = false;          // of meshes
};

/// A scene of one file. Throws UsageError if it has no such attribute.
Scene make_scene(const TriangleMesh& mesh, const SceneOptions& options);

/// Lines over these vertices in a colour each, and a bead where they end or meet.
Scene make_line_scene(const std::vector<Vec3>& vertices, const FileLines& lines);

/// Adds the layers and legend of `more`; the first colour bar stays.
void merge(Scene& scene, Scene more);

}  // namespace spigolo
