// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/rivals_detect.cpp - detection by others: one setting for all sets, and their best for each
#include "common.h"
#include "labelled.h"
#include "rival_detectors.h"
#include "sections.h"
#include "truth.h"

namespace spigolo::bench {
namespace {

constexpr double without_border = 4;  // [h] from the border of an open surface nothing is scored

/// Takes the points near the border of an open surface out of the score: not every rival knows
/// borders, and this table is not about them.
void drop_borders(Set& set, const SynthCloud& s) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < s.exact.size(); ++i)
    if (border_distance(s.shape, s.exact[i]) > without_border * s.spacing) kept.push_back(i);
  const auto keep = [&](auto& values) {
    if (values.empty()) return;
    for (std::size_t i = 0; i < kept.size(); ++i) values[i] = values[kept[i]];
    values.resize(kept.size());
  };
  keep(set.points), keep(set.truth.feature), keep(set.truth.edge_distance);
  keep(set.sheets), keep(set.thesis);
  for (Scores& scores : set.scores)
    for (auto& column : scores.columns) keep(column);
}

/// Limits in equal steps of the logarithm; all scores are shares of a sum of eigenvalues.
std::vector<double> limits() {
  std::vector<double> list;
  for (double limit = 5e-4; limit < 0.4; limit *= 1.12) list.push_back(limit);
  return list;
}

double f1_of(const Set& set, std::size_t rival, std::size_t column, double limit, Scoring scoring) {
  std::vector<std::uint8_t> flags;
  flags.reserve(set.points.size());
  for (const double s : set.scores[rival].columns[column]) flags.push_back(s >= limit);
  return classify(flags, set.truth, scoring).f1;
}

struct Setting {
  std::string column;
  std::size_t index = 0;
  double limit = 0, mean = 0;
};

/// F1 of every column and limit on every set, for one rival and one way of scoring.
class Sweep {
 public:
  Sweep(const Sets& sets, std::size_t rival, Scoring scoring) : limits_(limits()) {
    for (const Set& set : sets) {
      const std::size_t columns = set.scores[rival].columns.size();
      if (columns > 0) names_ = set.scores[rival].names;
      f1_.emplace_back(columns * limits_.size());
      for (std::size_t c = 0; c < columns; ++c)
        for (std::size_t l = 0; l < limits_.size(); ++l)
          f1_.back()[c * limits_.size() + l] = f1_of(set, rival, c, limits_[l], scoring);
    }
  }
  bool answered() const {
    return !f1_.empty() && std::all_of(f1_.begin(), f1_.end(), [this](const auto& row) {
      return !row.empty() && row.size() == f1_[0].size();
    });
  }
  double of(std::size_t set, const Setting& setting) const { return f1_[set][setting.index]; }
  double best(std::size_t set) const { return *std::max_element(f1_[set].begin(), f1_[set].end()); }
  /// The setting with the highest mean over all sets.
  Setting best_for_all() const {
    Setting best;
    for (std::size_t i = 0; i < f1_[0].size(); ++i) {
      double mean = 0;
      for (const auto& row : f1_) mean += row[i] / static_cast<double>(f1_.size());
      if (mean > best.mean)
        best = {names_[i / limits_.size()], i, limits_[i % limits_.size()], mean};
    }
    return best;
  }

 private:
  std::vector<double> limits_;
  std::vector<std::string> names_;
  std::vector<std::vector<double>> f1_;  // of a set, by column and limit
};

struct Judged {
  std::vector<Setting> setting;
  std::vector<bool> answered;
};

const char* name_of(Scoring scoring) {
  return scoring == Scoring::thin ? "thin F1" : "tolerant F1";
}

/// values: of one set, as in a row of the table.
std::vector<Entry> entries_of(const std::vector<double>& values) {
  std::vector<Entry> entries = {{"`sheets`", values[0], values[0]},
                                {"`gauss-map`", values[1], values[1]}};
  for (std::size_t r = 0; r < detectors.size(); ++r)
    entries.push_back({detectors[r].name, values[2 + 2 * r], values[3 + 2 * r]});
  return entries;
}

