// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/minimize.h - the global minimum of a function of one variable, without derivatives
#pragma once

#include <algorithm>
#include <vector>

namespace spigolo {

/// Smallest value of f between a and b, where f has one minimum: golden sections until the
/// interval is down to rounding.
template <class F>
double golden_section(const F& f, double a, double b) {
  constexpr double ratio = 0.6180339887498949;
  constexpr int steps = 80;  // .618^80 = 2e-17
  double c = b - ratio * (b - a), d = a + ratio * (b - a);
  double fc = f(c), fd = f(d);
  for (int i = 0; i < steps; ++i) {
    if (fc < fd) {
      b = d, d = c, fd = fc;
      c = b - ratio * (b - a), fc = f(c);
    } else {
      a = c, c = d, fc = fd;
      d = a + ratio * (b - a), fd = f(d);
    }
  }
  return fc < fd ? c : d;
}

/// The place in [0, 1] where f is smallest. seeds: so many intervals that f has at most one minimum
/// in two neighboring ones. closed: f(0) and f(1) are the same place, so is f(t) and f(t + 1).
template <class F>
double minimize_unit(const F& f, int seeds, bool closed) {
  const double step = 1.0 / seeds;
  std::vector<double> value(static_cast<std::size_t>(seeds) + 1);
  for (std::size_t i = 0; i < value.size(); ++i) value[i] = f(static_cast<double>(i) * step);
  const std::size_t last = value.size() - 1;
  double best_t = 0, best = value[0];
  for (std::size_t i = 0; i <= last; ++i) {
    const double before = i > 0 ? value[i - 1] : closed ? value[last - 1] : value[0];
    const double after = i < last ? value[i + 1] : closed ? value[1] : value[last];
    if (value[i] > before || value[i] > after) continue;
    double a = (static_cast<double>(i) - 1) * step, b = (static_cast<double>(i) + 1) * step;
    if (!closed) a = std::max(a, 0.0), b = std::min(b, 1.0);
    for (const double t : {static_cast<double>(i) * step, golden_section(f, a, b)})
      if (const double y = f(t); y < best) best = y, best_t = t;
  }
  return best_t < 0 ? best_t + 1 : best_t > 1 ? best_t - 1 : best_t;
}

}  // namespace spigolo
