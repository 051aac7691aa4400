// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/determinism.cpp - the bytes of every kind of output for one, two, three and eight threads
#include <cstdint>
#include <fstream>
#include <iterator>

#include "blend_scenes.h"
#include "moved_inputs.h"
#include "sections.h"
#include "spigolo/cad/step_writer.h"
#include "spigolo/io/cloud_file.h"
#include "spigolo/synth/synth.h"

namespace spigolo::bench {
namespace {

constexpr int threads[] = {1, 2, 3, 8};

/// One call of the program; the names of its outputs stand after each "-o" or "--mesh".
struct Call {
  std::vector<std::string> words;  // without program and threads
};

std::vector<Call> calls_on(const std::string& cloud) {
  std::vector<Call> calls;
  for (const char* method : {"sheets", "gauss-map", "gauss-map-global"})
    calls.push_back({{"detect", cloud, "--method", method, "-o", "labels.ply"}});
  calls.push_back({{"render", "labels.ply", "-o", "labels.png"}});
  calls.push_back({{"lines", cloud, "-o", "lines.json", "-o", "lines.dxf", "-o", "lines.step", "-o",
                    "lines.obj", "-o", "lines.ply", "-o", "lines.vtp", "-o", "lines.csv"}});
  for (const char* method : {"sheets", "feature-line", "plain"})
    calls.push_back({{"smooth", cloud, "--method", method, "-o", "smooth.ply"}});
  for (const char* file : {"mesh.glb", "mesh.ply"}) calls.push_back({{"mesh", cloud, "-o", file}});
  for (const char* ending : {"obj", "stl", "off"})
    calls.push_back({{"convert", "mesh.ply", "-o", std::string("mesh.") + ending}});
  return calls;
}

std::vector<Call> blend_calls() {
  const std::string cloud = "cube.ply", face = "tube.step";
  return {{{"blend", cloud, face, "--start", "v1", "-o", "blend.ply", "-o", "collar.step", "--mesh",
            "blend-mesh.ply"}},
          {{"blend", cloud, face, "--start", "v1", "--method", "linear", "-o", "blend.ply"}},
          {{"blend", cloud, face, "--start", "v1", "--sharp", "-o", "blend.ply"}}};
}

bool names_output(const std::string& word) { return word == "-o" || word == "--mesh"; }

std::string title_of(const Call& call) {
  std::string title = call.words[0];
  for (std::size_t i = 1; i < call.words.size(); ++i)
    if (call.words[i] == "--method" || call.words[i] == "--sharp")
      title += " " + call.words[call.words[i] == "--sharp" ? i : i + 1];
  return title;
}

std::string content_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// FNV-1a, 64 bits.
std::string hash_of(const std::string& bytes) {
  std::uint64_t hash = 14695981039346656037u;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

/// What the call writes, file by file; empty texts if it fails.
std::vector<std::string> outputs_of(const RivalPlaces& places, const Call& call, int with) {
  std::vector<std::string> command = {places.spigolo}, contents;
  std::vector<fs::path> outputs;
  for (std::size_t i = 0; i < call.words.size(); ++i) {
    const bool file = call.words[i].find('.') != std::string::npos;
    command.push_back(file ? places.file(call.words[i]).string() : call.words[i]);
    if (file && names_output(call.words[i - 1])) outputs.push_back(places.file(call.words[i]));
  }
  command.insert(command.end(), {"--quiet", "--threads", std::to_string(with)});
  const bool done = run_rival(places, command);
  for (const fs::path& path : outputs) contents.push_back(done ? content_of(path) : "");
  return contents;
}

std::string verdict(const std::string& one, const std::string& other) {
  if (one.empty() || other.empty()) return "failed";
  if (one == other) return "same";
  std::size_t differ = std::max(one.size(), other.size()) - std::min(one.size(), other.size());
  for (std::size_t i = 0; i < std::min(one.size(), other.size()); ++i) differ += one[i] != other[i];
  return "differs (" + std::to_string(differ) + " bytes)";
}

void add_rows(const RivalPlaces& places, const std::string& input, const Call& call,
              std::vector<std::vector<std::string>>& rows) {
  std::vector<std::vector<std::string>> contents;  // by threads, by output
  for (const int with : threads) contents.push_back(outputs_of(places, call, with));
  std::size_t output = 0;
  for (std::size_t i = 1; i < call.words.size(); ++i) {
    if (!names_output(call.words[i - 1])) continue;
    const std::string& one = contents[0][output];
    std::vector<std::string> row = {input, title_of(call), call.words[i],
                                    std::to_string(one.size()), hash_of(one)};
    for (std::size_t t = 1; t < contents.size(); ++t)
      row.push_back(verdict(one, contents[t][output]));
    rows.push_back(row);
    ++output;
  }
}

void hashes(Report& report, const RivalPlaces& places) {
  report.heading(3, "Every output for 1, 2, 3 and 8 threads");
  report.text(
      "The program itself, file by file: bytes and hash (FNV-1a, 64 bits) with one thread; with "
      "more threads the same bytes or how many differ. Random samples of `boxhole` without noise, "
      "blue ones of `l-prism` with noise .25, 3000 each, seed 91; the thesis's cube with a tube.");
  fs::create_directories(places.scratch);
  std::vector<std::vector<std::string>> rows;
  for (const SynthOptions& options : moved_inputs()) {
    const std::string name = options.shape, file = name + ".ply";
    write_cloud(places.file(file), make_cloud(options).cloud);
    for (const Call& call : calls_on(file)) add_rows(places, name, call, rows);
  }
  const BlendScene scene = tube_on_cube();
  PointCloud cube;
  cube.points = scene.cloud;
  write_cloud(places.file("cube.ply"), cube);
  write_step(places.file("tube.step"), {.faces = {{scene.face.surface}}});
  for (const Call& call : blend_calls()) add_rows(places, "cube and tube", call, rows);
  report.table({"input", "verb", "file", "bytes", "hash, 1 thread", "2", "3", "8"}, rows);
}

}  // namespace

void determinism(Report& report) {
  report.heading(2, "Determinism");
  RivalPlaces places;
  places.scratch = "out/determinism";
  hashes(report, places);
  moved_inputs_tables(report);
  guarantees(report, places);
}

}  // namespace spigolo::bench
