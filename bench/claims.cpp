// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/claims.cpp
#include "claims.h"

#include <algorithm>
#include <cstdlib>
#include <functional>

#include "spigolo/core/geometry.h"

namespace spigolo::bench {
namespace {

using Row = std::vector<std::string>;
using Filter = std::function<bool(const Row&)>;

/// The nth table under a heading, or its part: rows that pass a filter.
class Part {
 public:
  Part(const Report& report, const std::string& heading, std::size_t nth = 0) {
    for (const Report::Table& table : report.tables()) {
      if (table.section.back() != heading || nth-- > 0) continue;
      head_ = table.head, rows_ = table.rows;
      return;
    }
  }
  Part where(const Filter& filter) const {
    Part part = *this;
    std::erase_if(part.rows_, [&](const Row& row) { return !filter(row); });
    return part;
  }
  bool empty() const { return rows_.empty(); }

  /// The cells of the nth column with that head; empty without one.
  Row cells(const std::string& column, int nth = 0) const {
    auto found = std::find(head_.begin(), head_.end(), column);
    for (; nth > 0 && found != head_.end(); --nth)
      found = std::find(found + 1, head_.end(), column);
    Row cells;
    if (found == head_.end()) return cells;
    const auto at = static_cast<std::size_t>(found - head_.begin());
    for (const Row& row : rows_)
      if (at < row.size()) cells.push_back(row[at]);
    return cells;
  }
  /// Smallest and largest, with the digits that the table has; one cell as it is.
  std::string range(const std::string& column, int nth = 0) const {
    const Row all = cells(column, nth);
    if (all.empty()) return "-";
    const auto less = [](const auto& a, const auto& b) {
      return std::atof(a.c_str()) < std::atof(b.c_str());
    };
    const auto [low, high] = std::minmax_element(all.begin(), all.end(), less);
    return *low == *high ? *low : *low + " to " + *high;
  }
  std::string most(const std::string& column) const {
    const std::string text = range(column);
    const std::size_t to = text.find(" to ");
    return to == std::string::npos ? text : text.substr(to + 4);
  }
  const std::vector<Row>& rows() const { return rows_; }

 private:
  Row head_;
  std::vector<Row> rows_;
};

Filter starts_with(const Row& cells) {
  return [cells](const Row& row) {
    return row.size() >= cells.size() && std::equal(cells.begin(), cells.end(), row.begin());
  };
}

/// Rows of the form: claim, by `sheets`, by `gauss-map`, heading of the rows it is read off.
class Claims {
 public:
  explicit Claims(const Report& body) : body_(body) {}

  void add(const Part& part, const std::string& claim, const std::string& heading,
           const std::string& sheets, const std::string& gauss_map = "") {
    if (!part.empty()) rows.push_back({claim, sheets, gauss_map, heading});
  }

  void detection() {
    const std::string table1 = "Table 1: constructed lattices, default settings";
    for (const char* set : {"cube", "planes", "hole"}) {
      const Part part = Part(body_, table1).where(starts_with({set}));
      add(part, std::string("`") + set + "`: feature points found", table1, part.range("`sheets`"),
          part.range("`gauss-map`"));
    }
    const std::string lattice = "Off the lattice: what the thesis could not see";
    for (const char* noise : {"0.00", "0.25", "0.50", "1.00"}) {
      const Part part = Part(body_, lattice).where([noise](const Row& row) {
        return row[0] == "box" && row[2] == noise;
      });
      add(part, std::string("box beside its edges, noise ") + noise + " h: tolerant F1", lattice,
          part.range("`sheets`: tolerant F1"), part.range("automatic: tolerant F1"));
    }
    const std::string abc = "Nine labelled ABC clouds";
    for (const std::size_t nth : {0u, 1u}) {
      const Part part = Part(body_, abc, nth).where(starts_with({"mean"}));
      add(part, nth == 0 ? "ABC clouds, clean: mean thin F1" : "the same with noise", abc,
          part.range("F1"), part.range("F1", 1));
    }
    const std::string smooth = "Shapes without an edge: false flags in 1000 points, without noise";
    const Part part = Part(body_, smooth).where([](const Row& row) {
      return row[0] == "torus" || row[0] == "fillet-box";
    });
    add(part, "torus, rounded box: false marks in 1000 points", smooth, part.range("`sheets`"),
        part.range("`gauss-map`"));
  }

  void pictures() {
    const std::string heading = "Pictures of the documents";
    const Part part = Part(body_, heading).where(starts_with({"hole.png"}));
    add(part, "the picture of `hole`: points, found", heading,
        part.range("points") + " points: " + part.range("found"));
  }

