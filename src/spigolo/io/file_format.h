// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/file_format.h - which format a file is in, by its ending
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace spigolo {

enum class FileFormat : std::uint8_t { ply, xyz, csv, pts, obj, off, stl, pcd, las };

/// What the file is wanted for; names the endings in messages.
enum class FileUse : std::uint8_t { read_cloud, write_cloud, read_mesh, write_mesh };

/// By the ending, in any case of letters (.txt is xyz). Throws UsageError listing the endings known
/// for that use; InputError with the way out for .laz, .e57 and other formats that are only
/// known by name, when reading.
FileFormat file_format(const std::filesystem::path& path, FileUse use);

/// The endings for a use: ".ply .xyz ...".
std::string known_endings(FileUse use);

}  // namespace spigolo
