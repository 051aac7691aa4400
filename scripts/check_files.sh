#!/usr/bin/env bash
# Copyright 2026 The spigolo authors
# SPDX-License-Identifier: Apache-2.0
#
# scripts/check_files.sh [ROOT] - licence heads, names in the first line, length, what is linked
set -euo pipefail
cd "${1:-$(dirname "${BASH_SOURCE[0]}")/..}"
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

longest=350  # lines a file
# All that CMake may look for: nothing here is under GPL or AGPL. bench/rivals is a project of its own
# that is not part of ours and not shipped.
packages=' TBB hwy Eigen3 ZLIB GTest CLI11 nlohmann_json benchmark nanoflann OpenCASCADE Python3 spigolo '

status=0
complain() { echo "$1: $2"; status=1; }

# check_head FILE COMMENT: the two lines of the licence, after '#!' if there is one
check_head() {
  local file=$1 comment=$2 head
  head=$(head -n 3 "$file" | grep -v '^#!' | head -n 2)
  [[ $head == "$comment Copyright "*" The spigolo authors
$comment SPDX-License-Identifier: Apache-2.0" ]] || complain "$file" "no licence head"
}

# A file of the library says its own name, so that it is found and stays true when moved.
check_name() {
  local file=$1 name=${1#src/}
  head -n 5 "$file" | grep -qE "^// $name( - .+)?\$" ||
    complain "$file" "line 4 should be '// $name - purpose'"
}

check_length() {
  local file=$1 lines
  lines=$(wc -l <"$file")
  if ((lines > longest)); then complain "$file" "$lines lines, more than $longest"; fi
}

while IFS= read -r file; do
  check_head "$file" //
  check_length "$file"
  if [[ $file == src/* ]]; then check_name "$file"; fi
  if [[ $file == *.h ]] && ! grep -qx '#pragma once' "$file" && [[ $file != *-inl.h ]]; then
    complain "$file" "no #pragma once"
  fi
done < <("$here/sources.sh")

while IFS= read -r file; do
  check_head "$file" '#'
  check_length "$file"
done < <(find dev .ci/run scripts cmake tests bench fuzz \
  \( -path dev -o -path .ci/run -o -name '*.sh' -o -name '*.cmake' \) -type f 2>/dev/null |
  LC_ALL=C sort)

while IFS=: read -r file package; do
  if [[ $packages != *" $package "* ]]; then
    complain "$file" "package '$package' is not on the list of scripts/check_files.sh"
  fi
done < <(find . \( -path ./build -o -path ./out -o -path ./.git -o -path ./bench/rivals \) -prune -o \
  \( -name CMakeLists.txt -o -name "*.cmake" -o -name "*.cmake.in" \) -type f -print0 |
  xargs -r -0 grep -HioE \
    '^[^#]*(find_(package|dependency)|pkg_(check|search)_modules?) *\( *[A-Za-z0-9_$]+' |
  sed -E 's/^([^:]*):.*\( */\1:/')

exit "$status"
