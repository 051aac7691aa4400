// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/catalogue.cpp - the list of all shapes
#include "spigolo/synth/catalogue.h"

#include <array>
#include <string_view>

#include "spigolo/core/error.h"

namespace spigolo {
namespace {

struct Entry {
  ShapeInfo info;
  Construction (*make)(const SynthOptions&);
};

constexpr Entry entries[] = {
    {{"cube", "thesis: 42 points an edge, 488 feature points of 10088", true}, make_cube},
    {{"planes", "thesis: two ruled sheets, 45 to 140 degrees along a straight edge of 256 points",
      true},
     make_planes},
    {{"hole", "thesis: cube of 91 points an edge with a round hole of 137, 1350 feature points",
      true},
     make_hole},
    {{"hole17k",
      "thesis, noise tests: 49 points an edge, 133 round the rim, spacing 0.25; radius taken as "
      "8.5",
      true},
     make_hole17k},
    {{"wedge", "two planes that meet in an edge; --angle sets their interior angle", true},
     make_wedge},
    {{"box", "1 x 0.8 x 0.6", true}, make_box},
    {{"plate", "1 x 0.8 plate; --size is its thickness in mean spacings", false}, make_plate},
    {{"slot", "block with a groove; --size is its width in mean spacings", false}, make_slot},
    {{"fillet-box", "box without edges; --size is the radius in mean spacings", false},
     make_fillet_box},
    {{"chamfer-box", "box with chamfered edges; --size is their width in mean spacings", false},
     make_chamfer_box},
    {{"l-prism", "L-shaped block: one concave edge, two saddle corners", true}, make_l_prism},
    {{"steps", "three stairs: convex and concave edges", true}, make_steps},
    {{"star", "five-pointed star prism: acute and concave edges", false}, make_star},
    {{"pyramid", "four edges in one corner, or --sides of them", false}, make_pyramid},
    {{"fade", "an edge that fades out: from --angle at one end to flat at the other", false},
     make_fade},
    {{"boxhole", "1 x 0.8 x 0.6 box with a round hole of radius 0.2", false}, make_boxhole},
    {{"cylinder", "radius 0.4, height 1", false}, make_cylinder},
    {{"cylinder-hole", "tube of radii 0.5 and 0.3", false}, make_cylinder_hole},
    {{"cylinders", "two crossing cylinders: curved concave edges of changing angle", false},
     make_cylinders},
    {{"cone", "a tip and a round edge", false}, make_cone},
    {{"spike", "cone with an apex of --angle", false}, make_spike},
    {{"sphere", "smooth, closed", false}, make_sphere},
    {{"torus", "smooth, closed, with negative curvature", false}, make_torus},
    {{"cap", "sphere cut by a plane", false}, make_cap},
    {{"lens", "two spheres that meet in a round edge", false}, make_lens},
    {{"patch", "open saddle z = 1.2 x y with four borders", false}, make_patch},
    {{"dome", "open half sphere with a round border", false}, make_dome},
};

}  // namespace

Construction construct(const SynthOptions& options) {
  for (const Entry& entry : entries)
    if (options.shape == entry.info.name) return entry.make(options);
  std::string known;
  for (const Entry& entry : entries) known += std::string(" ") + entry.info.name;
  throw UsageError("no shape is called '" + options.shape + "'; known are" + known);
}

void check_angle(const SynthOptions& options) {
  if (!(options.angle >= radians(5) && options.angle <= radians(175)))
    throw UsageError("the angle of shape '" + options.shape +
                     "' must lie between 5 and 175 degrees");
}

std::span<const ShapeInfo> synth_shapes() {
  static const auto infos = [] {
    std::array<ShapeInfo, std::size(entries)> list{};
    for (std::size_t i = 0; i < list.size(); ++i) list[i] = entries[i].info;
    return list;
  }();
  return infos;
}

}  // namespace spigolo
