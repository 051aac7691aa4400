// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/io/pcd_test.cpp - PCD by hand, and its compression
#include "support.h"

#include "spigolo/io/lzf.h"

namespace spigolo {
namespace {

std::string error_of(std::string_view text) {
  return message_of<InputError>([&] { read_cloud(as_input(text), FileFormat::pcd); });
}

std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

const std::string head =
    "# .PCD v.5\nVERSION .5\nFIELDS x y z rgb _ id hist\nSIZE 4 4 4 4 1 8 2\nTYPE F F F F U U I\n"
    "COUNT 1 1 1 1 3 1 2\nWIDTH 1\nHEIGHT 2\nPOINTS 2\nDATA ";

std::string binary_point(float x) {
  return little(x, 2.f, 3.f, 0xff102030u, '_', '_', '_', std::uint64_t{5000000000},
                std::int16_t{-1}, std::int16_t{9});
}

void expect_fixture(const PointCloud& cloud) {
  validate(cloud);
  ASSERT_EQ(cloud.size(), 2u);
  EXPECT_TRUE(std::isnan(cloud.points[0].x));
  EXPECT_EQ(cloud.points[1], (Vec3{1, 2, 3}));
  const char* names[] = {"red", "green", "blue", "id", "hist_0", "hist_1"};
  const double values[] = {0x10, 0x20, 0x30, 5000000000, -1, 9};
  ASSERT_EQ(cloud.attributes.size(), 6u);
  for (std::size_t a = 0; a < 6; ++a) {
    EXPECT_EQ(cloud.attributes[a].name, names[a]);
    EXPECT_EQ(cloud.attributes[a].values[1], values[a]);
  }
  EXPECT_EQ(cloud.attributes[4].type, ScalarType::int16);
}

TEST(Pcd, BinaryWithPaddingCountsAndPackedColour) {
  const std::string text = head + "binary\n" + binary_point(NAN) + binary_point(1);
  expect_fixture(read_cloud(as_input(text), FileFormat::pcd));
}

TEST(Pcd, AsciiWithPackedColour) {
  std::string text = head + "ascii\n";
  const auto colour = std::to_string(std::bit_cast<float>(0x00102030u));
  EXPECT_EQ(colour, "0.000000") << "a colour printed with six decimals would be lost";
  text += "nan 2 3 1.481e-39 0 0 0 5000000000 -1 9\n1 2 3 1.48132e-39 0 0 0 5000000000 -1 9\n";
  const PointCloud cloud = read_cloud(as_input(text), FileFormat::pcd);
  EXPECT_EQ(cloud.find("red")->values[1], 0x10);
  EXPECT_EQ(cloud.find("id")->values[1], 5000000000);
}

TEST(Pcd, CompressedFieldByField) {
  std::string plain = little(NAN, 1.f, 2.f, 2.f, 3.f, 3.f, 0x00102030u, 0x00102030u);
  plain += "______" + little(std::uint64_t{5000000000}, std::uint64_t{5000000000});
  plain += little(std::int16_t{-1}, std::int16_t{9}, std::int16_t{-1}, std::int16_t{9});
  const auto packed_bytes = lzf_compress(bytes_of(plain));
  const std::string stream(reinterpret_cast<const char*>(packed_bytes.data()), packed_bytes.size());
  const auto file = [&](std::uint32_t packed_size, std::uint32_t plain_size) {
    return head + "binary_compressed\n" + little(packed_size, plain_size) + stream;
  };
  const auto size = static_cast<std::uint32_t>(stream.size());
  const auto whole = static_cast<std::uint32_t>(plain.size());
  expect_fixture(read_cloud(as_input(file(size, whole)), FileFormat::pcd));
  EXPECT_TRUE(has(error_of(file(size - 1, whole)), "compressed data is damaged"));
  EXPECT_TRUE(has(error_of(file(size, whole + 1)), "not of 2 points"));
  EXPECT_TRUE(has(error_of(file(size + 1, whole)), "cut off"));
}

TEST(Pcd, DamagedHeadersNameTheLine) {
  EXPECT_TRUE(has(error_of("hello\nworld\n"), "fixture, header line 1: unknown keyword 'hello'"));
  EXPECT_TRUE(has(error_of("VERSION .7\n"), "'DATA ...' is missing"));
  EXPECT_TRUE(has(error_of("FIELDS x\nSIZE 4\nTYPE F\nWIDTH 1\nDATA zip\n"), "unknown data 'zip'"));
  EXPECT_TRUE(
      has(error_of("FIELDS x y\nSIZE 4\nTYPE F\nWIDTH 1\nDATA ascii\n"), "differ in length"));
  EXPECT_TRUE(has(error_of("FIELDS x\nSIZE 3\nTYPE F\nWIDTH 1\nDATA ascii\n"), "field 'x'"));
  EXPECT_TRUE(
      has(error_of("FIELDS x\nSIZE 4\nTYPE F\nWIDTH 1\nDATA ascii\n"), "no fields x, y, z"));
  EXPECT_TRUE(
      has(error_of("FIELDS x\nSIZE 4\nTYPE F\nWIDTH 2\nPOINTS 3\nDATA ascii\n"), "not POINTS"));
}

TEST(Lzf, WhatTheFormatSays) {
  std::vector<std::byte> out(10);
  // one literal 'a', then a match of 9 bytes one byte back
  const std::string stream = std::string("\0a", 2) + "\xe0" + std::string("\0\0", 2);
  ASSERT_TRUE(lzf_decompress(bytes_of(stream), out));
  EXPECT_EQ(out, std::vector<std::byte>(10, std::byte{'a'}));
}

TEST(Lzf, RoundTripsOfRuns_Noise_AndText) {
  Random random(3);
  for (std::size_t n : {0u, 1u, 2u, 3u, 31u, 32u, 33u, 264u, 265u, 8192u, 70000u})
    for (const std::uint64_t letters : {1u, 2u, 5u, 256u}) {
      std::string text(n, ' ');
      for (char& c : text) c = static_cast<char>(random.below(letters));
      const auto packed_bytes = lzf_compress(bytes_of(text));
      EXPECT_LE(packed_bytes.size(), n + n / 32 + 1);
      std::vector<std::byte> out(n);
      ASSERT_TRUE(lzf_decompress(packed_bytes, out));
      EXPECT_TRUE(std::equal(out.begin(), out.end(), bytes_of(text).begin()));
    }
}

TEST(Lzf, DamageIsFound) {
  std::vector<std::byte> out(4);
  for (const std::string& stream :
       {std::string("\3abc"), std::string("\4abcde"), std::string("\x20\0", 2),
        std::string("\xe0", 1), std::string("\0a", 2), std::string("\0a\xe0\0\0", 5)})
    EXPECT_FALSE(lzf_decompress(bytes_of(stream), out));
}

}  // namespace
}  // namespace spigolo
