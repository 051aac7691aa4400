// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/files.h - reading and writing, with the warnings that go with it
#pragma once

#include <string>

#include "run.h"
#include "spigolo/core/triangle_mesh.h"
#include "spigolo/io/atomic_file.h"
#include "spigolo/io/cloud_file.h"

namespace spigolo {

/// The points alone. What the reader saw goes to `report` if it is given.
PointCloud read_points(const std::string& path, const Run& run, ReadReport& report);

/// Also the triangles, where the format has any; lines go to `lines` if it is given.
TriangleMesh read_surface(const std::string& path, const Run& run, ReadReport& report,
                          FileLines* lines = nullptr);

/// How to write to standard output; a path's ending says it otherwise.
FileFormat output_format(const std::string& path, FileFormat of_stdout);

/// As write_surface, but the file appears only when it is committed.
AtomicFile staged_surface(const std::string& path, FileFormat format, const TriangleMesh& mesh,
                          Run& run, const WriteOptions& options = {});

/// Writes points, or a mesh where it has triangles and the format holds them. Warns of everything
/// the format has no place for.
void write_surface(const std::string& path, FileFormat format, const TriangleMesh& mesh, Run& run,
                   const WriteOptions& options = {});

/// Warns of what the reader found odd.
void warn(const ReadReport& report, const std::string& path, Run& run);

}  // namespace spigolo
