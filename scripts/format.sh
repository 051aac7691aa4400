#!/usr/bin/env bash
# Copyright 2026 The spigolo authors
# SPDX-License-Identifier: Apache-2.0
#
# scripts/format.sh [--check] - clang-format every C++ file, or say which ones need it
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

tool=$(command -v clang-format-14 || command -v clang-format)
if [[ ${1:-} != --check ]]; then
  scripts/sources.sh | xargs -r -d '\n' -n 8 -P "$(nproc)" "$tool" -i
  exit
fi
crooked=$(scripts/sources.sh | xargs -r -d '\n' "$tool" --dry-run 2>&1 |
  sed -nE 's/^([^: ]+):[0-9]+:[0-9]+: .*clang-format-violations.*/\1/p' | uniq)
if [[ -n $crooked ]]; then
  sed "s/\$/: not as $(basename "$tool") writes it; .\/dev format mends it/" <<<"$crooked"
  exit 1
fi
