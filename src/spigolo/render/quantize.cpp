// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/quantize.cpp - boxes of colours are split where they scatter most, at their mean
// (after Heckbert's median cut, 1982); then every colour goes to its nearest mean, a few times
#include "spigolo/render/quantize.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "spigolo/core/error.h"

namespace spigolo {
namespace {

constexpr std::size_t channels = 3;
constexpr int rounds = 4;  // of nearest means; more change hardly a pixel

using Rgb = std::array<double, channels>;

struct Shade {
  Rgb rgb{};
  double pixels = 0;
  std::size_t entry = 0;  // of the palette
};

std::uint32_t key_of(Color c) {
  return std::uint32_t{c.r} << 16 | std::uint32_t{c.g} << 8 | std::uint32_t{c.b};
}

// The colours of the picture, once each, in the order of their keys.
std::map<std::uint32_t, Shade> shades_of(const Image& image) {
  std::map<std::uint32_t, Shade> shades;
  for (const Color c : image.pixels) {
    Shade& shade = shades[key_of(c)];
    shade.rgb = {double(c.r), double(c.g), double(c.b)};
    shade.pixels += 1;
  }
  return shades;
}

// Colours of one box, its mean, and the channel along which it scatters most.
struct Box {
  std::vector<Shade*> shades;
  Rgb mean{};
  std::size_t channel = 0;
  double scatter = 0;

  explicit Box(std::vector<Shade*> members) : shades(std::move(members)) {
    double all = 0;
    Rgb sum{}, squares{};
    for (const Shade* s : shades) {
      all += s->pixels;
      for (std::size_t c = 0; c < channels; ++c) {
        sum[c] += s->pixels * s->rgb[c];
        squares[c] += s->pixels * s->rgb[c] * s->rgb[c];
      }
    }
    for (std::size_t c = 0; c < channels; ++c) {
      mean[c] = sum[c] / all;
      const double along = squares[c] - sum[c] * mean[c];
      if (shades.size() > 1 && along > scatter) scatter = along, channel = c;
    }
  }

  Box split() {
    const auto below = [this](const Shade* s) { return s->rgb[channel] <= mean[channel]; };
    const auto middle = std::stable_partition(shades.begin(), shades.end(), below);
    Box upper(std::vector<Shade*>(middle, shades.end()));
    shades.erase(middle, shades.end());
    *this = Box(std::move(shades));
    return upper;
  }
};

std::vector<Rgb> split_boxes(std::vector<Shade*> shades, std::size_t colors) {
  std::vector<Box> boxes = {Box(std::move(shades))};
  while (boxes.size() < colors) {
    const auto widest =
        std::max_element(boxes.begin(), boxes.end(),
                         [](const Box& a, const Box& b) { return a.scatter < b.scatter; });
    if (widest->scatter <= 0) break;
    Box upper = widest->split();
    boxes.push_back(std::move(upper));
  }
  std::vector<Rgb> means;
  for (const Box& box : boxes) means.push_back(box.mean);
  return means;
}

std::size_t nearest(const std::vector<Rgb>& means, const Rgb& rgb) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t m = 0; m < means.size(); ++m) {
    double sum = 0;
    for (std::size_t c = 0; c < channels; ++c)
      sum += (means[m][c] - rgb[c]) * (means[m][c] - rgb[c]);
    if (sum < least) least = sum, best = m;
  }
  return best;
}

// Each colour to its nearest mean; then, but for the last round, the means anew.
void settle(const std::vector<Shade*>& shades, std::vector<Rgb>& means) {
  for (int round = 0;; ++round) {
    for (Shade* s : shades) s->entry = nearest(means, s->rgb);
    if (round == rounds) return;
    std::vector<Rgb> sum(means.size());
    std::vector<double> all(means.size());
    for (const Shade* s : shades) {
      all[s->entry] += s->pixels;
      for (std::size_t c = 0; c < channels; ++c) sum[s->entry][c] += s->pixels * s->rgb[c];
    }
    for (std::size_t m = 0; m < means.size(); ++m)
      for (std::size_t c = 0; c < channels && all[m] > 0; ++c) means[m][c] = sum[m][c] / all[m];
  }
}

Color rounded(const Rgb& rgb) {
  const auto byte = [](double v) { return static_cast<std::uint8_t>(std::lround(v)); };
  return {byte(rgb[0]), byte(rgb[1]), byte(rgb[2])};
}

}  // namespace

FewColors quantize(const Image& image, int colors) {
  if (colors < 2 || colors > 256) throw UsageError("a palette has 2 to 256 colours");
  FewColors few;
  if (image.pixels.empty()) return few;
  auto shades = shades_of(image);
  std::vector<Shade*> all;
  for (auto& [key, shade] : shades) all.push_back(&shade);
  std::vector<Rgb> means = split_boxes(all, static_cast<std::size_t>(colors));
  settle(all, means);

  constexpr std::size_t unused = 256;
  std::vector<std::size_t> place(means.size(), unused);
  for (const Color c : image.pixels) {
    std::size_t& at = place[shades.at(key_of(c)).entry];
    if (at == unused) {
      at = few.palette.size();
      few.palette.push_back(rounded(means[shades.at(key_of(c)).entry]));
    }
    few.pixels.push_back(static_cast<std::uint8_t>(at));
  }
  return few;
}

}  // namespace spigolo
