// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/environment.h - what was measured and on what: versions, machine
#pragma once

#include "report.h"

namespace spigolo::bench {

/// Heading and table; no date and no path, so that runs on one machine differ in times only.
void environment(Report& report);

}  // namespace spigolo::bench
