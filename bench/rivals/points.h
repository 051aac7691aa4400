// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/rivals/points.h - tables of numbers in text files, one row a line
#pragma once

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

using Point = std::array<double, 3>;

/// One row: x y z, and nx ny nz where there are normals.
struct Oriented {
  Point p{}, n{};
};

[[noreturn]] inline void fail(const std::string& message) {
  std::cerr << message << "\n";
  std::exit(1);
}

inline std::vector<Oriented> read_points(const char* path) {
  std::ifstream in(path);
  if (!in) fail(std::string("cannot read ") + path);
  std::vector<Oriented> points;
  for (std::string line; std::getline(in, line);) {
    std::istringstream row(line);
    Oriented o;
    if (row >> o.p[0] >> o.p[1] >> o.p[2]) {
      row >> o.n[0] >> o.n[1] >> o.n[2];
      points.push_back(o);
    }
  }
  return points;
}

inline void write_row(std::FILE* out, const std::vector<double>& row) {
  for (std::size_t i = 0; i < row.size(); ++i)
    std::fprintf(out, i == 0 ? "%.17g" : " %.17g", row[i]);
  std::fputc('\n', out);
}

inline void write_points(const char* path, const std::vector<Oriented>& points) {
  std::FILE* out = std::fopen(path, "w");
  if (!out) fail(std::string("cannot write ") + path);
  for (const Oriented& o : points) write_row(out, {o.p[0], o.p[1], o.p[2], o.n[0], o.n[1], o.n[2]});
  std::fclose(out);
}

/// A score for every point in every column: the first line names the columns.
struct Scores {
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;

  void add(const std::string& name, std::vector<double> column) {
    names.push_back(name);
    columns.push_back(std::move(column));
  }
};

inline void write_scores(const char* path, const Scores& scores) {
  std::FILE* out = std::fopen(path, "w");
  if (!out) fail(std::string("cannot write ") + path);
  for (std::size_t c = 0; c < scores.names.size(); ++c)
    std::fprintf(out, "%s%s", c == 0 ? "" : " ", scores.names[c].c_str());
  std::fputc('\n', out);
  for (std::size_t i = 0; i < scores.columns.at(0).size(); ++i) {
    std::vector<double> row;
    for (const auto& column : scores.columns) row.push_back(column[i]);
    write_row(out, row);
  }
  std::fclose(out);
}
