// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/scoreboard.cpp
#include "scoreboard.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace spigolo::bench {
namespace {

using Row = std::vector<std::string>;
constexpr int digits = 3;  // what is shown decides: two figures that print alike are level

double shown(double value) { return std::round(value * std::pow(10, digits)); }

// Positive if a is better than b. What did not run is worse than what did.
int compare(double a, double b, Better better) {
  if (std::isnan(a) || std::isnan(b)) return int(std::isnan(b)) - int(std::isnan(a));
  const double difference = shown(a) - shown(b);
  const int sign = difference > 0 ? 1 : difference < 0 ? -1 : 0;
  return better == Better::higher ? sign : -sign;
}

struct Standing {
  int ahead = 0, level = 0, behind = 0;
};

// Ours against the best of the rivals, set by set. value: Entry::one or Entry::best.
Standing standing_of(const Contest& contest, double Entry::*value) {
  Standing standing;
  for (const auto& entries : contest.sets) {
    double rival = not_a_number;
    for (std::size_t e = 1; e < entries.size(); ++e)
      if (!entries[e].program.starts_with('`') &&
          compare(entries[e].*value, rival, contest.better) > 0)
        rival = entries[e].*value;
    const int sign = compare(entries[0].one, rival, contest.better);
    ++(sign > 0 ? standing.ahead : sign < 0 ? standing.behind : standing.level);
  }
  return standing;
}

std::string text_of(const Standing& s) {
  return std::to_string(s.ahead) + " / " + std::to_string(s.level) + " / " +
         std::to_string(s.behind);
}

// Mean over the sets; NaN if it did not run on one of them.
double mean_of(const Contest& contest, std::size_t entry, double Entry::*value) {
  double sum = 0;
  for (const auto& entries : contest.sets)
    sum += entries[entry].*value / static_cast<double>(contest.sets.size());
  return sum;
}

std::string text_of(double mean) { return std::isnan(mean) ? "not on all" : number(mean, digits); }

// The rival with the best mean: "0.841 (CGAL VCM)".
std::string best_rival(const Contest& contest, double Entry::*value) {
  double best = not_a_number;
  std::string name;
  for (std::size_t e = 1; e < contest.sets[0].size(); ++e) {
    const std::string& program = contest.sets[0][e].program;
    const double mean = mean_of(contest, e, value);
    if (program.starts_with('`') || compare(mean, best, contest.better) <= 0) continue;
    best = mean, name = program;
  }
  return name.empty() ? "none ran" : number(best, digits) + " (" + name + ")";
}

// In how many sets each is best or level with the best: "`sheets` 30, CGAL VCM 12".
std::string winners(const Contest& contest, double Entry::*value) {
  std::map<std::string, int> wins;
  Row order;
  for (const auto& entries : contest.sets) {
    double best = not_a_number;
    const auto value_of = [&](std::size_t e) {
      return e == 0 ? entries[e].one : entries[e].*value;
    };
    for (std::size_t e = 0; e < entries.size(); ++e)
      if (compare(value_of(e), best, contest.better) > 0) best = value_of(e);
    for (std::size_t e = 0; e < entries.size(); ++e) {
      if (!wins.contains(entries[e].program)) order.push_back(entries[e].program);
      wins[entries[e].program] +=
          !std::isnan(best) && compare(value_of(e), best, contest.better) == 0;
    }
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](const auto& a, const auto& b) { return wins[a] > wins[b]; });
  std::string text;
  for (const std::string& program : order)
    if (wins[program] > 0)
      text += (text.empty() ? "" : ", ") + program + " " + std::to_string(wins[program]);
  return text.empty() ? "none ran" : text;
}

}  // namespace

void Scoreboard::add_cost(const std::string& program, const std::string& settings, double seconds,
                          std::size_t points, double search) {
  auto found = std::find_if(costs_.begin(), costs_.end(),
                            [&](const RunCost& c) { return c.program == program; });
  if (found == costs_.end()) found = costs_.insert(found, RunCost{program, settings});
  found->seconds += seconds, found->points += static_cast<double>(points), found->search += search;
}

void Scoreboard::write_standings(Report& report) const {
  report.text(
      "Ours (its defaults, nothing chosen) against the best of the rivals on each set: ahead / "
      "level / behind, level where three digits are the same. A rival's settings are chosen with "
      "the truth that scores them: one setting for all sets, or even the best for each set. Means "
      "over all sets; beside ours that of the rival with the best one.");
  std::vector<Row> rows;
  for (const Contest& c : contests_)
    rows.push_back({c.task, c.score + (c.better == Better::lower ? " (less is better)" : ""),
                    std::to_string(c.sets.size()), text_of(standing_of(c, &Entry::one)),
                    text_of(standing_of(c, &Entry::best)), text_of(mean_of(c, 0, &Entry::one)),
                    best_rival(c, &Entry::one), best_rival(c, &Entry::best)});
  report.table({"task", "score", "sets", "ours, one setting each", "ours, their best for each set",
                "mean: ours", "best rival, one setting", "best rival, best for each set"},
               rows);
}

void Scoreboard::write_winners(Report& report) const {
  report.text("In how many sets each program is the best or level with it; in `code`, spigolo's:");
  std::vector<Row> rows;
  for (const Contest& c : contests_)
    rows.push_back({c.task, c.score, std::to_string(c.sets.size()), winners(c, &Entry::one),
                    winners(c, &Entry::best)});
  report.table({"task", "score", "sets", "one setting each", "rivals with their best for each set"},
               rows);
}

void Scoreboard::write_costs(Report& report) const {
  if (costs_.empty()) return;
  report.text(
      "CPU time, all clouds of this page together, reading and writing of files included where "
      "the program is a process of its own. Search: 16 nearest neighbors of the same points.");
  std::vector<Row> rows;
  for (const RunCost& c : costs_)
    rows.push_back({c.program, c.settings, number(1e6 * c.seconds / c.points, 1),
                    number(c.seconds / c.search, 1)});
  report.table({"program", "settings in one run", "CPU [us a point]", "of a search"}, rows);
}

void Scoreboard::write(Report& report) const {
  if (contests_.empty()) return;
  report.heading(2, "Summary: who is best how often");
  write_standings(report);
  write_winners(report);
  write_costs(report);
}

}  // namespace spigolo::bench