/// One table: ours, then of each rival the one setting and its best for each set. Returns it as a
/// contest without the name of its task.
Contest add_table(Report& report, const Sets& sets, std::vector<std::string> head, Scoring scoring,
                  const Judged& judged) {
  std::vector<Sweep> sweeps;
  for (std::size_t r = 0; r < detectors.size(); ++r) sweeps.emplace_back(sets, r, scoring);
  const std::size_t titles = head.size();
  head.insert(head.end(), {"`sheets`", "`gauss-map`"});
  for (const Detector& d : detectors)
    head.insert(head.end(), {std::string(d.name) + ": one setting", "best"});
  std::vector<std::vector<std::string>> rows;
  std::vector<double> sums(head.size() - titles, 0);
  Contest contest{"", name_of(scoring)};
  for (std::size_t s = 0; s < sets.size(); ++s) {
    std::vector<double> values = {classify(sets[s].sheets, sets[s].truth, scoring).f1,
                                  classify(sets[s].thesis, sets[s].truth, scoring).f1};
    for (std::size_t r = 0; r < detectors.size(); ++r) {
      const bool there = judged.answered[r] && sweeps[r].answered();
      values.push_back(there ? sweeps[r].of(s, judged.setting[r]) : not_a_number);
      values.push_back(there ? sweeps[r].best(s) : not_a_number);
    }
    std::vector<std::string> row = sets[s].title;
    for (std::size_t v = 0; v < values.size(); ++v) {
      row.push_back(std::isnan(values[v]) ? "-" : number(values[v], 3));
      sums[v] += values[v] / static_cast<double>(sets.size());
    }
    rows.push_back(row);
    contest.sets.push_back(entries_of(values));
  }
  std::vector<std::string> mean(titles);
  mean[0] = "mean";
  for (const double sum : sums) mean.push_back(std::isnan(sum) ? "-" : number(sum, 3));
  rows.push_back(mean);
  report.table(head, rows);
  return contest;
}

void enter(Scoreboard& board, const std::string& task, Contest contest) {
  contest.task = task;
  board.add(std::move(contest));
}

/// The one setting of each rival: the best mean over these sets, by their truth.
Judged judge(const Sets& sets, Scoring scoring) {
  Judged judged;
  for (std::size_t r = 0; r < detectors.size(); ++r) {
    const Sweep sweep(sets, r, scoring);
    judged.answered.push_back(sweep.answered());
    judged.setting.push_back(sweep.answered() ? sweep.best_for_all() : Setting{});
  }
  return judged;
}

void name_settings(Report& report, const Judged& judged) {
  std::string text = "The one settings: ";
  for (std::size_t r = 0; r < detectors.size(); ++r) {
    text += std::string(r > 0 ? "; " : "") + detectors[r].name + " ";
    text += judged.answered[r]
                ? judged.setting[r].column + ", limit " + number(judged.setting[r].limit, 4)
                : std::string("did not run");
  }
  report.text(text + ".");
}

Sets constructed(const RivalPlaces& places, Scoreboard& board) {
  Sets sets;
  struct Wanted {
    const char* shape;
    double angle;
  };
  for (const Wanted& w :
       {Wanted{"box", 0}, Wanted{"boxhole", 0}, Wanted{"wedge", 60}, Wanted{"wedge", 90},
        Wanted{"wedge", 120}, Wanted{"wedge", 150}, Wanted{"l-prism", 0}})
    for (const Sampling sampling : {Sampling::random, Sampling::blue})
      for (const double noise : {0.0, 0.25, 0.5}) {
        SynthOptions options{.shape = w.shape, .sampling = sampling, .points = 5000};
        options.noise = noise, options.seed = 51;
        options.angle = radians(w.angle > 0 ? w.angle : 90);
        const SynthCloud s = make_cloud(options);
        std::string name = w.shape;
        if (w.angle > 0) name.append(" ").append(number(w.angle));
        sets.push_back({{name, sampling == Sampling::blue ? "blue" : "random", number(noise, 2)},
                        s.cloud.points,
                        read_truth(s.cloud, s.spacing, s.lattice),
                        mean_spacing(s)});
        ask_all(places, sets.back());
        note_costs(sets.back(), board);
        drop_borders(sets.back(), s);
      }
  return sets;
}

