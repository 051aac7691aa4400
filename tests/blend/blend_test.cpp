// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// Whole blends: smooth borders, exact removal, the same for any order, and what cannot be done
#include "spigolo/blend/blend.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>

#include "blend/scenes.h"
#include "spigolo/cad/cad_file.h"
#include "spigolo/core/error.h"

namespace spigolo::test {
namespace {

// The kernel smooths the jump of curvature at a border over about one spacing.
constexpr double degrees_per_setback = 25;

void expect_smooth(const BorderReport& b) {
  const double setback = std::min(b.height_min, b.width_min);
  const double mean = degrees_per_setback / setback;
  EXPECT_LE(degrees(b.quality.face_error.mean), mean);
  EXPECT_LE(degrees(b.quality.cloud_error.mean), mean);
  EXPECT_LE(degrees(b.quality.face_error.max), 1.5 * mean);
  EXPECT_LE(degrees(b.quality.cloud_error.max), 1.5 * mean);
  EXPECT_LE(b.quality.ripple, 0.01);
  EXPECT_LE(b.quality.gap, 1.15);
  EXPECT_LE(b.quality.nearest_cv, 0.1);
  EXPECT_GE(b.quality.nearest_min, 0.7);
}

// A sample so close to the collar's border [spacings] may go or stay: the border is made of chords.
constexpr double on_border = 0.05;

// Removed are exactly the samples that lie inside the collar's border: `inside` [units].
void expect_removed(const std::vector<Vec3>& cloud, const Blend& blend,
                    const std::function<double(const Vec3&)>& inside) {
  std::vector<char> kept(cloud.size(), 0);
  for (const std::uint32_t i : blend.cloud_index) kept[i] = 1;
  std::size_t missed = 0, wrong = 0;
  const double slack = on_border * blend.spacing;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    missed += kept[i] && inside(cloud[i]) > slack;
    wrong += !kept[i] && inside(cloud[i]) < -slack;
  }
  EXPECT_EQ(missed, 0u);
  EXPECT_EQ(wrong, 0u);
}

TEST(Blend, tubeOnACubeMeetsTheBars) {
  const std::vector<Vec3> cloud = cube();
  const Blend b = blend(cloud, top_tube(), from({"v1"}));
  ASSERT_EQ(b.borders.size(), 1u);
  EXPECT_TRUE(b.borders[0].closed);
  EXPECT_NEAR(degrees(b.borders[0].angle_min), 90, 0.01);
  expect_smooth(b.borders[0]);
  const double d = b.spacing;
  expect_removed(cloud, b, [&](const Vec3& p) {
    return p.z > 40.5 ? 8 + 4 * d - std::hypot(p.x - 20.5, p.y - 20.5) : -infinity;
  });
  // The rest stays to the last bit, and the face is not left.
  for (std::size_t i = 0; i < b.cloud_index.size(); ++i)
    ASSERT_EQ(b.points[i], cloud[b.cloud_index[i]]);
  for (const Vec3& p : points_of(b, BlendSource::nurbs)) {
    EXPECT_NEAR(std::hypot(p.x - 20.5, p.y - 20.5), 8, 1e-9);
    EXPECT_GE(p.z, 41 + 4 * d - 1e-3);
    EXPECT_LE(p.z, 61 + 1e-9);
  }
}

TEST(Blend, normalsPointOutward) {
  const Blend b = blend(cube(), top_tube(), from({"v1"}));
  for (std::size_t i = 0; i < b.points.size(); ++i) {
    EXPECT_NEAR(norm(b.normals[i]), 1, 1e-9);
    const Vec3 out = b.source[i] == BlendSource::cloud
                         ? b.points[i] - Vec3{20.5, 20.5, 20.5}
                         : Vec3{b.points[i].x - 20.5, b.points[i].y - 20.5, 1};
    EXPECT_GT(dot(b.normals[i], out), 0) << i;
  }
}

TEST(Blend, sameForAnyOrderAndAnyThreads) {
  const std::vector<Vec3> cloud = cube(Sampling::random, 0.2, 5);
  const NurbsFace tube = top_tube();
  Job one, four;
  one.threads = 1, four.threads = 4;
  const Blend a = blend(cloud, tube, from({"v1"}), one);
  const Blend b = blend(cloud, tube, from({"v1"}), four);
  const Blend c = blend(shuffled(cloud, 3), tube, from({"v1"}), one);
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.normals, b.normals);
  for (const BlendSource source : {BlendSource::nurbs, BlendSource::collar})
    EXPECT_EQ(points_of(a, source), points_of(c, source));
  EXPECT_EQ(a.removed, c.removed);
}

