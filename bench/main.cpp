// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/main.cpp - measures everything and writes docs/results.md
//
// spigolo_bench [--data DIR] [--peers] [--only NAME,...] [--out FILE] [--pictures DIR]
#include <ctime>
#include <functional>
#include <iostream>
#include <string>

#include "sections.h"
#include "spigolo/core/error.h"
#include "spigolo/io/atomic_file.h"

namespace {

using spigolo::bench::Report;

struct Arguments {
  std::filesystem::path data, out = "docs/results.md", pictures = "out/bench";
  std::string only;  // names of sections between commas; empty: all
  bool peers = false;
};

struct Section {
  const char* name;
  std::function<void(Report&)> run;
};

Arguments parse(int argc, char** argv) {
  Arguments a;
  for (int i = 1; i < argc; ++i) {
    const std::string option = argv[i];
    if (option == "--peers") {
      a.peers = true;
      continue;
    }
    if (i + 1 == argc) throw spigolo::UsageError(option + " needs a value");
    if (option == "--data")
      a.data = argv[++i];
    else if (option == "--out")
      a.out = argv[++i];
    else if (option == "--pictures")
      a.pictures = argv[++i];
    else if (option == "--only")
      a.only = argv[++i];
    else
      throw spigolo::UsageError("unknown option " + option +
                                "; there are --data --peers --only --out --pictures");
  }
  return a;
}

void no_data(Report& report) {
  report.heading(2, "Real clouds");
  report.text("Not run: `./dev bench --data DIR` takes a folder of models.");
}

void no_peers(Report& report) {
  report.heading(2, "Rivals");
  report.text("Not run: `./dev bench --peers` installs and runs them.");
}

std::vector<Section> sections(const Arguments& a) {
  using namespace spigolo::bench;
  const auto shipped = a.out.parent_path() / "pictures";  // linked from the results
  return {{"thesis", thesis_tables},
          {"lattice", off_the_lattice},
          {"noise", [=](Report& r) { noise_map(r, shipped); }},
          {"fillets", fillets},
          {"creases", creases},
          {"hardships", hardships},
          {"meshing", meshing},
          {"real",
           [=](Report& r) { a.data.empty() ? no_data(r) : real_clouds(r, a.data, a.pictures); }},
          {"chapter5", [=](Report& r) { chapter5(r, a.data, shipped); }},
          {"lines", [=](Report& r) { feature_lines(r, a.data); }},
          {"speed", [=](Report& r) { speed(r, a.data); }},
          {"peers", [=](Report& r) { a.peers ? rivals_versions(r, {}) : no_peers(r); }},
          {"peers-detect", [=](Report& r) { a.peers ? rivals_detect(r, {}, a.data) : void(); }},
          {"peers-smooth", [=](Report& r) { a.peers ? rivals_smooth(r, {}) : void(); }},
          {"peers-mesh", [=](Report& r) { a.peers ? rivals_mesh(r, {}) : void(); }}};
}

/// `only` names the section or what stands before its dash.
bool chosen(const std::string& name, const std::string& only) {
  const std::string list = "," + only + ",", group = name.substr(0, name.find('-'));
  return only.empty() || list.find("," + name + ",") != std::string::npos ||
         list.find("," + group + ",") != std::string::npos;
}

void run(const Arguments& arguments) {
  Report report;
  report.heading(1, "Results");
  report.text(
      "Made by `./dev bench`; do not edit by hand. docs/benchmarks.md says what is measured and "
      "how.");
  for (const Section& section : sections(arguments)) {
    if (!chosen(section.name, arguments.only)) continue;
    std::cerr << section.name << std::flush;
    const std::clock_t start = std::clock();
    section.run(report);
    std::cerr << ": " << (std::clock() - start) / CLOCKS_PER_SEC << " s of CPU\n";
  }
  const std::string text = report.str();
  spigolo::AtomicFile out(arguments.out);
  out.write(text);
  out.commit();
  std::cerr << "wrote " << arguments.out.string() << "\n";
}

}  // namespace

int main(int argc, char** argv) {
  try {
    run(parse(argc, argv));
    return 0;
  } catch (const spigolo::UsageError& error) {
    std::cerr << "spigolo_bench: " << error.what() << "\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "spigolo_bench: " << error.what() << "\n";
    return 1;
  }
}
