// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/gradient.cpp
#include "spigolo/synth/gradient.h"

#include <array>

namespace spigolo {

Gradient::Gradient(const Box& box, std::size_t rank, double ratio) : rate_(std::log(ratio)) {
  std::array<std::size_t, 3> axes = {0, 1, 2};
  const Vec3 size = box.size();
  std::stable_sort(axes.begin(), axes.end(),
                   [&](std::size_t a, std::size_t b) { return size[a] > size[b]; });
  axis_ = axes[rank];
  from_ = box.min[axis_];
  length_ = size[axis_] > 0 ? size[axis_] : 1;
}

double Gradient::at(const Vec3& p) const {
  if (even()) return 1;
  const double t = std::clamp((p[axis_] - from_) / length_, 0.0, 1.0);
  return std::exp(rate_ * (t - 0.5));
}

}  // namespace spigolo
