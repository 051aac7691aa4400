// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/anchors.h - a curve through the places of it that are sure
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "spigolo/trace/guide.h"

namespace spigolo {

/// The sure members of a guide, in order, without those that the others speak against. Between two
/// of them the curve is the cubic that has their places and directions; beyond the last one the
/// arc that it and its neighbors make. Lengths in spacings.
class Anchors {
 public:
  Anchors(const Guide& guide, std::span<const Member> members,
          std::span<const CreaseSample> samples);

  /// The place of the curve about s along the guide; nothing where the anchors are too far away.
  std::optional<Vec3> at(double s) const;

 private:
  struct Anchor {
    double arc = 0;
    Vec3 place, direction;  // the way of the guide
  };
  const Anchor* around(std::size_t i, std::ptrdiff_t step, Anchor& moved) const;
  double strayed(std::size_t i) const;
  void drop_strays();
  std::optional<Vec3> beyond(std::size_t end, double s) const;

  double length_ = 0;
  bool closed_ = false;
  std::vector<Anchor> anchors_;
};

}  // namespace spigolo
