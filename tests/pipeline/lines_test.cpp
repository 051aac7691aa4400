// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// pipeline: lines by both methods, and as STEP
#include "spigolo/pipeline/lines.h"

#include <gtest/gtest.h>

#include "spigolo/core/error.h"
#include "spigolo/pipeline/curve_step.h"
#include "spigolo/synth/synth.h"

namespace spigolo::test {
namespace {

std::vector<Vec3> shape_points(const char* shape) {
  SynthOptions options;
  options.shape = shape;
  return make_cloud(options).cloud.points;
}

TEST(Lines, bothMethodsFindTheHole) {
  const std::vector<Vec3> points = shape_points("hole17k");
  for (const DetectMethod method : {DetectMethod::sheets, DetectMethod::gauss_map}) {
    LinesOptions options;
    options.detect.method = method;
    const Lines lines = find_lines(points, options);
    validate(lines.network);
    EXPECT_EQ(lines.network.curves.size(), 14u) << static_cast<int>(method);
    EXPECT_EQ(lines.network.corners.size(), 8u) << static_cast<int>(method);
    for (const FeatureCorner& corner : lines.network.corners) EXPECT_EQ(corner.valence, 3);
  }
}

TEST(Lines, labelsNameTheirCurve) {
  const Lines lines = find_lines(shape_points("hole17k"));
  validate(lines.detection.features);
  std::size_t named = 0;
  for (const std::int32_t curve : lines.detection.features.curve) {
    ASSERT_LT(curve, static_cast<std::int32_t>(lines.network.curves.size()));
    named += curve >= 0;
  }
  EXPECT_GE(named, 830u);
}

TEST(Lines, smoothShapesGiveAnEmptyNetwork) {
  const Lines lines = find_lines(shape_points("sphere"));
  EXPECT_TRUE(lines.network.curves.empty());
  EXPECT_NE(step_text(lines.network, LengthUnit::none).find("DATA;"), std::string::npos);
}

TEST(Lines, stepHoldsCirclesAsCircles) {
  const Lines lines = find_lines(shape_points("hole17k"));
  const std::string text = step_text(lines.network, LengthUnit::millimetre);
  std::size_t circles = 0;
  for (std::size_t at = text.find("= CIRCLE("); at != std::string::npos;
       at = text.find("= CIRCLE(", at + 1))
    ++circles;
  EXPECT_EQ(circles, 2u);
  EXPECT_EQ(text, step_text(lines.network, LengthUnit::millimetre));
  EXPECT_THROW(step_text(lines.network, LengthUnit::foot), UsageError);
}

}  // namespace
}  // namespace spigolo::test
