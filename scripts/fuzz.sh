#!/usr/bin/env bash
# Copyright 2026 The spigolo authors
# SPDX-License-Identifier: Apache-2.0
#
# scripts/fuzz.sh BUILD SECONDS - runs every fuzz target of the build folder for that long
#
# fuzz/corpus/NAME and fuzz/regressions/NAME are where fuzz_NAME starts from; what it finds on the
# way stays in BUILD/corpus/NAME, and what breaks it is kept in fuzz/regressions/NAME.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

build=$1 seconds=$2

fuzz_one() {
  local target=$1 name found seeds log status=0
  name=$(basename "$target") name=${name#fuzz_}
  found=$build/corpus/$name seeds=fuzz/corpus/$name log=$build/$name.log
  mkdir -p "$found" "$seeds" "fuzz/regressions/$name"
  "$target" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -print_final_stats=1 \
    -artifact_prefix="fuzz/regressions/$name/" \
    "$found" "$seeds" "fuzz/regressions/$name" >"$log" 2>&1 || status=$?
  rmdir --ignore-fail-on-non-empty "$seeds" "fuzz/regressions/$name"
  if ((status == 0)); then
    echo "$name: sound after $(sed -n 's/^stat::number_of_executed_units: *//p' "$log") inputs"
  else
    echo "$name: BROKEN"
    grep -E 'ERROR: |SUMMARY: |Test unit written' "$log" || tail -n 20 "$log"
  fi
  return $((status != 0))
}
export build seconds
export -f fuzz_one

mapfile -t targets < <(find "$build/fuzz" -maxdepth 1 -type f -name 'fuzz_*' -executable | sort)
if ((${#targets[@]} == 0)); then echo "no fuzz targets in $build/fuzz" >&2; exit 1; fi
echo "${#targets[@]} targets, $seconds s each"
# shellcheck disable=SC2016  # expanded by the inner shell
printf '%s\n' "${targets[@]}" | xargs -d '\n' -n 1 -P "$(nproc)" bash -c 'fuzz_one "$1"' fuzz
