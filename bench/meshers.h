// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/meshers.h - all that make a mesh of a cloud: ours and the rivals, run as programs
#pragma once

#include "smoothers.h"

namespace spigolo::bench {

/// Writes a mesh of the task's cloud to a file with that ending.
struct MeshVariant {
  std::string name;
  const char* ending;
  std::function<bool(const RivalPlaces&, const SmoothTask&, const std::string& out)> run;
};

struct Mesher {
  std::string name;
  std::vector<MeshVariant> variants;
};

/// Ours first.
std::vector<Mesher> meshers();

}  // namespace spigolo::bench
