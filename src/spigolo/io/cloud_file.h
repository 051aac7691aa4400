// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/cloud_file.h - the door of this room: clouds and meshes, read and written by ending
#pragma once

#include <cstdint>
#include <filesystem>

#include "spigolo/core/triangle_mesh.h"
#include "spigolo/io/atomic_file.h"
#include "spigolo/io/file_format.h"
#include "spigolo/io/file_lines.h"
#include "spigolo/io/input_bytes.h"
#include "spigolo/io/read_report.h"
#include "spigolo/io/write_options.h"

namespace spigolo {

/// Reads the points of .ply .xyz .txt .csv .pts .obj .off .stl .pcd .las (vertices of a mesh count
/// as points; faces are counted only). "-" is standard input: PLY if it begins so, else a table of
/// numbers. The result is valid(); it may be empty where the format can say so.
/// Throws UsageError for an unknown ending; InputError naming file, place and remedy; MemoryError.
PointCloud read_cloud(const std::filesystem::path& path, ReadReport* report = nullptr);

/// The same from memory.
PointCloud read_cloud(const InputBytes& input, FileFormat format, ReadReport* report = nullptr);

/// Reads the triangles of .ply .obj .off .stl, polygons as fans; STL vertices of equal coordinates
/// are made one. Throws as read_cloud does.
TriangleMesh read_mesh(const std::filesystem::path& path, ReadReport* report = nullptr);
/// lines: receives the lines, too, where the format has any: the element 'edge' of PLY, 'l' of OBJ.
TriangleMesh read_mesh(const InputBytes& input, FileFormat format, ReadReport* report = nullptr,
                       FileLines* lines = nullptr);

/// Writes by ending, whole or not at all; "-" writes xyz to standard output. Throws UsageError if
/// the target cannot be written or the format cannot hold the cloud, Error if the disk is full.
WriteReport write_cloud(const std::filesystem::path& path, const PointCloud& cloud,
                        const WriteOptions& options = {});
/// The same in a given format, for "-" and for several outputs that are to appear together: the
/// caller commits.
WriteReport write_cloud(AtomicFile& out, FileFormat format, const PointCloud& cloud,
                        const WriteOptions& options = {});

/// Writes .ply .obj .off .stl (binary STL keeps floats only: see WriteReport::rounding).
WriteReport write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh,
                       const WriteOptions& options = {});
WriteReport write_mesh(AtomicFile& out, FileFormat format, const TriangleMesh& mesh,
                       const WriteOptions& options = {});

}  // namespace spigolo
