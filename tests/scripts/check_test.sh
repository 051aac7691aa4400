#!/usr/bin/env bash
# Copyright 2026 The spigolo authors
# SPDX-License-Identifier: Apache-2.0
#
# tests/scripts/check_test.sh SCRATCH - the checkers accept a sound tree and name each fault of a bad
# one
set -euo pipefail
scripts=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../scripts" && pwd)
tree=$1
failures=0

# put FILE LINE ...: a source file with a proper head
put() {
  local file=$1
  shift
  mkdir -p "$(dirname "$tree/$file")"
  {
    echo '// Copyright 2026 The spigolo authors'
    echo '// SPDX-License-Identifier: Apache-2.0'
    echo '//'
    echo "// ${file#src/} - made up"
    if [[ $file == *.h ]]; then echo '#pragma once'; fi
    printf '%s\n' "$@"
  } >"$tree/$file"
}

# a tree that breaks no rule
sound_tree() {
  rm -rf "$tree"
  put src/spigolo/core/parallel.cpp '#include <tbb/parallel_for.h>' '#include <thread>'
  put src/spigolo/core/geometry.h '#include <vector>'
  put src/spigolo/detect/detect.cpp '#include "spigolo/core/geometry.h"' '#include <Eigen/Core>' \
    '#include "spigolo/gauss_map/gauss_map.h"  // std::thread is named in a comment only'
  put src/spigolo/index/search_simd.cpp '#include <hwy/highway.h>'
  put src/spigolo/render/png.cpp '#include <zlib.h>' '#include "spigolo/index/kd_tree.h"'
  put src/spigolo/spigolo.h '#include "spigolo/detect/detect.h"'
  put apps/main.cpp '#include <CLI/CLI.hpp>' '#include "spigolo/spigolo.h"'
  put tests/core/core_test.cpp '#include <gtest/gtest.h>' '#include <thread>'
  echo 'find_package(TBB REQUIRED)' >"$tree/CMakeLists.txt"
}

accepts() {
  local checker=$1 output
  if ! output=$("$scripts/$checker" "$tree" 2>&1) || [[ -n $output ]]; then
    echo "FAIL: $checker does not accept the sound tree: $output"
    failures=$((failures + 1))
  fi
}

# names CHECKER FILE WORDS: the tree as it is now is refused, for this file and with these words,
# and for nothing else
names() {
  local checker=$1 file=$2 words=$3 output
  if output=$("$scripts/$checker" "$tree" 2>&1); then
    echo "FAIL: $checker accepts $file ($words)"
    failures=$((failures + 1))
  elif [[ $output != "$file: "*"$words"* || $(wc -l <<<"$output") != 1 ]]; then
    echo "FAIL: $checker says of $file: $output"
    failures=$((failures + 1))
  fi
  sound_tree
}

# refuses FILE LINE WORDS: an include that must not be there
refuses() {
  put "$1" "$2"
  names check_includes.sh "$1" "$3"
}

sound_tree
accepts check_includes.sh
accepts check_files.sh

refuses src/spigolo/core/random.cpp '#include "spigolo/index/kd_tree.h"' "'index' is not below"
refuses src/spigolo/gauss_map/a.h '#include "spigolo/detect/detect.h"' "'detect' is not below"
refuses src/spigolo/io/ply.cpp '#include "spigolo/index/kd_tree.h"' "'index' is not below"
refuses src/spigolo/index/a.cpp '#include "spigolo/spigolo.h"' "'spigolo.h' is not below"
refuses src/spigolo/attic/a.cpp '#include "spigolo/core/error.h"' 'not on the ladder'
refuses src/spigolo/core/a.cpp '#include "tests/support/shapes.h"' 'inside src only'
refuses src/spigolo/core/a.cpp '  #  include "../../apps/a.h"' 'inside src only'
refuses src/spigolo/index/a.cpp '#include <tbb/parallel_for.h>' 'enters only through'
refuses src/spigolo/index/a.cpp '#include <hwy/highway.h>' 'enters only through'
refuses src/spigolo/detect/a.h '#include <Eigen/Core>' 'enters only through'
refuses src/spigolo/render/png.h '#include <zlib.h>' 'enters only through'
refuses src/spigolo/io/a.cpp '#include <nlohmann/json.hpp>' 'enters only through'
refuses src/spigolo/index/a.cpp '#include <nanoflann.hpp>' 'enters only through'
refuses apps/a.cpp '#include <CGAL/Surface_mesh.h>' 'enters only'
refuses src/spigolo/io/a.cpp '#include <thread>' 'threads start only'
refuses src/spigolo/io/a.cpp 'auto later = std::async(work);' 'threads start only'
refuses src/spigolo/index/a.cpp '#pragma omp parallel for' 'threads start only'

sed -i 1d "$tree/src/spigolo/core/geometry.h"
names check_files.sh src/spigolo/core/geometry.h 'no licence head'
sed -i 4d "$tree/src/spigolo/core/geometry.h"
names check_files.sh src/spigolo/core/geometry.h 'line 4 should be'
sed -i '/#pragma/d' "$tree/src/spigolo/core/geometry.h"
names check_files.sh src/spigolo/core/geometry.h 'no #pragma once'
yes '' | head -n 350 >>"$tree/apps/main.cpp" || true
names check_files.sh apps/main.cpp '356 lines'
echo 'find_package(CGAL REQUIRED)' >>"$tree/CMakeLists.txt"
names check_files.sh ./CMakeLists.txt "package 'CGAL'"

# figures of the documents against the results
sound_documents() {
  rm -rf "$tree"
  mkdir -p "$tree/docs" "$tree/scripts"
  printf '%s\n' '| box | 0.8374 | 1350 | 57939 | 0.74 |' >"$tree/docs/results.md"
  printf '%s\n' 'F1 is 0.837, of 57 939 points 1350; 84 % and 74 % of the edges. 10 000 points in 2022,' \
    'seed 1234, figure 127, (3.41), §3.7.5, `k 999`, hole17k, 1600x1200, [x](a/987.md).' '' \
    '    spigolo detect --k 345' '' '1. An item that goes on' '    with 0.84 in it.' >"$tree/docs/page.md"
  printf '%s\n' '```' 'took 4.567 s' '```' >"$tree/README.md"
}
# unknown LINE NUMBER: a line that names this number, which nobody has measured
unknown() {
  sound_documents
  echo "$1" >>"$tree/docs/page.md"
  names check_numbers.sh docs/page.md:8 "$2 is not in the results"
}

sound_documents
accepts check_numbers.sh
unknown 'F1 is 0.838.' 0.838
unknown 'Of 57 938 points.' 57938
unknown 'It finds 85 % of them.' '85 %'
unknown '    continued, .123 spacings.' .123
# with_entry ENTRY: an unknown number and a line of the list of exceptions
with_entry() {
  sound_documents
  echo 'Off by .123 spacings.' >>"$tree/docs/page.md"
  echo "$1" >"$tree/scripts/numbers.allow"
}
with_entry 'page.md .123 a constant'
accepts check_numbers.sh
with_entry '* .123 a constant'
accepts check_numbers.sh
with_entry 'other.md .123 a constant'
names check_numbers.sh docs/page.md:8 '.123'
with_entry '* .123'
names check_numbers.sh docs/page.md:8 '.123'
sound_documents
rm "$tree/docs/results.md"
names check_numbers.sh docs/results.md missing

if ((failures)); then exit 1; fi
rm -rf "$tree"
echo "every fault is named"
