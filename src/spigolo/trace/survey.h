// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/survey.h - the cloud itself asked where creases run: along known ones, and beyond
// their ends
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "spigolo/index/kd_tree.h"
#include "spigolo/trace/chain_end.h"
#include "spigolo/trace/crease_samples.h"
#include "spigolo/trace/guide.h"
#include "spigolo/trace/section.h"

namespace spigolo {

/// The points of a cloud in spacings, ready to be looked at.
class Survey {
 public:
  /// samples: give origin and unit.
  Survey(std::span<const Vec3> points, const CreaseSamples& samples, double noise, const Job& job);
  Survey(const Survey&) = delete;
  Survey& operator=(const Survey&) = delete;

  double noise() const { return noise_; }

  /// The points within a radius of a place.
  std::vector<Vec3> points_near(const Vec3& place, double radius) const;

  /// The crease near a place, as fit_section finds it.
  std::optional<SectionFit> look(const SectionQuery& query) const;

 private:
  OrderedCloud cloud_;
  KdTree tree_;
  double noise_;
};

/// Goes on from an end, a spacing a step, as long as the sheets cross there; nothing comes from
/// two steps in a row, or until it comes to a place that is known. The places found, with weight 1.
/// angle: [rad] of the crease at the end.
std::vector<CreaseSample> march(const Survey& survey, const ChainEnd& end, double angle,
                                const std::function<bool(const CreaseSample&)>& known);

/// Looks at the crease about once a spacing along a guide: everywhere, or only where there are no
/// members within a spacing. open: whether the ends of the guide are free.
struct WalkOptions {
  bool everywhere = false;
  std::array<bool, 2> corner = {false, false};  // at the ends: nothing is looked at beyond
};
std::vector<CreaseSample> walk(const Survey& survey, const Guide& guide,
                               std::span<const Member> members,
                               std::span<const CreaseSample> samples, const WalkOptions& options);

}  // namespace spigolo
