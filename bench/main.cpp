// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/main.cpp - measures everything and writes docs/results.md, docs/results.json and, with
// --peers, docs/rivals.md and docs/rivals.json
//
// spigolo_bench [--data DIR] [--peers] [--large] [--only NAME,...] [--out FILE] [--pictures DIR]
#include <functional>
#include <iostream>
#include <string>

#include "claims.h"
#include "environment.h"
#include "meter.h"
#include "sections.h"
#include "spigolo/core/error.h"
#include "spigolo/io/atomic_file.h"

namespace {

using spigolo::bench::Report;

struct Arguments {
  std::filesystem::path data, out, pictures = "out/bench";  // out: results.md in some folder
  std::string only;  // names of sections between commas; empty: all
  bool peers = false;
  bool large = false;  // speed up to ten million points
};

struct Section {
  const char* name;
  std::function<void(Report&)> run;
};

Arguments parse(int argc, char** argv) {
  Arguments a;
  for (int i = 1; i < argc; ++i) {
    const std::string option = argv[i];
    if (option == "--peers" || option == "--large") {
      (option == "--peers" ? a.peers : a.large) = true;
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
                                "; there are --data --peers --large --only --out --pictures");
  }
  // a part of the sections must not take the place of all
  if (a.out.empty()) a.out = a.only.empty() ? "docs/results.md" : "out/bench/results.md";
  return a;
}

void no_data(Report& report) {
  report.heading(2, "Real clouds");
  report.text("Not run: `./dev bench --data DIR` takes a folder of models.");
}

void name_rivals(Report& report) {
  report.heading(2, "Rivals");
  report.text(
      "[rivals.md](rivals.md) has what CGAL, PCL, MeshLab, CloudCompare and Open3D do on the same "
      "clouds. Only `./dev bench --peers` writes it, so it may be older than this page.");
}

std::vector<Section> sections(const Arguments& a) {
  using namespace spigolo::bench;
  const auto shipped = a.out.parent_path() / "pictures";  // linked from the results
  return {{"thesis", thesis_tables},
          {"lattice", off_the_lattice},
          {"noise", [=](Report& r) { noise_map(r, shipped); }},
          {"fillets", [=](Report& r) { fillets(r, shipped); }},
          {"creases", creases},
          {"hardships", hardships},
          {"chapter4", [=](Report& r) { chapter4(r, a.data, a.large); }},
          {"figures", [=](Report& r) { chapter4_pictures(r, a.pictures); }},
          {"meshing", [=](Report& r) { meshing(r, a.data, a.pictures, a.large); }},
          {"pictures", [=](Report& r) { document_pictures(r, shipped); }},
          {"real",
           [=](Report& r) { a.data.empty() ? no_data(r) : real_clouds(r, a.data, a.pictures); }},
          {"chapter5", [=](Report& r) { chapter5(r, a.data, shipped); }},
          {"lines", [=](Report& r) { feature_lines(r, a.data); }},
          {"determinism", determinism},
          {"speed", [=](Report& r) { speed(r, a.data, shipped, a.large); }},
          {"peers", name_rivals}};
}

std::vector<Section> rival_sections(const Arguments& a, spigolo::bench::Scoreboard& board) {
  using namespace spigolo::bench;
  const auto shipped = a.out.parent_path() / "pictures";
  return {{"peers", [](Report& r) { rivals_versions(r, {}); }},
          {"peers-detect", [=, &board](Report& r) { rivals_detect(r, {}, a.data, board); }},
          {"peers-published", rivals_published},
          {"peers-smooth", [&board](Report& r) { rivals_smooth(r, {}, board); }},
          {"peers-mesh", [=, &board](Report& r) {
             rivals_mesh(r, {}, {shipped, a.pictures}, board);
           }}};
}

/// `only` names the section or what stands before its dash.
bool chosen(const std::string& name, const std::string& only) {
  const std::string list = "," + only + ",", group = name.substr(0, name.find('-'));
  return only.empty() || list.find("," + name + ",") != std::string::npos ||
         list.find("," + group + ",") != std::string::npos;
}

/// Runs the chosen sections in their order, then says what each has cost.
void run_sections(Report& report, const std::vector<Section>& list, const std::string& only) {
  using spigolo::bench::children_seconds;
  using spigolo::bench::cpu_seconds;
  using spigolo::bench::number;
  using spigolo::bench::wall_seconds;
  std::vector<std::vector<std::string>> cost;
  double all_cpu = 0, all_wall = 0;
  for (const Section& section : list) {
    if (!chosen(section.name, only)) continue;
    std::cerr << section.name << std::flush;
    const double cpu = cpu_seconds() + children_seconds(), wall = wall_seconds();
    section.run(report);
    const double used = cpu_seconds() + children_seconds() - cpu, elapsed = wall_seconds() - wall;
    std::cerr << ": " << number(used) << " s of CPU\n";
    cost.push_back({section.name, number(used, 1), number(elapsed, 1)});
    all_cpu += used, all_wall += elapsed;
  }
  cost.push_back({"all", number(all_cpu, 1), number(all_wall, 1)});
  report.heading(2, "What the sections of this page cost");
  report.table({"section", "CPU [s]", "wall [s]"}, cost);
}

/// As Markdown and, beside it, as JSON.
void write_page(const Report& report, const std::filesystem::path& path) {
  const std::filesystem::path json = std::filesystem::path(path).replace_extension(".json");
  std::filesystem::create_directories(path.parent_path());
  for (const auto& [file, text] : {std::pair{path, report.str()}, std::pair{json, report.json()}}) {
    spigolo::AtomicFile out(file);
    out.write(text);
    out.commit();
  }
  std::cerr << "wrote " << path.string() << "\n";
}

constexpr const char* made =
    "Made by `./dev bench`; do not edit by hand. docs/benchmarks.md says what is measured and how.";

/// On both pages the summary stands first, and is known last.
void write_results(const Arguments& a) {
  Report page("Results", made), body("Results");
  run_sections(body, sections(a), a.only);
  spigolo::bench::write_claims(page, body);
  page.append(body);
  spigolo::bench::environment(page);
  write_page(page, a.out);
}

void write_rivals(const Arguments& a) {
  spigolo::bench::Scoreboard board;
  Report page("Rivals", made), body("Rivals");
  run_sections(body, rival_sections(a, board), a.only);
  board.write(page);
  page.append(body);
  spigolo::bench::environment(page);
  write_page(page, a.out.parent_path() / "rivals.md");
}

void run(const Arguments& a) {
  write_results(a);
  if (a.peers) write_rivals(a);
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
