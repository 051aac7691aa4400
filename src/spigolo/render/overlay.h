// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/overlay.h - what is written round the scene
#pragma once

#include <string>

#include "spigolo/render/camera.h"
#include "spigolo/render/canvas.h"
#include "spigolo/render/scene.h"

namespace spigolo {

/// Height of a capital letter [pixel] that suits a picture of this size.
double letter_size(int width, int height);

/// "1 076": three digits a group.
std::string grouped(std::size_t count);
/// Up to four significant digits, no trailing zeros.
std::string short_number(double value);
/// The largest of 1, 2, 5 times a power of ten that is not above x > 0.
double round_below(double x);

/// Title and legend from the top left; returns the first free row [pixel].
double draw_heading(Image& image, const std::string& title, std::span<const LegendEntry> legend);
/// As draw_heading, drawing nothing.
double heading_height(const Image& image, const std::string& title,
                      std::span<const LegendEntry> legend);
/// Along the right side; color_bar_width is what it needs there [pixel].
void draw_color_bar(Image& image, const ColorBar& bar);
double color_bar_width(const Image& image);
/// Bottom right; unit: [model unit] a pixel covers in the middle of the scene.
void draw_scale_bar(Image& image, double unit);
/// Bottom left.
void draw_axes(Image& image, const Camera& camera);

}  // namespace spigolo
