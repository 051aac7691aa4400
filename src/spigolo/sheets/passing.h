// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/passing.h - with noise: how likely does a crease pass the place a sample was
// taken?
#pragma once

#include "spigolo/sheets/verdict.h"

namespace spigolo {

/// How the samples of a cloud lie about its creases.
struct SamplePlaces {
  double near = 0.6;        // [spacings] a crease this close passes a place
  bool on_creases = false;  // a row of samples was put on each crease, and none right beside it
};

/// A noisy sample may come from any place of the two half planes beside the crease of `edge` (an
/// edge verdict), the less likely the farther off. All places being equally likely beforehand: the
/// probability that its own lies within places.near of the crease; with rows on creases, that it
/// is one of those. Only what the noise did along the sheets matters, not how far off them the
/// sample lies. noise: standard deviation along each axis [spacings], above 0.
double passing_probability(const SheetVerdict& edge, const Vec3& sample, double spacing,
                           const SamplePlaces& places, double noise);

/// Log of how many times likelier a sample is found there if a row was put on the crease.
double placed_evidence(const SheetVerdict& edge, const Vec3& sample, double spacing, double noise);

/// What the samples about the creases that each point's neighbors agree on (agree_on_creases) show.
SamplePlaces find_sample_places(std::span<const Vec3> points, const Neighborhoods& neighborhoods,
                                const Spacing& spacing, const VerdictRows& agreed, double noise);

/// Without the edges that are not likely enough to pass the place their point was sampled at.
VerdictRows drop_passed_by(std::span<const Vec3> points, const Spacing& spacing,
                           const SamplePlaces& places, double noise, const VerdictRows& verdicts,
                           const Job& job = {});

}  // namespace spigolo
