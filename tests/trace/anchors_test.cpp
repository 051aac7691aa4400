// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// trace/anchors: a curve through its sure places
#include "spigolo/trace/anchors.h"

#include <gtest/gtest.h>

#include <cmath>

namespace spigolo::test {
namespace {

constexpr double radius = 20;

// Sure places on a quarter of a circle at these arc lengths, along a guide that is cruder.
struct Quarter {
  Guide guide;
  std::vector<Member> members;
  std::vector<CreaseSample> samples;

  explicit Quarter(std::span<const double> arcs) {
    for (int i = 0; i <= 10; ++i) guide.places.push_back(at(i * radius * half_pi / 10));
    measure(guide);
    for (const double s : arcs) {
      const double a = s / radius;
      CreaseSample sample{at(s), {-std::sin(a), std::cos(a), 0}, half_pi, 1, 1, true};
      if (samples.size() % 2 == 1) sample.direction = -sample.direction;
      members.push_back(
          {s * guide.length() / (radius * half_pi), static_cast<std::uint32_t>(samples.size())});
      samples.push_back(sample);
    }
  }
  static Vec3 at(double s) {
    return {radius * std::cos(s / radius), radius * std::sin(s / radius), 0};
  }
  double off(const Anchors& anchors, double s) const {
    const auto place = anchors.at(s);
    return place ? std::abs(norm(*place) - radius) : infinity;
  }
};

constexpr std::array<double, 8> arcs = {4, 5, 6, 7, 16, 17, 18, 19};

TEST(Anchors, bridgeAGapOfNineSpacingsOnACircle) {
  const Quarter q(arcs);
  const Anchors anchors(q.guide, q.members, q.samples);
  for (double s = 4; s < 19; s += 0.5) EXPECT_LT(q.off(anchors, s), 2e-3) << s;
}

TEST(Anchors, goOnBeyondTheLastOneAndSayNothingFarAway) {
  const Quarter q(arcs);
  const Anchors anchors(q.guide, q.members, q.samples);
  EXPECT_LT(q.off(anchors, 1), 0.05);
  EXPECT_LT(q.off(anchors, 22), 0.05);
  EXPECT_FALSE(anchors.at(30));
}

TEST(Anchors, onePlaceOffTheOthersIsLeftOut) {
  Quarter q(arcs);
  q.samples[5].place += Vec3{0.4, 0.3, 0.2};
  const Anchors anchors(q.guide, q.members, q.samples);
  for (double s = 4; s < 19; s += 0.5) EXPECT_LT(q.off(anchors, s), 2e-3) << s;
}

TEST(Anchors, whatIsNotSureHasNoSay) {
  Quarter q(arcs);
  for (CreaseSample& s : q.samples) s.sure = false;
  EXPECT_FALSE(Anchors(q.guide, q.members, q.samples).at(10));
}

}  // namespace
}  // namespace spigolo::test
