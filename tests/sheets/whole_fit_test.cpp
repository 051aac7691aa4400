// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/sheets/whole_fit_test.cpp - several points at once give the bits that one at a time gives
#include "spigolo/sheets/whole_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "spigolo/core/random.h"
#include "spigolo/index/prepared_cloud.h"
#include "spigolo/sheets/consensus.h"
#include "spigolo/sheets/heights.h"
#include "spigolo/sheets/verdict.h"
#include "spigolo/synth/synth.h"

namespace spigolo {
namespace {

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool same_bits(const Vec3& a, const Vec3& b) {
  return same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z);
}

bool same_bits(const Sheet& s, const Sheet& t) {
  bool same = same_bits(s.origin, t.origin) && same_bits(s.u, t.u) && same_bits(s.v, t.v) &&
              same_bits(s.n, t.n) && same_bits(s.spacing, t.spacing) &&
              same_bits(s.deviation, t.deviation) && s.support == t.support;
  for (std::size_t c = 0; c < 6; ++c) same = same && same_bits(s.a[c], t.a[c]);
  return same;
}

std::vector<Vec3> shape(const std::string& name, Sampling sampling, double noise = 0) {
  SynthOptions options;
  options.shape = name;
  options.sampling = sampling;
  options.points = sampling == Sampling::lattice ? 0 : 3000;
  options.noise = noise;
  options.seed = 5;
  return make_cloud(options).cloud.points;
}

void expect_same_as_alone(const std::vector<Vec3>& points, std::size_t k) {
  const PreparedCloud p = prepare_cloud(points, k);
  const std::size_t n = p.cloud.size();
  std::vector<Sheet> at_once(n);
  const WholeFits fits{p.cloud.points, p.neighborhoods, p.spacing, std::min(k, n - 1)};
  // Ranges that no number of lanes divides.
  for (std::size_t begin = 0; begin < n; begin += 61)
    fit_whole_sheets(fits, begin, std::min(n, begin + 61), &at_once[begin]);
  std::size_t different = 0;
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<Vec3> around(1, p.cloud.points[i]);
    for (const std::uint32_t j : p.neighborhoods.of(i).first(fits.k))
      around.push_back(p.cloud.points[j]);
    const Sheet alone = fit_sheet(around, {}, p.spacing.of_point[i], SheetOrder::quadric);
    different += !same_bits(alone, at_once[i]);
  }
  EXPECT_EQ(different, 0u) << "of " << n;
}

TEST(WholeFit, SmoothAndSharpShapes) {
  for (const char* name : {"torus", "box", "cylinders", "patch"})
    expect_same_as_alone(shape(name, Sampling::random), 20);
  expect_same_as_alone(shape("hole17k", Sampling::lattice), 20);
}

TEST(WholeFit, NoiseAndManyNeighbors) {
  for (const std::size_t k : {24u, 40u, 64u, 96u})
    expect_same_as_alone(shape("box", Sampling::random, 0.3), k);
}

TEST(WholeFit, FewNeighbors) {
  for (const std::size_t k : {8u, 9u, 10u}) expect_same_as_alone(shape("box", Sampling::blue), k);
}

TEST(WholeFit, HugeAndTinyCoordinates) {
  for (const double scale : {1e-9, 1e12}) {
    std::vector<Vec3> points = shape("cone", Sampling::random);
    for (Vec3& p : points) p = p * scale + Vec3{3 * scale, -7 * scale, 1e3 * scale};
    expect_same_as_alone(points, 20);
  }
}

TEST(WholeFit, RowsOfPointsThatLieOnLines) {
  std::vector<Vec3> points;
  for (int line = 0; line < 20; ++line)
    for (int i = 0; i < 60; ++i) points.push_back({i * 0.01, line * 1.0, 0});
  expect_same_as_alone(points, 20);  // no quadric, no axis: the lanes that are done alone
}

TEST(WholeFit, PointsThatFillACube) {
  std::vector<Vec3> points;
  for (int i = 0; i < 1000; ++i)
    points.push_back({double(i % 10), double(i / 10 % 10), double(i / 100)});
  expect_same_as_alone(points, 26);  // scatter without a smallest axis
}

TEST(Heights, SameAsOneByOne) {
  const std::vector<Vec3> points = shape("cylinders", Sampling::random, 0.1);
  const std::span<const Vec3> all = points;
  for (std::size_t n = 1; n < 40; ++n) {
    const auto around = all.subspan(17 * n, n + 12);
    const Sheet sheet = fit_sheet(around, {}, 0.05, SheetOrder::quadric);
    std::vector<double> at_once(around.size());
    heights(sheet, around, at_once.data());
    for (std::size_t t = 0; t < around.size(); ++t)
      ASSERT_TRUE(same_bits(at_once[t], height(sheet, around[t]))) << n << " " << t;
  }
}

