// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
#include "spigolo/sheets/label_hints.h"

#include <gtest/gtest.h>

namespace spigolo {
namespace {

// One point on the y axis, where z = 0 (x < 0) meets x = 0 (z < 0); labelled as an edge.
struct Place {
  SheetModel model;
  SheetRegion region;

  explicit Place(double strength) {
    model.prepared.cloud.points = {{0, 0, 0}};
    model.tolerances.noise = 0.7;
    SheetVerdict label;
    label.kind = PointKind::edge;
    label.strength = strength;
    label.crease_point = {0.2, 0, 0.1};
    label.direction = {0, 1, 0};
    label.into = {Vec3{-1, 0, 0}, Vec3{0, 0, -1}};
    model.verdicts = VerdictRows(1);
    model.verdicts.set(0, label);
    region.found = {{0.0, 0}};
    region.sheets = sheets_of_labels(model, region);
  }
};

TEST(LabelHints, AnEdgeTellsOfItsTwoPlanes) {
  const Place place(0.8);
  ASSERT_EQ(place.region.sheets.count, 2U);
  EXPECT_NEAR(height(place.region.sheets.sheet[0], {-4, 7, 0.1}), 0, 1e-12);
  EXPECT_NEAR(height(place.region.sheets.sheet[1], {0.2, 7, -4}), 0, 1e-12);
  EXPECT_EQ(Place(0.1).region.sheets.count, 0U);  // too unsure
}

TEST(LabelHints, OnlyGivenLabelsPinAndTheSurerTheMore) {
  Place sure(1), unsure(0.6);
  EXPECT_TRUE(pin_creases(sure.model, sure.region, 0.7).empty());
  sure.model.labels_given = unsure.model.labels_given = true;
  EXPECT_TRUE(pin_creases(sure.model, sure.region, 0.2).empty());  // little noise
  const auto pins = pin_creases(sure.model, sure.region, 0.7);
  ASSERT_EQ(pins.size(), 1U);
  EXPECT_NE(pins[0].sheets[0], pins[0].sheets[1]);
  EXPECT_GT(pins[0].weight, 10);
  EXPECT_LT(pin_creases(unsure.model, unsure.region, 0.7).at(0).weight, 0.1);
}

TEST(LabelHints, ALabelFarFromEveryCrossingPinsNothing) {
  Place place(1);
  place.model.labels_given = true;
  place.model.verdicts.edit(0).crease_point = {2, 0, 2};
  EXPECT_TRUE(pin_creases(place.model, place.region, 0.7).empty());
  place.model.verdicts.edit(0).crease_point = {0, 0, 0};
  place.model.verdicts.edit(0).direction = {1, 0, 0};  // runs another way
  EXPECT_TRUE(pin_creases(place.model, place.region, 0.7).empty());
}

}  // namespace
}  // namespace spigolo
