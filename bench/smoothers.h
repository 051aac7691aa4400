// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/smoothers.h - all that project points onto a surface: ours and the rivals, run as programs
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "rival.h"

namespace spigolo::bench {

/// What is to be projected, in files too: cloud.xyz without normals, oriented.xyz with CGAL's.
struct SmoothTask {
  std::vector<Vec3> points;   // noisy
  std::vector<Vec3> queries;  // more places, for those who project any place
  double spacing = 0;         // mean
  bool oriented = false;      // oriented.xyz is there
};

/// One row a point, and a query where the program takes queries.
struct Projected {
  OrientedPoints points;
  std::vector<Vec3> queries;
};

struct SmoothVariant {
  std::string name;  // its setting
  std::function<std::optional<Projected>(const RivalPlaces&, const SmoothTask&)> run;
};

struct Smoother {
  std::string name;
  std::vector<SmoothVariant> variants;
};

/// Ours first.
std::vector<Smoother> smoothers();

/// Writes cloud.xyz, and oriented.xyz by CGAL's PCA and spanning tree with k neighbors.
SmoothTask prepare_task(const RivalPlaces& places, std::vector<Vec3> points,
                        std::vector<Vec3> queries, double spacing, int k);

/// A parameter of a filter in meshlabserver's script; type is one of its RichFloat, RichInt ...
std::string filter_parameter(const char* name, const char* type, const std::string& value);

/// The parameters that only RIMLS, or only APSS, has: one setting for points and for meshes.
std::string rimls_parameters();
std::string apss_parameters();

/// meshlabserver on a script of one filter; inputs in the order of their numbers there.
bool run_meshlab(const RivalPlaces& places, const std::vector<fs::path>& inputs,
                 const fs::path& output, const std::string& filter);

}  // namespace spigolo::bench
