// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/claims.h - what README.md says, as rows that are read off the tables of the sections
#pragma once

#include "report.h"

namespace spigolo::bench {

/// Writes a section to `page`; nothing where the sections that it stands on are not in `body`.
void write_claims(Report& page, const Report& body);

}  // namespace spigolo::bench
