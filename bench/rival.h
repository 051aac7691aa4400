// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/rival.h - other programs: started, timed, read; nothing of them is linked
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "spigolo/core/geometry.h"

namespace spigolo::bench {

namespace fs = std::filesystem;

/// Where things are; ./dev bench --peers builds bench/rivals into `programs`.
struct RivalPlaces {
  fs::path programs = "build/rivals", scripts = "bench/rivals", scratch = "out/rivals";
  std::string spigolo = "build/release/spigolo";

  std::string program(const char* name) const { return (programs / name).string(); }
  fs::path file(const std::string& name) const { return scratch / name; }
};

/// Runs a program to its end, at most half an hour; what it prints goes to a log in `scratch`.
/// False if it is missing, fails or takes too long.
bool run_rival(const RivalPlaces& places, const std::vector<std::string>& command);

/// The same, but the exit status; -1 if it could not be started or was killed.
int run_status(const RivalPlaces& places, const std::vector<std::string>& command);

/// The installed version of a Debian package; "not installed" without it.
std::string package_version(const RivalPlaces& places, const std::string& package);

struct OrientedPoints {
  std::vector<Vec3> points, normals;  // normals are zero where the file has none
};

void write_xyz(const fs::path& path, const std::vector<Vec3>& points,
               const std::vector<Vec3>& normals = {});
/// None if the file is not there.
std::optional<OrientedPoints> read_xyz(const fs::path& path);

/// Named columns of one number per point; not a number counts as 0.
struct Scores {
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;
};
/// The first line names the columns; the first `skip` of them are left out, as are those beyond
/// skip + take. None if the file is not there or empty.
std::optional<Scores> read_scores(const fs::path& path, std::size_t skip = 0,
                                  std::size_t take = 1000);

}  // namespace spigolo::bench
