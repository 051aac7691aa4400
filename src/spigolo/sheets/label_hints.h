// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/label_hints.h - what labels tell of the sheets of a noisy place
#pragma once

#include <vector>

#include "spigolo/sheets/sheet_model.h"
#include "spigolo/sheets/sheet_region.h"

namespace spigolo {

/// With so much noise labels, which neighbors have agreed on, may know more than a look does.
bool labels_help(double noise);

/// Planes on both sides of the creases that the region's edge points tell of, sure and near ones
/// first, each plane once. A start for SheetSeparator: what they do not explain they lose again.
LocalSheets sheets_of_labels(const SheetModel& model, const SheetRegion& region);

/// Only where labels were given: the crease points of the region's edge points, each with the two
/// sheets that cross nearest to it, along its direction. One far from every crossing pins nothing.
/// The weight is the samples' variance by the label's, which grows as its strength falls. Our own
/// verdicts come from the same samples as the sheets: as pins they would count those twice.
std::vector<CreasePin> pin_creases(const SheetModel& model, const SheetRegion& region,
                                   double noise);

}  // namespace spigolo
