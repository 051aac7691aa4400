// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/rival_detectors.h - all that score points for sharpness: ours and the rivals, one cloud at
// a time
#pragma once

#include <array>
#include <string>
#include <vector>

#include "rival.h"
#include "scoreboard.h"
#include "spigolo/measure/classification.h"

namespace spigolo::bench {

/// A rival gives every point a score, in several columns (its scales); a limit on it marks points.
struct Detector {
  const char* name;
  bool (*run)(const RivalPlaces& places, const std::string& in, const fs::path& out,
              double spacing);
  const char* settings;         // scales in one run
  std::size_t skip = 0;         // columns before the scores
  const char* names = nullptr;  // of the scores, if the file's do not tell
};

inline constexpr std::size_t detector_count = 4;
extern const std::array<Detector, detector_count> detectors;

/// One cloud with its truth and what everyone says about it.
struct Set {
  std::vector<std::string> title;
  std::vector<Vec3> points;
  FeatureTruth truth;
  double spacing = 0;                            // mean, that radii are relative to
  std::array<Scores, detector_count> scores{};   // of the detectors
  std::array<double, detector_count> seconds{};  // of CPU
  double sheets_seconds = 0, thesis_seconds = 0;
  std::vector<std::uint8_t> sheets{}, thesis{};
};

using Sets = std::vector<Set>;

/// Runs everyone on set.points. Who does not run has no scores.
void ask_all(const RivalPlaces& places, Set& set);

/// What that has cost; to be called before points are dropped.
void note_costs(const Set& set, Scoreboard& board);

}  // namespace spigolo::bench