TEST(Blend, movingTurningAndScalingChangeNoVerdict) {
  const std::vector<Vec3> cloud = cube();
  const auto place = [](const Vec3& p) {
    return Vec3{1000 + 0.25 * p.y, -500 - 0.25 * p.x, 0.25 * p.z};
  };
  std::vector<Vec3> moved(cloud.size());
  std::transform(cloud.begin(), cloud.end(), moved.begin(), place);
  NurbsFace tube = top_tube();
  const Blend a = blend(cloud, tube, from({"v1"}));
  for (Vec3& pole : tube.surface.poles) pole = place(pole);
  const Blend b = blend(moved, tube, from({"v1"}));
  EXPECT_EQ(a.cloud_index, b.cloud_index);
  EXPECT_NEAR(static_cast<double>(a.points.size()), static_cast<double>(b.points.size()), 5);
  EXPECT_NEAR(a.borders[0].quality.ripple, b.borders[0].quality.ripple, 2e-3);
}

TEST(Blend, obliqueTubesGetMoreRoom) {
  for (const double angle : {45.0, 30.0}) {
    const Vec3 axis{std::cos(radians(angle)), 0, std::sin(radians(angle))};
    const Vec3 foot{20.5, 20.5, 41};
    const Blend b =
        blend(cube(), face_of(nurbs_tube({foot - axis * 9.0, axis}, 4, 36)), from({"v1"}, 2));
    const BorderReport& r = b.borders[0];
    EXPECT_NEAR(degrees(r.angle_min), angle, 1);
    EXPECT_NEAR(degrees(r.angle_max), 180 - angle, 1);
    EXPECT_GT(r.height_max, 3.5);
    EXPECT_LE(degrees(r.quality.face_error.max), 16);
    EXPECT_LE(degrees(r.quality.cloud_error.max), 16);
    EXPECT_LE(r.quality.gap, 1.15);
  }
}

// Under them the ball's way bends sharply; and where an edge of the cloud runs into the collar.
TEST(Blend, acuteTubesAndEdgesAreSmoothToo) {
  const double lean = radians(18);
  const Vec3 axis{std::cos(lean), 0, std::sin(lean)}, foot{60.3, 40.3, 0};
  const Blend acute = blend(plane(121, 81), face_of(nurbs_tube({foot - axis * 60.0, axis}, 5, 170)),
                            from({"v1"}, 3));
  EXPECT_NEAR(degrees(acute.borders[0].angle_min), 18, 0.5);
  const Vec3 across = normalized(Vec3{1, 0, 1}), edge{41, 20.5, 41};
  const Blend over =
      blend(cube(), face_of(nurbs_tube({edge - across * 16.0, across}, 7, 37)), from({"v1"}, 3));
  for (const Blend* b : {&acute, &over}) {
    const CollarQuality& q = b->borders[0].quality;
    EXPECT_LE(q.ripple, 0.01);
    EXPECT_LE(q.gap, 1.15);
    EXPECT_LE(degrees(q.face_error.max), 16);
    EXPECT_LE(degrees(q.cloud_error.max), 16);
    EXPECT_LE(degrees(q.turn.max), 30);
  }
}

TEST(Blend, usualRadiusGivesWayWhereTheCloudIsSmall) {
  const double lean = radians(25);
  const Vec3 axis{std::cos(lean), 0, std::sin(lean)}, foot{20.3, 20.3, 0};
  const NurbsFace tube = face_of(nurbs_tube({foot - axis * 30.0, axis}, 4, 90));
  const Blend b = blend(plane(38, 41), tube, from({"v1"}, 0));
  EXPECT_LT(b.radius, 3);
  EXPECT_GT(b.radius, 0.9);
  ASSERT_EQ(b.warnings.size(), 1u);
  EXPECT_NE(b.warnings[0].find("no room"), std::string::npos);
  EXPECT_LE(b.borders[0].quality.gap, 1.15);
  EXPECT_THROW(blend(plane(38, 41), tube, from({"v1"}, 3)), NoResultError);
}

