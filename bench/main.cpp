// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/main.cpp - measures everything and writes docs/results.md
//
// spigolo_bench [--data DIR] [--peers] [--out FILE] [--pictures DIR]
#include <iostream>
#include <string>

#include "sections.h"
#include "spigolo/core/error.h"
#include "spigolo/io/atomic_file.h"

namespace {

struct Arguments {
  std::filesystem::path data, out = "docs/results.md", pictures = "out/bench";
  bool peers = false;
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
    else
      throw spigolo::UsageError("unknown option " + option +
                                "; there are --data --peers --out --pictures");
  }
  return a;
}

void run(const Arguments& arguments) {
  using namespace spigolo::bench;
  Report report;
  report.heading(1, "Results");
  report.text(
      "Made by `./dev bench`; do not edit by hand. docs/benchmarks.md says what is measured and "
      "how.");
  std::cerr << "thesis's tables\n";
  thesis_tables(report);
  std::cerr << "off the lattice\n";
  off_the_lattice(report);
  if (arguments.data.empty()) {
    report.heading(2, "Real clouds");
    report.text("Not run: `./dev bench --data DIR` takes a folder of models.");
  } else {
    std::cerr << "real clouds\n";
    real_clouds(report, arguments.data, arguments.pictures);
  }
  std::cerr << "speed\n";
  speed(report, arguments.data);
  if (arguments.peers) {
    report.heading(2, "Peers");
    report.text("This version compares with no other program yet.");
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
