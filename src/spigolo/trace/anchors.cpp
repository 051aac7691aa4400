// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/anchors.cpp
#include "spigolo/trace/anchors.h"

#include <algorithm>
#include <cmath>

#include "spigolo/trace/local_fit.h"

namespace spigolo {
namespace {

constexpr double least_apart = 0.4;    // [spacings] nearer ones are one
constexpr double widest_gap = 14;      // [spacings] that a cubic bridges
constexpr double farthest_beyond = 8;  // [spacings] beyond the last one
constexpr double stray = 0.1;          // [spacings] off the curve of its neighbors
constexpr double strays_gap = 9;       // [spacings] farther neighbors do not tell a stray
constexpr double end_reach = 8;        // [spacings] of anchors that tell how the curve goes on

}  // namespace

Anchors::Anchors(const Guide& guide, std::span<const Member> members,
                 std::span<const CreaseSample> samples)
    : length_(guide.length()), closed_(guide.closed) {
  for (const Member& m : members) {
    const CreaseSample& sample = samples[m.sample];
    if (!sample.sure) continue;
    if (!anchors_.empty() && m.arc - anchors_.back().arc < least_apart) continue;
    const bool backward = dot(sample.direction, guide.direction(m.arc)) < 0;
    anchors_.push_back({m.arc, sample.place, backward ? -sample.direction : sample.direction});
  }
  drop_strays();
}

// The neighbor before (step -1) or after an anchor, round the seam; null at an end.
const Anchors::Anchor* Anchors::around(std::size_t i, std::ptrdiff_t step, Anchor& moved) const {
  const auto n = static_cast<std::ptrdiff_t>(anchors_.size());
  const std::ptrdiff_t k = static_cast<std::ptrdiff_t>(i) + step;
  if (k >= 0 && k < n) return &anchors_[static_cast<std::size_t>(k)];
  if (!closed_) return nullptr;
  moved = anchors_[static_cast<std::size_t>((k + n) % n)];
  moved.arc += k < 0 ? -length_ : length_;
  return &moved;
}

double Anchors::strayed(std::size_t i) const {
  Anchor first, second;
  const Anchor *a = around(i, -1, first), *b = around(i, 1, second);
  if (!a || !b || b->arc - a->arc > strays_gap) return 0;
  const double t = std::clamp((anchors_[i].arc - a->arc) / (b->arc - a->arc), 0.0, 1.0);
  const Vec3 there = cubic_between({a->place, a->direction}, {b->place, b->direction}, t);
  const Vec3 d = anchors_[i].place - there;
  return norm(d - anchors_[i].direction * dot(d, anchors_[i].direction));
}

// One that is off its neighbors' curve makes them look off, too, but less so.
void Anchors::drop_strays() {
  while (anchors_.size() > 4) {
    std::size_t worst = 0;
    double most = 0;
    for (std::size_t i = 0; i < anchors_.size(); ++i) {
      const double off = strayed(i);
      if (off > most) most = off, worst = i;
    }
    if (most <= stray) return;
    anchors_.erase(anchors_.begin() + static_cast<std::ptrdiff_t>(worst));
  }
}

std::optional<Vec3> Anchors::beyond(std::size_t end, double s) const {
  const Anchor& last = anchors_[end];
  const double u = s - last.arc;
  if (std::abs(u) > farthest_beyond) return std::nullopt;
  std::vector<Vec3> near;
  for (const Anchor& anchor : anchors_)
    if (std::abs(anchor.arc - last.arc) <= end_reach) near.push_back(anchor.place);
  if (near.size() < 3) return std::nullopt;
  LocalCurve fit = fit_local_curve(near, last.place, last.direction);
  return last.place + last.direction * u + fit.bend * (u * u / 2);
}

std::optional<Vec3> Anchors::at(double s) const {
  if (anchors_.size() < 2) return std::nullopt;
  const auto next = static_cast<std::size_t>(
      std::upper_bound(anchors_.begin(), anchors_.end(), s,
                       [](double arc, const Anchor& a) { return arc < a.arc; }) -
      anchors_.begin());
  if (!closed_ && next == 0) return beyond(0, s);
  if (!closed_ && next == anchors_.size()) return beyond(next - 1, s);
  Anchor first, second;
  const Anchor *a = around(next, -1, first), *b = around(next, 0, second);
  if (b->arc - a->arc > widest_gap) return std::nullopt;
  const double t = (s - a->arc) / (b->arc - a->arc);
  return cubic_between({a->place, a->direction}, {b->place, b->direction}, t);
}

}  // namespace spigolo
