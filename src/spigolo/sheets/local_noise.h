// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/local_noise.h - noise that differs from place to place
#pragma once

#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/sheets/sheet_cloud.h"

namespace spigolo {

/// Noise at each point [spacings of the point]: the residual of its own sheet where that holds the
/// whole neighborhood, else of the flattest half of it; lower quartile over the neighbors, a few
/// times over, so that edges do not count as noise, then the median of that over the neighbors.
std::vector<double> estimate_local_noise(const SheetCloud& cloud, const Job& job = {});

/// The few levels that a noise differing over the cloud is treated by, lowest first; one alone,
/// `of_cloud`, where it differs by less than a factor of about three or is too small to matter.
std::vector<double> noise_levels(const std::vector<double>& local, double of_cloud);

/// Whether noise_levels would find one level only, as far as that shows at a glance: nearly all
/// points have so little noise that it may count as none. false may mean either.
bool is_quiet(const SheetCloud& cloud, const Job& job = {});

/// Which of the levels (at least one, ascending) a noise is treated by: about the nearest by ratio.
std::size_t nearest_level(const std::vector<double>& levels, double noise);

}  // namespace spigolo
