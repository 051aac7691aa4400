// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/io/las_test.cpp - LAS by hand, its grid, and what goes where
#include "support.h"

#include "spigolo/io/coordinate_grid.h"

namespace spigolo {
namespace {

template <class T>
void put(std::string& bytes, std::size_t at, T value) {
  bytes.replace(at, sizeof value, little(value));
}

// A file of the version and format with these records behind one another.
std::string las(int minor, int format, std::size_t record, const std::string& points,
                const std::string& records = "") {
  const std::size_t size = minor == 4 ? 375 : minor == 3 ? 235 : 227;
  std::string h(size, '\0');
  h.replace(0, 4, "LASF");
  put(h, 24, '\1');
  put(h, 25, static_cast<char>(minor));
  put(h, 94, static_cast<std::uint16_t>(size));
  put(h, 96, static_cast<std::uint32_t>(size + records.size()));
  put(h, 100, static_cast<std::uint32_t>(records.empty() ? 0 : 1));
  put(h, 104, static_cast<char>(format));
  put(h, 105, static_cast<std::uint16_t>(record));
  const auto count = points.size() / record;
  if (format < 6) put(h, 107, static_cast<std::uint32_t>(count));
  if (minor == 4) put(h, 247, static_cast<std::uint64_t>(count));
  for (std::size_t axis = 0; axis < 3; ++axis) put(h, 131 + 8 * axis, 0.001);
  put(h, 155 + 8, 6000000.0);
  return h + records + points;
}

PointCloud cloud_of(const std::string& text, ReadReport* report = nullptr) {
  const PointCloud cloud = read_cloud(as_input(text), FileFormat::las, report);
  validate(cloud);
  return cloud;
}

std::string error_of(const std::string& text) {
  return message_of<InputError>([&] { cloud_of(text); });
}

double value(const PointCloud& cloud, const char* name) {
  const Attribute* a = cloud.find(name);
  return a ? a->values.at(0) : -1;
}

const std::string start = little(std::int32_t{512345678}, std::int32_t{123456789}, std::int32_t{-1},
                                 std::uint16_t{65535});

TEST(Las, OldPointFormat) {
  const std::string point =
      start + "\xd2\xa2" + little(std::int8_t{-15}, std::uint8_t{7}, std::uint16_t{9}, 12.5);
  const std::string colour = little(std::uint16_t{1}, std::uint16_t{2}, std::uint16_t{65535});
  ReadReport report;
  const PointCloud cloud = cloud_of(las(2, 3, 34, point + colour), &report);
  EXPECT_EQ(cloud.points.at(0), (Vec3{512345.678, 6123456.789, -0.001}));
  EXPECT_EQ(value(cloud, "intensity"), 65535);
  EXPECT_EQ(value(cloud, "return_number"), 2);
  EXPECT_EQ(value(cloud, "number_of_returns"), 2);
  EXPECT_EQ(value(cloud, "scan_direction"), 1);
  EXPECT_EQ(value(cloud, "edge_of_flight_line"), 1);
  EXPECT_EQ(value(cloud, "classification"), 2);
  EXPECT_EQ(value(cloud, "synthetic"), 1);
  EXPECT_EQ(value(cloud, "key_point"), -1) << "zero everywhere: left out";
  EXPECT_EQ(value(cloud, "withheld"), 1);
  EXPECT_EQ(value(cloud, "scan_angle_rank"), -15);
  EXPECT_EQ(value(cloud, "gps_time"), 12.5);
  EXPECT_EQ(value(cloud, "blue"), 65535);
  EXPECT_EQ(report.version, "1.2, point format 3");
  EXPECT_EQ(report.grid->offset.y, 6000000);
}

TEST(Las, NewPointFormatWithExtraBytes) {
  std::string scaled(192, '\0'), array(192, '\0'), vlr(54, '\0');
  put(scaled, 2, '\3');
  put(scaled, 3, '\x18');
  scaled.replace(4, 6, "height");
  put(scaled, 112, 0.5);
  put(scaled, 136, 2.0);
  put(array, 2, '\x0d');  // two numbers of type 3
  array.replace(4, 3, "vec");
  vlr.replace(2, 9, "LASF_Spec");
  put(vlr, 18, std::uint16_t{4});
  put(vlr, 20, std::uint16_t{384});
  const std::string point =
      start + "\x43\x1f" +
      little(std::uint8_t{200}, std::uint8_t{0}, std::int16_t{-5000}, std::uint16_t{1}, 0.5) +
      std::string(6, '\1') + little(std::uint16_t{77}) +
      little(std::uint16_t{10}, std::uint16_t{3}, std::uint16_t{4}) + "?";
  ReadReport report;
  const PointCloud cloud = cloud_of(las(4, 8, 45, point, vlr + scaled + array), &report);
  EXPECT_EQ(value(cloud, "return_number"), 3);
  EXPECT_EQ(value(cloud, "number_of_returns"), 4);
  EXPECT_EQ(value(cloud, "overlap"), 1);
  EXPECT_EQ(value(cloud, "scanner_channel"), 1);
  EXPECT_EQ(value(cloud, "classification"), 200);
  EXPECT_EQ(value(cloud, "scan_angle"), -5000);
  EXPECT_EQ(value(cloud, "nir"), 77);
  EXPECT_EQ(value(cloud, "height"), 7);
  EXPECT_EQ(value(cloud, "vec_0"), 3);
  EXPECT_EQ(value(cloud, "vec_1"), 4);
  EXPECT_EQ(report.skipped.size(), 1u) << "the byte nothing describes";
}

TEST(Las, EveryPointFormatReadsItsSize) {
  const std::size_t sizes[] = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
  for (int format = 0; format < 11; ++format) {
    std::string point = start + std::string(sizes[format] - start.size(), '\0');
    EXPECT_EQ(cloud_of(las(4, format, sizes[format], point + point)).size(), 2u) << format;
    EXPECT_TRUE(has(error_of(las(4, format, sizes[format] - 1, point)), "too short for format"));
  }
}

TEST(Las, AttributesComeBackFromStandardFieldsAndExtraBytes) {
  Random random(4);
  for (const bool modern : {false, true}) {
    PointCloud cloud = survey_cloud(200, 5);
    const auto add = [&](const char* name, ScalarType type, std::uint64_t below) {
      std::vector<double> values(cloud.size());
      for (double& v : values) v = static_cast<double>(random.below(below));
      cloud.set(name, type, values);
    };
    add("intensity", ScalarType::uint16, 65536);
    add("return_number", ScalarType::uint8, modern ? 16 : 8);
    add("classification", ScalarType::uint8, modern ? 256 : 32);
    if (modern) add("overlap", ScalarType::uint8, 2);
    for (const char* name : {"red", "green", "blue"}) add(name, ScalarType::uint16, 65536);
    if (modern) add("nir", ScalarType::uint16, 65536);
    const TempFolder folder;
    EXPECT_EQ(write_cloud(folder / "a.las", cloud).rounding, 0);
    ReadReport report;
    PointCloud back = read_cloud(folder / "a.las", &report);
    EXPECT_EQ(report.version, modern ? "1.4, point format 8" : "1.2, point format 2");
    ASSERT_EQ(back.attributes.size(), cloud.attributes.size());
    expect_same_points(cloud, back);
    for (const Attribute& a : cloud.attributes) expect_same_values(a, *back.find(a.name));
    const PointCloud types = random_cloud(cloud.size(), 6);
    for (const Attribute& a : types.attributes) cloud.set(a.name, a.type, a.values);
    write_cloud(folder / "a.las", cloud);
    back = read_cloud(folder / "a.las", &report);
    EXPECT_EQ(report.version, modern ? "1.4, point format 8" : "1.4, point format 2");
    for (const Attribute& a : types.attributes) {
      expect_same_values(a, *back.find(a.name));
      EXPECT_EQ(back.find(a.name)->type, a.type);
    }
  }
}

TEST(Las, TheGridOfTheSourceIsKept) {
  const TempFolder folder;
  PointCloud cloud;
  cloud.points = {{0.25, 0.5, 1000}, {0.75, 2, -1000}};
  WriteOptions options;
  options.grid = CoordinateGrid{{0.25, 0.001, 0.01}, {0.25, 0, 500}};
  EXPECT_EQ(write_cloud(folder / "a.las", cloud, options).rounding, 0);
  ReadReport report;
  expect_same(cloud, read_cloud(folder / "a.las", &report));
  EXPECT_EQ(report.grid->scale, options.grid->scale);
  EXPECT_EQ(report.grid->offset, options.grid->offset);
}

TEST(Las, RoundingIsToldAndSmall) {
  const TempFolder folder;
  Random random(8);
  PointCloud cloud;
  for (int i = 0; i < 1000; ++i) cloud.points.push_back(random.in_ball());
  const WriteReport report = write_cloud(folder / "a.las", cloud);
  EXPECT_GT(report.rounding, 0);
  EXPECT_LE(report.rounding, 0.5e-9 * 1.0001);
  cloud.points.push_back({1e12, -1e300, 0});
  EXPECT_GT(write_cloud(folder / "b.las", cloud).rounding, 1);
  cloud.points.push_back({not_a_number, 0, 0});
  EXPECT_TRUE(
      has(message_of<UsageError>([&] { write_cloud(folder / "c.las", cloud); }), "point 1001"));
}

TEST(Las, DecimalGridsGiveTheNearestDoubles) {
  const GridAxis axis(0.001, 6000000);
  EXPECT_EQ(axis.decode(123456789), 6123456.789);
  EXPECT_NE(123456789 * 0.001 + 6000000, std::nextafter(6123456.789, 0));
  Random random(9);
  for (int i = 0; i < 100000; ++i) {
    const auto integer = static_cast<std::int32_t>(random.bits());
    ASSERT_EQ(axis.encode(axis.decode(integer)), integer);
    ASSERT_EQ(axis.decode(integer), static_cast<double>(6000000000 + std::int64_t{integer}) / 1000);
    const GridAxis odd(0.00025, 0.1);
    ASSERT_EQ(odd.encode(odd.decode(integer)), integer);
  }
  EXPECT_FALSE(axis.encode(1e9));
}

TEST(Las, CompressedAndDamagedFilesAreCalledByName) {
  const std::string point = start + std::string(6, '\0');
  const std::string good = las(2, 0, 20, point);
  const auto with = [&](std::size_t at, auto bytes) {
    std::string bad = good;
    put(bad, at, bytes);
    return error_of(bad);
  };
  EXPECT_EQ(cloud_of(good).size(), 1u);
  EXPECT_TRUE(has(with(104, '\x80'), "byte 104: the points are compressed (LAZ)"));
  EXPECT_TRUE(has(with(104, '\x40'), "laszip"));
  EXPECT_TRUE(has(with(104, '\x0b'), "point format 11"));
  EXPECT_TRUE(has(with(0, 'X'), "'LASF'"));
  EXPECT_TRUE(has(with(25, '\5'), "LAS version 1.5"));
  EXPECT_TRUE(has(with(131, 0.0), "byte 131"));
  EXPECT_TRUE(has(with(155, not_a_number), "byte 155") || has(with(155, not_a_number), "byte 131"));
  EXPECT_TRUE(has(with(107, 2u), "claims 2 points, 1 are there"));
  EXPECT_TRUE(has(with(96, 100u), "inside the header"));
  EXPECT_TRUE(has(with(94, std::uint16_t{9999}), "header size"));
}

}  // namespace
}  // namespace spigolo
