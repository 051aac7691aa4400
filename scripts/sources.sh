#!/usr/bin/env bash
# Copyright 2026 The spigolo authors
# SPDX-License-Identifier: Apache-2.0
#
# scripts/sources.sh [FOLDER ...] - our C++ files below these folders, sorted; default: everywhere
set -euo pipefail

if (($# == 0)); then set -- src apps tests bench fuzz examples; fi
find "$@" -type f \( -name '*.h' -o -name '*.cpp' \) 2>/dev/null | LC_ALL=C sort
