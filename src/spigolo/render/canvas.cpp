// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/canvas.cpp
#include "spigolo/render/canvas.h"

#include "spigolo/render/font.h"
#include "spigolo/render/tiles.h"

namespace spigolo {
namespace {

constexpr double stroke_weight = 1.25;  // [font unit]
constexpr double letter_gap = 0.3;      // [font unit] between advances

void blend(Color& under, const Color& over, double share) {
  const auto mix = [&](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(a + (b - a) * share + 0.5);
  };
  under = {mix(under.r, over.r), mix(under.g, over.g), mix(under.b, over.b)};
}

double distance_to_segment(Spot p, Spot a, Spot b) {
  const double dx = b.x - a.x, dy = b.y - a.y, length2 = dx * dx + dy * dy;
  const double along = (p.x - a.x) * dx + (p.y - a.y) * dy;
  const double t = length2 > 0 ? std::clamp(along / length2, 0.0, 1.0) : 0.0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

// The share of each pixel that strokes cover: a union, so that crossing strokes do not darken
// twice.
class Mask {
 public:
  Mask(const Image& image, Spot low, Spot high) {
    box_ = intersection({static_cast<int>(std::floor(low.x)), static_cast<int>(std::floor(low.y)),
                         static_cast<int>(std::ceil(high.x)), static_cast<int>(std::ceil(high.y))},
                        {0, 0, image.width, image.height});
    if (!box_.empty())
      share_.resize(static_cast<std::size_t>((box_.x1 - box_.x0) * (box_.y1 - box_.y0)));
  }
  void add(Spot a, Spot b, double radius) {
    const double reach = radius + 1;
    const PixelBox box = intersection(
        {static_cast<int>(std::min(a.x, b.x) - reach), static_cast<int>(std::min(a.y, b.y) - reach),
         static_cast<int>(std::max(a.x, b.x) + reach) + 1,
         static_cast<int>(std::max(a.y, b.y) + reach) + 1},
        box_);
    for (int y = box.y0; y < box.y1; ++y)
      for (int x = box.x0; x < box.x1; ++x) {
        double& share = at(x, y);
        const double d = distance_to_segment({x + 0.5, y + 0.5}, a, b);
        share = std::max(share, std::clamp(radius + 0.5 - d, 0.0, 1.0));
      }
  }
  void paint(Image& image, Color color) {
    for (int y = box_.y0; y < box_.y1; ++y)
      for (int x = box_.x0; x < box_.x1; ++x) blend(image.at(x, y), color, at(x, y));
  }

 private:
  double& at(int x, int y) {
    return share_[static_cast<std::size_t>((y - box_.y0) * (box_.x1 - box_.x0) + x - box_.x0)];
  }
  PixelBox box_;
  std::vector<double> share_;
};

}  // namespace

void draw_line(Image& image, Spot a, Spot b, double width, Color color) {
  const double reach = 0.5 * width + 1;
  Mask mask(image, {std::min(a.x, b.x) - reach, std::min(a.y, b.y) - reach},
            {std::max(a.x, b.x) + reach, std::max(a.y, b.y) + reach});
  mask.add(a, b, 0.5 * width);
  mask.paint(image, color);
}

void draw_dot(Image& image, Spot center, double radius, Color color) {
  draw_line(image, center, center, 2 * radius, color);
}

void fill_box(Image& image, Spot corner, Spot opposite, Color color) {
  const auto pixel = [](double v) { return static_cast<int>(std::lround(v)); };
  const PixelBox box =
      intersection({pixel(corner.x), pixel(corner.y), pixel(opposite.x), pixel(opposite.y)},
                   {0, 0, image.width, image.height});
  for (int y = box.y0; y < box.y1; ++y)
    for (int x = box.x0; x < box.x1; ++x) image.at(x, y) = color;
}

double text_width(std::string_view text, const TextStyle& style) {
  double width = 0;
  for (const char c : text) width += glyph(c).advance + letter_gap;
  return (width - (text.empty() ? 0 : 2 + letter_gap)) * style.size / font_cap_height;
}

void draw_text(Image& image, Spot at, std::string_view text, const TextStyle& style) {
  const double unit = style.size / font_cap_height,
               radius = 0.5 * stroke_weight * style.weight * unit;
  Mask mask(image, {at.x - 2 * unit, at.y - 12 * unit},
            {at.x + text_width(text, style) + 3 * unit, at.y + 5 * unit});
  double pen = at.x;
  for (const char c : text) {
    const auto spot = [&](const Vec3& p) { return Spot{pen + p.x * unit, at.y - p.y * unit}; };
    for (const auto& stroke : glyph(c).strokes)
      for (std::size_t i = 0; i + 1 < std::max<std::size_t>(stroke.size(), 2); ++i)
        mask.add(spot(stroke[i]), spot(stroke[std::min(i + 1, stroke.size() - 1)]),
                 stroke.size() == 1 ? 1.3 * radius : radius);
    pen += (glyph(c).advance + letter_gap) * unit;
  }
  mask.paint(image, style.color);
}

}  // namespace spigolo
