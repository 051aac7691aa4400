// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/core/point_cloud.cpp
#include "spigolo/core/point_cloud.h"

#include <algorithm>
#include <utility>

#include "spigolo/core/error.h"

namespace spigolo {

const Attribute* PointCloud::find(std::string_view name) const {
  const auto it = std::find_if(attributes.begin(), attributes.end(),
                               [&](const Attribute& a) { return a.name == name; });
  return it == attributes.end() ? nullptr : &*it;
}

void PointCloud::set(std::string name, ScalarType type, std::vector<double> values) {
  const auto it = std::find_if(attributes.begin(), attributes.end(),
                               [&](const Attribute& a) { return a.name == name; });
  if (it != attributes.end())
    *it = {std::move(name), type, std::move(values)};
  else
    attributes.push_back({std::move(name), type, std::move(values)});
}

void validate(const PointCloud& cloud) {
  for (const Attribute& a : cloud.attributes) {
    if (a.name.empty() || a.name.find_first_of(" \t\r\n") != std::string::npos)
      throw Error("point cloud: attribute name '" + a.name + "' is empty or has blanks");
    if (a.values.size() != cloud.size())
      throw Error("point cloud: attribute '" + a.name + "' has " + std::to_string(a.values.size()) +
                  " values for " + std::to_string(cloud.size()) + " points");
    if (cloud.find(a.name) != &a)
      throw Error("point cloud: attribute '" + a.name + "' stands twice");
  }
}

}  // namespace spigolo