TEST(Blend, handleHasTwoCollars) {
  const NurbsFace handle = face_of(nurbs_u_tube({{10.5, 20.5, 36}, ez}, ex, 4, 14, 20));
  const Blend b = blend(cube(), handle, from({"v=0.5+", "v=0.5-"}, 3));
  ASSERT_EQ(b.borders.size(), 2u);
  for (const BorderReport& border : b.borders) {
    EXPECT_TRUE(border.closed);
    EXPECT_LE(border.quality.ripple, 0.01);
    EXPECT_LE(border.quality.gap, 1.15);
  }
  EXPECT_EQ(b.collars.size(), 2u);
}

TEST(Blend, loopsThatAreNotConvex) {
  std::vector<Vec3> profile;
  for (int i = 0; i < 40; ++i) {
    const double t = 2 * pi * i / 40, r = 41 * (0.16 + 0.07 * std::cos(2 * t) + 0.03 * std::cos(t));
    profile.push_back({20.5 + r * std::cos(t), 20.5 + r * std::sin(t), 36});
  }
  const Blend b = blend(cube(), face_of(nurbs_extrusion(profile, {0, 0, 20})), from({"v1"}, 3));
  EXPECT_LE(b.borders[0].quality.ripple, 0.01);
  EXPECT_LE(b.borders[0].quality.gap, 1.15);
  for (std::size_t i = 0; i < b.cloud_index.size(); ++i)
    EXPECT_FALSE(b.points[i].z > 40 && std::hypot(b.points[i].x - 20.5, b.points[i].y - 20.5) < 3);
}

TEST(Blend, thinSlabKeepsItsOtherWall) {
  for (const double thickness : {4.1, 2.1}) {
    std::vector<Vec3> cloud = plane(41);
    for (const Vec3& p : plane(41)) cloud.push_back(p - ez * thickness);
    const NurbsFace tube = face_of(nurbs_tube({{20.25, 20.25, -1}, ez}, 8, 20));
    const Blend b = blend(cloud, tube, from({"v1"}));
    expect_removed(cloud, b, [&](const Vec3& p) {
      return p.z == 0 ? 8 + 4 * b.spacing - std::hypot(p.x - 20.25, p.y - 20.25) : -infinity;
    });
  }
}

NurbsFace sheet_across() {
  return face_of(nurbs_sheet(40, 20, 6, [](double x, double y) {
    return Vec3{20 + 2 * std::sin(x / 9), x, y - 8};
  }));
}

TEST(Blend, sheetAcrossAPlaneNeedsToKnowWhatStays) {
  for (const int side : {1, -1}) {
    BlendOptions options = from({"v1"});
    options.keep = Vec3{double(side), 0, 0};
    const Blend b = blend(plane(41), sheet_across(), options);
    EXPECT_FALSE(b.borders[0].closed);
    EXPECT_NEAR(static_cast<double>(b.removed), 41 * 24, 120);
    for (std::size_t i = 0; i < b.cloud_index.size(); ++i)
      EXPECT_GT(side * (b.points[i].x - 20), 0);
  }
}

// The shaft of a screw that comes with OpenCASCADE in Debian, through a plate across it.
TEST(Blend, analyticFaceOfARealPart) {
  const std::filesystem::path file = "/usr/share/opencascade/data/step/screw.step";
  if (!std::filesystem::exists(file)) return;
  const CadFile part(file);
  ASSERT_EQ(part.faces()[7].type, "cylinder");
  const NurbsFace shaft = part.face(7);
  const auto at = [&](double u, double v) {
    return point_at(shaft.surface, shaft.u.at(u), shaft.v.at(v));
  };
  const Vec3 axis = normalized(at(0, 1) - at(0, 0)), side = any_perpendicular(axis);
  const Vec3 middle = (at(0, 0.4) + at(0.5, 0.4)) / 2;
  std::vector<Vec3> plate;
  for (const Vec3& p : plane(61))
    plate.push_back(middle + (side * (p.x - 30) + cross(axis, side) * (p.y - 30)) * 0.5);
  const double radius = distance(at(0, 0.4), middle);
  const Blend b = blend(plate, shaft, from({"v1"}, 4));
  expect_smooth(b.borders[0]);
  expect_removed(plate, b,
                 [&](const Vec3& p) { return radius + 4 * b.spacing - distance(p, middle); });
}

TEST(Blend, startIsFoundWhereOnlyOneFits) {
  const Blend b = blend(cube(), top_tube());
  ASSERT_EQ(b.borders.size(), 1u);
  EXPECT_EQ(b.borders[0].start, "v1");
}