  void noise() {
    const std::string map = "Angle against noise";
    for (const char* noise : {"0.50", "1.00"}) {
      const Part part = Part(body_, map).where(starts_with({noise}));
      add(part,
          std::string("noise ") + noise + " h: F1 of .9 and .5 from 60 degrees up to, nothing from",
          map,
          part.range(".9 up to") + ", " + part.range(".5 up to") + ", " +
              part.range("nothing from"));
    }
  }

  void lines() {
    const std::string counts = "Curves and corners, without noise";
    int right = 0, all = 0;
    const Part part(body_, counts);
    for (const Row& row : part.rows())
      for (std::size_t c = 2; c < row.size(); ++c) all += row[c] != "-", right += row[c] == row[1];
    add(part, "clouds without noise with the right curves and corners", counts, of(right, all));
    const std::string distance = "Distance between curves and true edges, without noise";
    const Part off(body_, distance);
    add(off, "the same: mean and largest distance to the true edges [spacings], at most", distance,
        off.most("mean off") + ", " + off.most("max off"));
  }

  void meshes() {
    const std::string heading = "Closed shapes without noise";
    const Part part(body_, heading);
    int closed = 0, sound = 0, kept = 0, creases = 0;
    for (const Row& row : part.rows()) {
      closed += row[2] == "yes";
      sound += row[3] == "yes" && row[5] == "0";
      kept += std::atoi(row[6].c_str());
      creases += std::atoi(row[6].substr(row[6].find('/') + 1).c_str());
    }
    const int all = static_cast<int>(part.rows().size());
    add(part, "meshes of closed shapes: closed; manifold without self-intersection", heading,
        of(closed, all) + "; " + of(sound, all));
    add(part, "the same: crease edges kept", heading, of(kept, creases));
  }

  void blends() {
    const std::string heading = "Chapter 5: blending with NURBS surfaces";
    const Part part =
        Part(body_, heading).where([](const Row& row) { return row[1] == "tangent"; });
    add(part, "blends: ripple of the collar [spacings], at most", heading, part.most("ripple"));
    add(part, "the same: largest gap [spacings]", heading, part.most("gap"));
  }

  void determinism() {
    const std::string threads = "Every output for 1, 2, 3 and 8 threads";
    const Part part(body_, threads);
    int same = 0;
    for (const Row& row : part.rows())
      same += std::all_of(row.begin() + 5, row.end(), [](const auto& c) { return c == "same"; });
    add(part, "outputs with the same bytes for 1, 2, 3 and 8 threads", threads,
        of(same, static_cast<int>(part.rows().size())));
    const std::string moved = "The same cloud in another order, direction, size and place";
    const Part labels =
        Part(body_, moved).where([](const Row& row) { return row[1].starts_with("detect"); });
    same = 0;
    for (const Row& row : labels.rows()) same += row[3] == "same";
    add(labels, "clouds and methods with the same labels in another order of the points", moved,
        of(same, static_cast<int>(labels.rows().size())));
  }

  void guarantees() {
    const std::string heading = "Exit statuses, and an older file in the output's place";
    const Part part(body_, heading);
    int right = 0, kept = 0, failed = 0;
    for (const Row& row : part.rows()) {
      right += row[1] == row[2];
      failed += row[1] != "0", kept += row[1] != "0" && row[3] == "as it was";
    }
    add(part, "exit statuses as promised; failing runs that left an older file as it was", heading,
        of(right, static_cast<int>(part.rows().size())) + "; " + of(kept, failed));
  }

  void speed() {
    const std::string sizes = "Detection by size", noisy = "Detection with noise";
    const Part part = Part(body_, sizes).where(starts_with({"box", "1000000"}));
    add(part, "million points labelled a second, one core, no noise", sizes,
        part.range("M points/s, one core"));
    const Part noise = Part(body_, noisy).where(starts_with({"0.50"}));
    const double cost = std::atof(noise.range("us a point").c_str());
    add(noise, "the same, noise 0.5 h", noisy, number(1 / cost, 3));
  }

  std::vector<Row> rows;

 private:
  static std::string of(int part, int all) {
    return std::to_string(part) + " of " + std::to_string(all);
  }

  const Report& body_;
};

}  // namespace

void write_claims(Report& page, const Report& body) {
  Claims claims(body);
  claims.pictures();
  claims.detection();
  claims.noise();
  claims.lines();
  claims.meshes();
  claims.blends();
  claims.determinism();
  claims.guarantees();
  claims.speed();
  if (claims.rows.empty()) return;
  page.heading(2, "What README.md says");
  page.text(
      "Each figure of README.md, read off the rows below it is taken from. A range is over random "
      "and blue samples, or over the shapes that are named.");
  page.table({"what", "`sheets`, or the default", "`gauss-map`", "section"}, claims.rows);
}

}  // namespace spigolo::bench
