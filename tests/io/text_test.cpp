// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/io/text_test.cpp - tables of numbers
#include "support.h"

#include "spigolo/io/text.h"

namespace spigolo {
namespace {

PointCloud table(std::string_view text, FileFormat format = FileFormat::xyz,
                 ReadReport* report = nullptr) {
  const PointCloud cloud = read_cloud(as_input(text), format, report);
  validate(cloud);
  return cloud;
}

std::string error_of(std::string_view text, FileFormat format = FileFormat::xyz) {
  return message_of<InputError>([&] { table(text, format); });
}

std::string names_of(const PointCloud& cloud) {
  std::string names;
  for (const Attribute& a : cloud.attributes) names += a.name + " ";
  return names;
}

TEST(Table, SeparatorsCommentsAndLineEnds) {
  const std::vector<Vec3> two = {{1, 2, 3}, {4, 5, 6}};
  for (const char* text :
       {"1 2 3\n4 5 6\n", "1,2,3\r\n4,5,6", "1;2;3\r4;5;6\r", "\t1\t2 , 3\n4\t5\t6",
        "# a\n\n1 2 3 # b\n// c\n; d\n4 5 6 // e\n", "\xef\xbb\xbf+1 2 3\n4 5 6",
        "x,y,z\n1,2,3\n4,5,6\n", "2\n1 2 3\n4 5 6\n", "1e0 .2e1 3.\n4 5 6,\n"})
    EXPECT_EQ(table(text).points, two) << text;
}

TEST(Table, ColumnsWithoutNames) {
  EXPECT_EQ(names_of(table("1 2 3 4 5\n")), "scalar_3 scalar_4 ");
  EXPECT_EQ(names_of(table("1 2 3 0 128 255\n")), "red green blue ");
  EXPECT_EQ(table("1 2 3 0 128 255\n").attributes[0].type, ScalarType::uint8);
  EXPECT_EQ(names_of(table("1 2 3 0 128 256\n")), "scalar_3 scalar_4 scalar_5 ");
  EXPECT_EQ(names_of(table("1 2 3 0.5 0 0\n")), "scalar_3 scalar_4 scalar_5 ");
  EXPECT_EQ(names_of(table("1 2 3 -9 0 0 0\n", FileFormat::pts)), "intensity red green blue ");
  EXPECT_EQ(names_of(table("1 2 3 -9\n", FileFormat::pts)), "intensity ");
}

TEST(Table, NamesPlaceThePositionAndColours) {
  const PointCloud cloud = table("id, Z ,\"Y\",X,R,G,b,my name\n7,3,2,1,10,20,30,0.5\n");
  EXPECT_EQ(cloud.points.at(0), (Vec3{1, 2, 3}));
  EXPECT_EQ(names_of(cloud), "id red green blue my_name ");
  EXPECT_EQ(names_of(table("//X Y Z ni\n1 2 3 4\n")), "ni ");
  EXPECT_EQ(names_of(table("# a remark of four words\n1 2 3 4\n")), "scalar_3 ");
}

TEST(Table, EmptyFieldsAreNan) {
  const PointCloud cloud = table("x,y,z,a,b\n1,2,3,,5\n1,2,3,4,\n");
  EXPECT_TRUE(std::isnan(cloud.find("a")->values[0]));
  EXPECT_EQ(cloud.find("b")->values[0], 5);
  EXPECT_TRUE(std::isnan(cloud.find("b")->values[1]));
}

TEST(Table, SpecialNumbers) {
  const PointCloud cloud = table("nan inf -inf\nNaN INFINITY -Inf\n1.#QNAN 1.#INF -1.#INF\n");
  for (const Vec3& p : cloud.points) {
    EXPECT_TRUE(std::isnan(p.x));
    EXPECT_EQ(p.y, infinity);
    EXPECT_EQ(p.z, -infinity);
  }
  EXPECT_EQ(table("1e-400 0 0\n").points[0].x, 0);
}

TEST(Table, PtsOfSeveralScansAndItsCount) {
  EXPECT_EQ(table("1\n1 2 3\n1\n4 5 6\n", FileFormat::pts).size(), 2u);
  EXPECT_TRUE(has(error_of("3\n1 2 3\n4 5 6\n", FileFormat::pts),
                  "line 3: 3 points are declared, 2 are there"));
  ReadReport report;
  table("1\n1 2 3\n4 5 6\n", FileFormat::pts, &report);
  EXPECT_EQ(report.warnings.size(), 1u);
}

TEST(Table, DamageNamesTheLine) {
  EXPECT_TRUE(has(error_of("1 2 3\n4 5\n"), "fixture, line 2: 2 numbers where the lines before"));
  EXPECT_TRUE(has(error_of("1 2 3\n4 5 6 7\n"), "line 2: 4 numbers"));
  EXPECT_TRUE(has(error_of("1 2 3\n\n4 5 zebra\n"), "line 3: 'zebra' is not a number"));
  EXPECT_TRUE(has(error_of("1 2 3\n4 5 6x\n"), "line 2: "));
  EXPECT_TRUE(has(error_of("1 2\n"), "line 1: only 2 numbers"));
  EXPECT_TRUE(has(error_of("1e999 2 3\n"), "line 1: "));
  EXPECT_TRUE(has(error_of("# nothing\n\n"), "line 2: no point"));
  EXPECT_TRUE(has(error_of("Once upon a time\nthere was a king\n"), "line 2"));
}

TEST(Table, DecimalCommasAreCalledByName) {
  for (const char* text : {"1,5 2,5 3,5\n", "1,5;2,5;3,5\n", "-1,5\t2,5\t-3,5\n", "1 2,5 3\n"})
    EXPECT_TRUE(has(error_of(text), "decimal commas")) << text;
  EXPECT_EQ(table("1,2, 3\n").size(), 1u);
}

TEST(Table, BinaryAndForeignFilesAreCalledByName) {
  EXPECT_TRUE(has(error_of(std::string("1 2 3\0\1", 7)), "byte 5: binary data"));
  EXPECT_TRUE(has(error_of(std::string("\xff\xfe"
                                       "1\0",
                                       4)),
                  "UTF-16"));
  EXPECT_TRUE(has(error_of("ply\nformat ascii 1.0\n"), "PLY file"));
}

TEST(Numbers, ShortestTextReadsBackEqual) {
  Random random(11);
  for (int i = 0; i < 100000; ++i) {
    for (const ScalarType type : {ScalarType::float64, ScalarType::float32}) {
      const double value = random_value(random, type);
      std::string text;
      append_number(text, value, type);
      WordReader words("", text, 1);
      ASSERT_TRUE(same_bits(words.number(type), value)) << text;
    }
  }
}

TEST(Numbers, WholeNumbersLookLikeThem) {
  std::string text;
  append_number(text, 100000, ScalarType::float64);
  text += ' ';
  append_number(text, -0.0, ScalarType::float64);
  text += ' ';
  append_number(text, 300, ScalarType::uint8);
  EXPECT_EQ(text, "100000 -0 255");
}

}  // namespace
}  // namespace spigolo
