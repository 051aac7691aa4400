// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/names.cpp
#include "spigolo/io/names.h"

namespace spigolo {

std::string UniqueNames::operator()(std::string_view wanted) {
  std::string name(wanted);
  for (char& c : name)
    if (static_cast<unsigned char>(c) <= ' ' || c == 127) c = '_';
  if (name.empty()) name = "scalar";
  std::string candidate = name;
  for (int n = 2; !taken_.insert(candidate).second; ++n) candidate = name + "_" + std::to_string(n);
  return candidate;
}

std::vector<std::string> file_names(const PointCloud& cloud) {
  UniqueNames unique{"x", "y", "z"};
  std::vector<std::string> names;
  for (const Attribute& attribute : cloud.attributes) names.push_back(unique(attribute.name));
  return names;
}

}  // namespace spigolo
