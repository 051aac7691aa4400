// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/las_plan.cpp
#include "spigolo/io/las_plan.h"

#include <algorithm>
#include <limits>
#include <string_view>

#include "spigolo/io/scalar.h"

namespace spigolo {
namespace {

constexpr std::size_t most_extras = 65535 / las_extra_descriptor;  // a record's length has 16 bits
constexpr double eight_to_sixteen = 257;                           // 255 becomes 65535

bool is_colour(std::string_view name) { return name == "red" || name == "green" || name == "blue"; }

double factor_of(const Attribute& a) {
  return is_colour(a.name) && a.type == ScalarType::uint8 ? eight_to_sixteen : 1;
}

bool fits(const Attribute& a, const LasField& field) {
  const double factor = factor_of(a);
  return std::all_of(a.values.begin(), a.values.end(),
                     [&](double v) { return field.fits(v * factor); });
}

const LasField* find_field(const std::vector<LasField>& fields, const std::string& name) {
  const auto it =
      std::find_if(fields.begin(), fields.end(), [&](auto& f) { return f.name == name; });
  return it == fields.end() ? nullptr : &*it;
}

// A place in one of the formats 6 to 8, and none in the older ones.
bool wants_modern(const Attribute& a, const std::vector<LasField>& legacy,
                  const std::vector<LasField>& modern) {
  const LasField* newer = find_field(modern, a.name);
  const LasField* older = find_field(legacy, a.name);
  return newer && fits(a, *newer) && !(older && fits(a, *older));
}

std::uint8_t choose_format(const PointCloud& cloud) {
  const std::vector<LasField> legacy = las_fields(3), newest = las_fields(8);
  bool modern = cloud.size() > std::numeric_limits<std::uint32_t>::max();
  for (const Attribute& a : cloud.attributes) modern = modern || wants_modern(a, legacy, newest);
  const bool colour = cloud.find("red") && cloud.find("green") && cloud.find("blue");
  if (modern) return cloud.find("nir") ? 8 : colour ? 7 : 6;
  const bool time = cloud.find("gps_time");
  return static_cast<std::uint8_t>((colour ? 2 : 0) + (time ? 1 : 0));
}

}  // namespace

LasPlan plan_las(const PointCloud& cloud, WriteReport& report) {
  LasPlan plan;
  plan.format = choose_format(cloud);
  plan.record = las_record_sizes[plan.format];
  const std::vector<LasField> fields = las_fields(plan.format);
  for (const Attribute& a : cloud.attributes) {
    const LasField* field = find_field(fields, a.name);
    if (field && fits(a, *field)) {
      plan.columns.push_back({&a, *field, factor_of(a)});
    } else if (plan.extras.size() == most_extras) {
      report.dropped.push_back(a.name);
    } else {
      plan.extras.push_back({&a, {"", a.type, plan.record}});
      plan.record += size_of(a.type);
    }
  }
  if (plan.format >= 6 || !plan.extras.empty()) plan.minor = 4;
  return plan;
}

}  // namespace spigolo
