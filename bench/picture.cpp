// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/picture.cpp
#include "picture.h"

#include "spigolo/io/atomic_file.h"

namespace spigolo::bench {

RenderOptions bare_look(int width, int height, const char* direction) {
  RenderOptions options;
  options.width = width, options.height = height;
  options.view.direction = parse_view_direction(direction);
  options.axes = options.scale_bar = options.legend = false;
  options.bottom = options.top;
  return options;
}

void save_picture(const std::filesystem::path& file, const Image& image, int colors) {
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path());
  const std::vector<std::byte> png = encode_png(image, colors);
  AtomicFile out(file);
  out.write({reinterpret_cast<const char*>(png.data()), png.size()});
  out.commit();
}

}  // namespace spigolo::bench
