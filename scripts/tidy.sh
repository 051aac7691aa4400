#!/usr/bin/env bash
# Copyright 2026 The spigolo authors
# SPDX-License-Identifier: Apache-2.0
#
# scripts/tidy.sh BUILD - clang-tidy over src and apps, as BUILD/compile_commands.json compiles them
#
# A file found clean is not looked at again until it, a header, or the set of checks changes:
# BUILD/tidy/ remembers the hash of all of them.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

build=$1
clean=$build/tidy
mkdir -p "$clean"
common=$( (clang-tidy --version; scripts/sources.sh src apps | grep '\.h$' |
  xargs -r -d '\n' cat .clang-tidy) | sha256sum)

# hash_of FILE: what its verdict depends on
hash_of() { (echo "$common"; cat "$1") | sha256sum | cut -c1-64; }

check_file() {
  local file=$1 stamp
  stamp=$clean/$(hash_of "$file")
  if [[ -e $stamp ]]; then return 0; fi
  # The flags are those of the compiler that builds, which may be gcc.
  if clang-tidy --quiet --extra-arg=-Wno-unknown-warning-option -p "$build" "$file" 2>"$stamp.log"; then
    touch "$stamp"
    rm -f "$stamp.log"
  else
    grep -v 'warnings\? generated\|warnings\? treated as error' "$stamp.log" >&2 || true
    rm -f "$stamp.log"
    return 1
  fi
}
export build clean common
export -f check_file hash_of

# Only what the build compiles: a file of an option that is off has no flags to be checked with.
# shellcheck disable=SC2016  # expanded by the inner shell
scripts/sources.sh src apps | grep '\.cpp$' | while IFS= read -r file; do
  if grep -qF "\"file\": \"$PWD/$file\"" "$build/compile_commands.json"; then echo "$file"; fi
done | xargs -r -d '\n' -n 1 -P "$(nproc)" bash -c 'check_file "$1"' tidy
