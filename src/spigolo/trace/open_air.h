// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/open_air.h - curves end where there is no surface under them
#pragma once

#include <vector>

#include "spigolo/trace/shape_curve.h"
#include "spigolo/trace/survey.h"

namespace spigolo {

/// Stretches that were filled in or follow a form, but have no point of the cloud near them, are
/// cut out: there is no surface, so no crease. Curves without such stretches stay as they are.
void cut_open_air(RawNetwork& network, const Survey& survey, double scatter);

/// The same for drafts with members; samples: those they name. They keep their form.
void cut_open_air(std::vector<CurveDraft>& drafts, const Survey& survey,
                  std::span<const CreaseSample> samples, double window);

}  // namespace spigolo
