// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/scoreboard.h - who is best how often: what the tables of rivals.md add up to
#pragma once

#include <string>
#include <vector>

#include "report.h"
#include "spigolo/core/geometry.h"

namespace spigolo::bench {

enum class Better : std::uint8_t { higher, lower };

/// One program on one set: with its one setting for all sets, and with its best for this one.
/// NaN: it did not run.
struct Entry {
  std::string program;
  double one = not_a_number, best = not_a_number;
};

/// Entries of one score on several sets, ours (its defaults) first in each.
struct Contest {
  std::string task, score;
  Better better = Better::higher;
  std::vector<std::vector<Entry>> sets = {};
};

/// CPU of one program, as a process of its own or, ours, within this one.
struct RunCost {
  std::string program;
  std::string settings;                        // how many scales or settings one run answers for
  double seconds = 0, points = 0, search = 0;  // sums over its runs; search: plain, 16 neighbors
};

class Scoreboard {
 public:
  void add(Contest contest) { contests_.push_back(std::move(contest)); }
  /// search: seconds that the 16 nearest neighbors of all these points take.
  void add_cost(const std::string& program, const std::string& settings, double seconds,
                std::size_t points, double search);
  /// The tables, in the order of what was added.
  void write(Report& report) const;

 private:
  void write_standings(Report& report) const;
  void write_winners(Report& report) const;
  void write_costs(Report& report) const;

  std::vector<Contest> contests_;
  std::vector<RunCost> costs_;
};

}  // namespace spigolo::bench
