// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/shaded_mesh.cpp - OBJ with smoothing groups and lines
#include "spigolo/io/shaded_mesh.h"

#include <algorithm>
#include <numeric>
#include <string>

#include "spigolo/core/error.h"
#include "spigolo/io/scalar.h"
#include "spigolo/io/text.h"

namespace spigolo {
namespace {

void append_position(std::string& out, const Vec3& p) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    out += ' ';
    append_number(out, p[axis], ScalarType::float64);
  }
}

// Triangles in the order of their groups, each group named once.
std::vector<std::size_t> by_patch(const ShadedMesh& shaded) {
  std::vector<std::size_t> order(shaded.patch.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return shaded.patch[a] < shaded.patch[b]; });
  return order;
}

}  // namespace

void validate(const ShadedMesh& shaded) {
  validate(shaded.mesh);
  const std::size_t n = shaded.mesh.vertices.size(), m = shaded.mesh.triangles.size();
  const bool exist = std::all_of(shaded.creases.begin(), shaded.creases.end(),
                                 [&](const auto& e) { return e[0] < n && e[1] < n; });
  if (shaded.patch.size() != m || shaded.corner_normals.size() != m || !exist)
    throw Error("shaded mesh: its arrays do not fit the mesh");
}

void write_shaded_obj(AtomicFile& out, const ShadedMesh& shaded, WriteReport& report) {
  for (const Attribute& a : shaded.mesh.vertices.attributes) report.dropped.push_back(a.name);
  std::string line;
  for (const Vec3& p : shaded.mesh.vertices.points) {
    line = "v";
    append_position(line, p);
    line += '\n';
    out.write(line);
  }
  const auto number = [](std::uint32_t v) { return " " + std::to_string(std::uint64_t{v} + 1); };
  std::uint64_t group = 0;  // of the triangle before; no patch has that number
  for (const std::size_t t : by_patch(shaded)) {
    if (const std::uint64_t here = std::uint64_t{shaded.patch[t]} + 1; here != group) {
      group = here;
      out.write("s " + std::to_string(group) + "\n");
    }
    line = "f";
    for (const std::uint32_t v : shaded.mesh.triangles[t]) line += number(v);
    out.write(line + "\n");
  }
  for (const auto& [a, b] : shaded.creases) out.write("l" + number(a) + number(b) + "\n");
}

}  // namespace spigolo