/// The thesis's comparison with PCA, where it marks wide bands.
void figure_34(Report& report, const RivalPlaces& places, const Judged& judged, Scoreboard& board) {
  Sets sets;
  for (const double percent : {0.0, 1.2}) {
    SynthOptions options;
    options.shape = "hole17k", options.noise_percent = percent;
    const SynthCloud s = make_cloud(options);
    sets.push_back({{"hole17k", number(percent, 1)},
                    s.cloud.points,
                    read_truth(s.cloud, s.spacing, s.lattice),
                    mean_spacing(s)});
    ask_all(places, sets.back());
  }
  report.heading(3, "Figure 34: the thesis's cube with a hole, thin F1");
  report.text("Samples on the edges, noise in percent as in Table 2; the settings from above.");
  enter(board, "Figure 34", add_table(report, sets, {"set", "noise %"}, Scoring::thin, judged));
}

void labelled(Report& report, const RivalPlaces& places, const fs::path& folder,
              const Judged& judged, Scoreboard& board) {
  Sets sets;
  for (LabelledCloud& cloud : read_labelled(folder)) {
    const double spacing = detect(cloud.points).spacing;
    sets.push_back({{cloud.name, std::to_string(cloud.points.size())},
                    std::move(cloud.points),
                    std::move(cloud.truth),
                    spacing});
    ask_all(places, sets.back());
  }
  report.heading(3, "Labelled ABC clouds, " + folder.filename().string() + ": thin F1");
  report.text("With the one settings of the constructed shapes (as ours are its defaults):");
  const std::string task = "Detection, ABC " + folder.filename().string();
  enter(board, task + ", settings of the constructed sets",
        add_table(report, sets, {"cloud", "points"}, Scoring::thin, judged));
  const Judged own = judge(sets, Scoring::thin);
  report.text("With the one setting that is best for these very clouds, by their labels:");
  enter(board, task + ", settings by their labels",
        add_table(report, sets, {"cloud", "points"}, Scoring::thin, own));
  name_settings(report, own);
}

}  // namespace

void rivals_detect(Report& report, const RivalPlaces& places, const fs::path& data,
                   Scoreboard& board) {
  report.heading(2, "Detection");
  report.text(
      "A rival gives every point a score; points over a limit are marked. Scales are in spacings "
      "or neighbors, scores are shares, so a setting means the same on every cloud. One setting: "
      "the pair of scale and limit with the highest mean tolerant F1 over all sets of the first "
      "table, chosen with their truth, which no user has. Best: the best pair for each set and "
      "score, chosen the same way. Ours: the defaults, nothing chosen. Points within 4 h of the "
      "border of the "
      "open wedges do not count for anyone. 5000 points, seed 51. "
      "Scales tried: VCM 3 offset radii by 5 convolution radii, PCA 4 sizes of neighborhood and "
      "3 counts over 7 sizes, PCL 6 sizes, CloudCompare 4 radii; 57 limits each.");
  const Sets sets = constructed(places, board);
  const Judged judged = judge(sets, Scoring::tolerant);
  name_settings(report, judged);
  report.text("Tolerant F1:");
  enter(board, "Detection, constructed sets",
        add_table(report, sets, {"shape", "samples", "noise"}, Scoring::tolerant, judged));
  report.text("Thin F1, the same settings:");
  enter(board, "Detection, constructed sets",
        add_table(report, sets, {"shape", "samples", "noise"}, Scoring::thin, judged));
  figure_34(report, places, judged, board);
  if (data.empty()) return;
  for (const char* folder : {"clean", "noisy"})
    labelled(report, places, data / "abc" / folder, judged, board);
}

}  // namespace spigolo::bench
