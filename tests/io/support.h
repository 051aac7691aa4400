// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/io/support.h - folders that vanish, bytes at hand, clouds of every type
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <bit>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

#include "spigolo/core/error.h"
#include "spigolo/core/random.h"
#include "spigolo/io/cloud_file.h"
#include "spigolo/io/scalar.h"

namespace spigolo {

/// A folder of its own, removed with all in it at the end.
class TempFolder {
 public:
  TempFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "spigolo_io_XXXXXX").string();
    path_ = ::mkdtemp(pattern.data());
  }
  TempFolder(const TempFolder&) = delete;
  ~TempFolder() { std::filesystem::remove_all(path_); }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  std::size_t count() const {
    std::size_t n = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(path_)) ++n;
    return n;
  }

 private:
  std::filesystem::path path_;
};

inline void write_file(const std::filesystem::path& path, std::string_view content) {
  std::ofstream(path, std::ios::binary) << content;
}

inline std::string read_file(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

inline InputBytes as_input(std::string_view text, const char* name = "fixture") {
  return {name, std::as_bytes(std::span(text.data(), text.size()))};
}

/// Little- or big-endian bytes of numbers, one after the other.
template <class... T>
std::string packed(ByteOrder order, T... values) {
  std::string out;
  const auto add = [&](auto value) {
    std::byte bytes[sizeof value];
    store(bytes, value);
    std::string text(reinterpret_cast<const char*>(bytes), sizeof value);
    if (order == ByteOrder::big) text.assign(text.rbegin(), text.rend());
    out += text;
  };
  (add(values), ...);
  return out;
}
template <class... T>
std::string little(T... values) {
  return packed(ByteOrder::little, values...);
}

/// What() of the E that f throws; a failure if it throws none.
template <class E, class F>
std::string message_of(F f) {
  try {
    f();
  } catch (const E& error) {
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return "";
}

inline bool has(const std::string& text, std::string_view part) {
  return text.find(part) != text.npos;
}

inline bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) ||
         (std::isnan(a) && std::isnan(b));
}

inline void expect_same_points(const PointCloud& a, const PointCloud& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis)
      ASSERT_TRUE(same_bits(a.points[i][axis], b.points[i][axis]))
          << "point " << i << ": " << a.points[i][axis] << " and " << b.points[i][axis];
}

inline void expect_same_values(const Attribute& a, const Attribute& b) {
  EXPECT_EQ(a.name, b.name);
  ASSERT_EQ(a.values.size(), b.values.size());
  for (std::size_t i = 0; i < a.values.size(); ++i)
    ASSERT_TRUE(same_bits(a.values[i], b.values[i]))
        << a.name << " " << i << ": " << a.values[i] << " and " << b.values[i];
}

/// Positions, names, order and values; types too unless told otherwise.
inline void expect_same(const PointCloud& a, const PointCloud& b, bool types = true) {
  expect_same_points(a, b);
  ASSERT_EQ(a.attributes.size(), b.attributes.size());
  for (std::size_t i = 0; i < a.attributes.size(); ++i) {
    expect_same_values(a.attributes[i], b.attributes[i]);
    if (!types) continue;
    EXPECT_EQ(a.attributes[i].type, b.attributes[i].type) << a.attributes[i].name;
  }
}

/// A value of the type from random bits: every float there is, no NaN with a message.
inline double random_value(Random& random, ScalarType type) {
  return with_type(type, [&](auto tag) {
    const std::uint64_t bits = random.bits();
    decltype(tag) value;
    std::memcpy(&value, &bits, sizeof value);
    return static_cast<double>(value);
  });
}

/// Random doubles of every size, and one attribute of each type.
inline PointCloud random_cloud(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  PointCloud cloud;
  for (std::size_t i = 0; i < n; ++i)
    cloud.points.push_back(
        {random_value(random, ScalarType::float64), random.uniform(-1e7, 1e7), random.normal()});
  for (int t = 0; t < 8; ++t) {
    const auto type = static_cast<ScalarType>(t);
    std::vector<double> values;
    for (std::size_t i = 0; i < n; ++i) values.push_back(random_value(random, type));
    cloud.set("scalar_of_type_" + std::to_string(t), type, std::move(values));
  }
  return cloud;
}

/// Survey coordinates: metres to the millimetre, as text gives them.
inline PointCloud survey_cloud(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  PointCloud cloud;
  for (std::size_t i = 0; i < n; ++i)
    cloud.points.push_back({static_cast<double>(512345678 + random.below(1000000)) / 1000,
                            static_cast<double>(6123456789 + random.below(1000000)) / 1000,
                            static_cast<double>(random.below(300000)) / 1000});
  cloud.points.push_back({512345.678, 6123456.789, -0.001});
  return cloud;
}

}  // namespace spigolo