TEST(Blend, noiseDoesNotReachTheCollar) {
  const Blend b = blend(cube(Sampling::lattice, 1.0), top_tube());
  EXPECT_GT(b.radius, 3);
  EXPECT_LT(b.borders[0].quality.ripple, 0.05);
  EXPECT_LT(degrees(b.borders[0].quality.cloud_error.mean), 10);
}

TEST(Blend, linearCollarIsTheThesiss) {
  BlendOptions options = from({"v1"}, 0);
  options.method = BlendMethod::linear;
  options.height = 4, options.width = 5.66;
  const std::vector<Vec3> cloud = cube();
  const Blend b = blend(cloud, top_tube(), options);
  const std::vector<Vec3> collar = points_of(b, BlendSource::collar);
  for (const Vec3& p : points_of(b, BlendSource::nurbs))
    for (const Vec3& q : cloud) ASSERT_GE(distance(p, q), 4 * b.spacing - 1e-9);
  for (std::size_t i = 0; i < collar.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) ASSERT_GT(distance(collar[i], collar[j]), 0.99);
  // Both borders have a kink, which the kernel turns into a wrong normal.
  EXPECT_GT(degrees(b.borders[0].quality.face_error.mean), 12);
  EXPECT_GT(degrees(b.borders[0].quality.cloud_error.mean), 12);
}

void expect_refused(const NurbsFace& face, const BlendOptions& options, const std::string& why,
                    const std::vector<Vec3>& cloud = cube()) {
  try {
    blend(cloud, face, options);
    ADD_FAILURE() << "not refused: " << why;
  } catch (const NoResultError& error) {
    EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
  }
}

TEST(Blend, loopsThatDoNotCloseAreToldWhere) {
  // A tilted tube of which one half ends above the cloud.
  const Vec3 axis{0.5, 0, std::sqrt(0.75)};
  expect_refused(face_of(nurbs_tube({{20, 20, 0}, axis}, 8, 20)), from({"v1"}),
                 "it ends inside the cloud at (20.43, 12.01, 0.00) and at (20.43, 27.99",
                 plane(41));
  const NurbsFace tube = face_of(nurbs_tube({{20, 20, -8}, ez}, 8, 28));
  // Two levels, with nothing between them.
  std::vector<Vec3> levels;
  for (const Vec3& p : plane(41)) levels.push_back(p.x < 20.5 ? p : p + ez * 7.0);
  expect_refused(tube, from({"v1"}), "does not close: it jumps", levels);
}

TEST(Blend, saysWhatStandsInTheWay) {
  const NurbsFace away = face_of(nurbs_tube({{20.5, 20.5, 60}, ez}, 8, 20));
  expect_refused(away, from({"v1"}), "do not meet");
  expect_refused(top_tube(), from({"v0"}), "lies inside the cloud");
  expect_refused(top_tube(9), from({"v1"}), "wider than the face");
  BlendOptions high = from({"v1"}, 0);
  high.height = 30, high.width = 3;
  expect_refused(top_tube(), high, "wider than the face");
  const NurbsFace handle = face_of(nurbs_u_tube({{15.5, 20.5, 36}, ez}, ex, 4, 14, 10));
  BlendOptions wide = from({"v=0.5+", "v=0.5-"}, 0);
  wide.height = 3, wide.width = 3;
  expect_refused(handle, wide, "overlap");
  const NurbsFace through = face_of(nurbs_tube({{20.5, 20.5, -10}, ez}, 8, 61));
  expect_refused(through, {}, "v0 v1");
  expect_refused(top_tube(), from({"v1"}, 20), "wider than the cloud", [] {
    std::vector<Vec3> small;
    for (const Vec3& p : plane(31)) small.push_back(p + Vec3{5.5, 5.5, 41});
    return small;
  }());
  const NurbsFace sheet = face_of(nurbs_sheet(20, 20, 4, [](double x, double y) {
    return Vec3{20, x + 10, y - 8};
  }));
  expect_refused(sheet, from({"v1"}),
                 "it ends inside the cloud at (20.00, 10.00, 0.00) and at (20.00, 30.00, 0.00)",
                 plane(41));
  expect_refused(sheet_across(), from({"v1"}), "the cloud goes round it", [] {
    std::vector<Vec3> tube;  // which the sheet cuts open, but not in two
    for (int i = 0; i < 120; ++i)
      for (int j = 0; j <= 40; ++j)
        tube.push_back({20 + 19 * std::cos(2 * pi * i / 120), double(j),
                        -19 + 19 * std::sin(2 * pi * i / 120)});
    return tube;
  }());
}

}  // namespace
}  // namespace spigolo::test
