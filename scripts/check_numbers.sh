#!/usr/bin/env bash
# Copyright 2026 The spigolo authors
# SPDX-License-Identifier: Apache-2.0
#
# scripts/check_numbers.sh [ROOT] - figures of README.md and docs/*.md that docs/results.md and
# docs/rivals.md do not have
#
# Looked for is every number outside code that has three significant digits or a percent sign. It is
# found if some number of the results rounds to it; a percentage also if a share does (0.837 for 84 %).
# Zeros at the end of a whole number are not significant: 10 000 has one digit. What is no measurement
# (a default, a formula, a size of an input) stands in scripts/numbers.allow, with its reason: lines
# of 'PAGE NUMBER REASON', PAGE '*' for all.
set -euo pipefail
cd "${1:-$(dirname "${BASH_SOURCE[0]}")/..}"
allowed=scripts/numbers.allow

measured=()
for file in docs/results.md docs/rivals.md; do
  if [[ -e $file ]]; then measured+=("$file"); fi
done
if ((${#measured[@]} == 0)); then echo "docs/results.md: missing"; exit 1; fi

pages=(README.md)
for file in docs/*.md; do
  case $file in docs/results.md | docs/rivals.md | 'docs/*.md') ;; *) pages+=("$file") ;; esac
done

# POSIX awk. text_of: a line without what is never a measurement. next_number: takes the first
# number off `rest`.
awk -v allowed="$allowed" '
function text_of(line) {
  while (match(line, /[0-9] [0-9][0-9][0-9]([^0-9]|$)/))           # 57 939
    line = substr(line, 1, RSTART) substr(line, RSTART + 2)
  gsub(/`[^`]*`/, " ", line)
  gsub(/\]\([^)]*\)/, " ", line)                                    # targets of links
  gsub(/\([2-5]\.[0-9]+\)/, " ", line)                              # equations
  gsub(/§[0-9.]+( (to|and) §?[0-9.]+)?/, " ", line)
  gsub(/(Table|table|Figure|figure|Section|section|Step|step|Seed|seed)s? [0-9.]+((,| to| and|, and) [0-9.]+)*/, " ", line)
  gsub(/(19|20)[0-9][0-9]([^0-9.]|$)/, " ", line)                   # years
  gsub(/[A-Za-z_][A-Za-z_-]*[0-9][A-Za-z0-9_.-]*/, " ", line)       # hole17k, X3D-2
  gsub(/[0-9.]+[xX:\/][0-9.]+/, " ", line)                          # 1600x1200, 1/12
  return line
}
function next_number() {
  if (!match(rest, /[0-9]+(\.[0-9]+)?|\.[0-9]+/)) return ""
  found = substr(rest, RSTART, RLENGTH)
  rest = substr(rest, RSTART + RLENGTH)
  return found
}
function decimals_of(number) {
  return index(number, ".") ? length(number) - index(number, ".") : 0
}
function remember(number,   d, most) {
  most = decimals_of(number)
  for (d = 0; d <= most; ++d) known[sprintf("%.*f", d, number)] = 1
  if (number <= 1)
    for (d = 0; d + 2 <= most; ++d) known_share[sprintf("%.*f", d, 100 * number)] = 1
}
function significant(number) {
  if (index(number, ".")) sub(/\./, "", number)
  else sub(/0+$/, "", number)
  sub(/^0+/, "", number)
  return length(number)
}
function is_known(number, percent,   key) {
  key = sprintf("%.*f", decimals_of(number), number)
  return key in known || (percent && key in known_share)
}
FILENAME == allowed {
  if ($0 !~ /^#/ && NF >= 3) permitted[$1 " " $2] = 1
  next
}
FILENAME ~ /docs\/(results|rivals)\.md$/ {
  rest = $0
  while ((number = next_number()) != "") remember(number)
  next
}
FNR == 1 { fenced = 0; indented = 0; blank = 1; page = FILENAME; sub(/.*\//, "", page) }
/^ *```/ { fenced = !fenced; next }
{
  indented = /^    / && (blank || indented)  # else it continues an item of a list
  blank = /^ *$/
}
fenced || indented { next }
{
  rest = text_of($0)
  while ((number = next_number()) != "") {
    percent = rest ~ /^ ?(%|percent)/
    if (!percent && significant(number) < 3) continue
    if (("* " number) in permitted || (page " " number) in permitted) continue
    if (is_known(number, percent)) continue
    printf "%s:%d: %s%s is not in the results\n", FILENAME, FNR, number, percent ? " %" : ""
    status = 1
  }
}
END { exit status }
' "$(if [[ -e $allowed ]]; then echo "$allowed"; else echo /dev/null; fi)" "${measured[@]}" "${pages[@]}"
