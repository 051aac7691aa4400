#!/usr/bin/env bash
# Copyright 2026 The spigolo authors
# SPDX-License-Identifier: Apache-2.0
#
# scripts/check_includes.sh [ROOT] - dependencies point one way
#
# A room includes only rooms at or below it; a third-party header enters through its own door, never
# through a header that is installed (all of src but *-inl.h); only core/parallel.cpp has threads.
set -euo pipefail
cd "${1:-$(dirname "${BASH_SOURCE[0]}")/..}"
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

# room -> the rooms right below it, lowest first; what those stand on is allowed as well
ladder=(
  'core:'
  'io:core'
  'index:core'
  'cad:io'
  'sheets:index'
  'gauss_map:index'
  'detect:sheets gauss_map'
  'trace:detect'
  'mls:trace'
  'mesh:mls'
  'blend:cad mls'
  'pipeline:mesh blend'
  'tiles:pipeline'
  'synth:index'
  'measure:index'
  'render:index'
)

# prefix of a third-party header -> the files it may enter through
doors=(
  'tbb/|src/spigolo/core/parallel.cpp'
  'sanitizer/|src/spigolo/core/parallel.cpp'
  'zlib.h|src/spigolo/render/*.cpp src/spigolo/io/*.cpp tests/* fuzz/*'
  'OpenCASCADE/|src/spigolo/cad/*.cpp src/spigolo/cad/*-inl.h'
  'hwy/|src/*_simd.cpp src/*-inl.h'
  'Eigen/|src/*.cpp src/*-inl.h tests/* bench/*'
  'nanoflann.hpp|tests/* bench/*'
  'CLI/|apps/* tests/* bench/*'
  'nlohmann/|apps/* tests/* bench/*'
  'gtest/|tests/*'
  'gmock/|tests/*'
  'benchmark/|bench/*'
  'CGAL/|bench/rivals/*'
  'pcl/|bench/rivals/*'
  'malloc.h|bench/meter.cpp'
  'sys/|src/*.cpp apps/* tests/* bench/*'
  'unistd.h|src/*.cpp apps/* tests/* bench/*'
  'fcntl.h|src/*.cpp apps/* tests/* bench/*'
  'poll.h|src/spigolo/cad/cad_guard.cpp apps/* tests/* bench/*'
  'spawn.h|src/spigolo/cad/cad_guard.cpp tests/* bench/*'
)

status=0
complain() { echo "$1: $2"; status=1; }

declare -A below
close_ladder() {
  local row room lower
  for row in "${ladder[@]}"; do
    room=${row%%:*}
    below[$room]=" $room "
    for lower in ${row#*:}; do below[$room]+="${below[$lower]}"; done
  done
}

# check_ours FILE HEADER: a quoted include
check_ours() {
  local file=$1 header=$2 room other
  case $file in src/*) ;; *) return 0 ;; esac
  if [[ $header != spigolo/* ]]; then
    complain "$file" "\"$header\": inside src only \"spigolo/ROOM/FILE\" is included"
    return
  fi
  room=${file#src/spigolo/} room=${room%%/*}
  other=${header#spigolo/} other=${other%%/*}
  if [[ $file == src/spigolo/"$room" ]]; then return 0; fi  # the front door itself sees every room
  if [[ -z ${below[$room]:-} ]]; then
    complain "$file" "room '$room' is not on the ladder of scripts/check_includes.sh"
  elif [[ ${below[$room]} != *" $other "* ]]; then
    complain "$file" "\"$header\": '$other' is not below '$room'"
  fi
}

# check_door FILE HEADER: an include in angle brackets
check_door() {
  local file=$1 header=$2 door pattern
  if [[ $header == *.hxx ]]; then header=OpenCASCADE/$header; fi  # its headers have no folder
  if [[ $header != */* && $header != *.* ]]; then return 0; fi  # the C++ standard library
  if [[ $header == spigolo/* ]]; then
    if [[ $file == src/* ]]; then complain "$file" "<$header>: ours is included in quotes"; fi
    return 0
  fi
  for door in "${doors[@]}"; do
    if [[ $header != "${door%%|*}"* ]]; then continue; fi
    set -f
    for pattern in ${door#*|}; do
      # shellcheck disable=SC2053  # a pattern, on purpose
      if [[ $file == $pattern ]]; then set +f; return 0; fi
    done
    set +f
    complain "$file" "<$header> enters only through ${door#*|}"
    return
  done
  complain "$file" "<$header>: no door for this header in scripts/check_includes.sh"
}

close_ladder
while IFS=$'\t' read -r file bracket header; do
  if [[ $bracket == '<' ]]; then check_door "$file" "$header"; else check_ours "$file" "$header"; fi
done < <("$here/sources.sh" | xargs -r -d '\n' grep -HE '^[[:space:]]*#[[:space:]]*include' |
  sed -nE 's/^([^:]*):[[:space:]]*#[[:space:]]*include[[:space:]]*([<"])([^>"]*).*/\1\t\2\t\3/p')

while IFS= read -r line; do
  complain "${line%%:*}" "threads start only in src/spigolo/core/parallel.cpp: ${line#*:}"
done < <("$here/sources.sh" src apps | { grep -vx 'src/spigolo/core/parallel.cpp' || true; } |
  xargs -r -d '\n' grep -HE \
    '^[^/]*(std::(jthread|async|thread)\b|include *<(thread|future|omp\.h)>|# *pragma +omp|pthread_create)' || true)

exit "$status"
