// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/options.cpp
#include "spigolo/blend/options.h"

#include <cmath>
#include <cstdlib>

#include "spigolo/core/error.h"

namespace spigolo {
namespace {

constexpr double largest_length = 1000;  // [spacings]

[[noreturn]] void bad_start(const std::string& text) {
  throw UsageError("start '" + text +
                   "' is none of u0 u1 v0 v1 (a border) or like u=0.4+ v=0.4- (an isoline by its "
                   "share of the range, and the way to go)");
}

void check_length(double value, const char* name) {
  if (!(value >= 0 && value <= largest_length))
    throw UsageError(std::string(name) + " must be above 0 and at most 1000 spacings");
}

}  // namespace

BlendStart parse_start(const std::string& text) {
  if (text.size() < 2 || (text[0] != 'u' && text[0] != 'v')) bad_start(text);
  BlendStart start;
  start.name = text;
  start.along = text[0] == 'u' ? Parameter::u : Parameter::v;
  if (text.size() == 2 && (text[1] == '0' || text[1] == '1')) {
    start.share = text[1] == '0' ? 0 : 1;
    start.direction = text[1] == '0' ? 1 : -1;
    return start;
  }
  const char sign = text.back();
  if (text[1] != '=' || text.size() < 4 || (sign != '+' && sign != '-')) bad_start(text);
  const std::string number = text.substr(2, text.size() - 3);
  char* end = nullptr;
  start.share = std::strtod(number.c_str(), &end);
  if (end != number.c_str() + number.size() || !(start.share >= 0 && start.share <= 1))
    bad_start(text);
  start.border = false;
  start.direction = sign == '+' ? 1 : -1;
  return start;
}

void check_options(const BlendOptions& options) {
  check_length(options.radius, "the radius");
  check_length(options.height, "the height");
  check_length(options.width, "the width");
  if (options.radius > 0 && (options.height > 0 || options.width > 0))
    throw UsageError("give a radius, or a height and a width, not both");
  if ((options.height > 0) != (options.width > 0))
    throw UsageError("height and width go together: give both");
  if (options.keep && !(norm(*options.keep) > 0 && is_finite(*options.keep)))
    throw UsageError("the direction to keep has no length");
  if (options.method == BlendMethod::linear && options.radius > 0)
    throw UsageError("a radius is for the method 'tangent'; 'linear' takes height and width");
}

}  // namespace spigolo