TEST(Explained, SameAsOneByOne) {
  const std::vector<Vec3> points = shape("cylinders", Sampling::random, 0.1);
  const std::span<const Vec3> all = points;
  const SheetTrust trust = {0.3, 0.02, 2.5, 0.05};
  for (std::size_t n = 1; n < 40; ++n) {
    const auto around = all.subspan(17 * n, n + 12);
    const Sheet sheet = fit_sheet(around, {}, 0.05, SheetOrder::quadric);
    std::vector<double> at_once(around.size());
    explained(sheet, around, trust, at_once.data());
    for (std::size_t t = 0; t < around.size(); ++t) {
      const double beyond =
          std::max(0.0, distance(around[t], sheet.origin) / trust.spacing - trust.known);
      const double off = height(sheet, around[t]) / (trust.limit + trust.growth * beyond * beyond);
      ASSERT_TRUE(same_bits(at_once[t], std::max(0.0, 1 - off * off))) << n << " " << t;
    }
  }
}

// The plane of all pairs, one after the other.
Vec3 plane_one_by_one(std::span<const Vec3> points, double tolerance) {
  const std::size_t step = std::max<std::size_t>(1, (points.size() - 1) / 20);
  Vec3 best_normal;
  double best = -1;
  for (std::size_t i = 1; i < points.size(); i += step) {
    const Vec3 a = points[i] - points[0];
    for (std::size_t j = i + step; j < points.size(); j += step) {
      const Vec3 b = points[j] - points[0], n = cross(a, b);
      const double area = norm(n);
      if (area * area < 0.25 * 0.25 * squared_norm(a) * squared_norm(b)) continue;
      double agreement = 0;
      for (const Vec3& p : points) {
        const double off = dot(n / (area * tolerance), p - points[0]);
        agreement += std::max(0.0, 1 - off * off);
      }
      if (agreement > best) best = agreement, best_normal = n / area;
    }
  }
  return best_normal;
}

TEST(Consensus, SameAsOneByOne) {
  for (const double noise : {0.0, 0.3}) {
    const PreparedCloud p = prepare_cloud(shape("box", Sampling::random, noise), 96);
    for (const std::size_t k : {8u, 20u, 41u, 96u}) {
      for (std::size_t i = 0; i < p.cloud.size(); i += 7) {
        std::vector<Vec3> around(1, p.cloud.points[i]);
        for (const std::uint32_t j : p.neighborhoods.of(i).first(k))
          around.push_back(p.cloud.points[j]);
        const double tolerance = 0.2 * p.spacing.of_point[i];
        ASSERT_TRUE(
            same_bits(consensus_plane(around, tolerance), plane_one_by_one(around, tolerance)))
            << k << " " << i;
      }
    }
  }
}

TEST(Consensus, NoPlaneThroughNeedles) {
  std::vector<Vec3> line;
  for (int i = 0; i < 21; ++i) line.push_back({i * 1.0, 1e-3 * (i % 2), 0});
  EXPECT_EQ(consensus_plane(line, 0.1), Vec3{});
}

// judge_points spares most points the search for further sheets; no verdict may hang on that.
TEST(JudgePoints, SameAsJudgedOneByOne) {
  for (const char* name : {"box", "torus", "patch", "fillet-box", "dome"}) {
    const PreparedCloud p = prepare_cloud(shape(name, Sampling::random), 20);
    const std::span<const Vec3> points = p.cloud.points;
    const SheetTolerances tolerances = sheet_tolerances(0);
    const std::vector<Sheet> sheets =
        find_own_sheets(points, p.neighborhoods, p.spacing, tolerances);
    const auto together = judge_points(points, p.neighborhoods, sheets, tolerances, {});
    std::vector<SheetVerdict> alone(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      std::vector<std::uint32_t> members(1, i);
      for (const std::uint32_t j : p.neighborhoods.of(i).first(tolerances.asked))
        members.push_back(j);
      alone[i] = judge_point(points, sheets, members, tolerances, {});
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_EQ(alone[i].kind, together[i].kind) << name << " " << i;
      EXPECT_TRUE(same_bits(alone[i].crease_point, together[i].crease_point)) << name << " " << i;
    }
  }
}

}  // namespace
}  // namespace spigolo
