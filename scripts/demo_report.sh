#!/usr/bin/env bash
# Copyright 2026 The spigolo authors
# SPDX-License-Identifier: Apache-2.0
#
# scripts/demo_report.sh PROGRAM FOLDER - the page about what ./dev demo left in FOLDER
#
# Reads report.json (of detect --json), features.ply and features.png; writes report.html, which
# needs no other file.
set -euo pipefail

program=$1 out=$2
json=$(tr -d '\n' <"$out/report.json")

# number KEY [OBJECT]: the number behind "KEY", if OBJECT is named behind it
number() {
  local text=$json
  if [[ -n ${2:-} ]]; then text=${text#*\""$2"\"}; fi
  sed -nE 's/^[^"]*("[^"]*"[^"]*)*"'"$1"'" *: *(-?[0-9][0-9.eE+-]*).*/\2/p' <<<"$text"
}

# The made cloud knows the truth about each of its points: truth_feature is 1 where a point lies on
# a feature, truth_edge_distance is how far the nearest one is. Prints: features, found ones,
# labelled points that are none, and those of them farther than 1.5 spacings from any.
against_truth() {
  local table
  table=$(mktemp --suffix=.csv)
  "$program" convert "$out/features.ply" -o "$table" --quiet
  awk -F '[,;]' -v spacing="$(number spacing)" '
    NR == 1 { for (i = 1; i <= NF; i++) { gsub(/[" \r]/, "", $i); column[$i] = i } next }
    {
      sharp = $column["scalar_kind"] >= 1 && $column["scalar_kind"] <= 3
      real = $column["truth_feature"] == 1
      features += real
      found += real && sharp
      wrong += sharp && !real
      far += sharp && !real && $column["truth_edge_distance"] > 1.5 * spacing
    }
    END { print features + 0, found + 0, wrong + 0, far + 0 }' "$table"
  rm -f "$table"
}

row() { printf '<tr><td>%s</td><td class="n">%s</td></tr>\n' "$1" "$2"; }
share() { awk -v a="$1" -v b="$2" 'BEGIN { printf "%.1f %%", b ? 100 * a / b : 100 }'; }
seconds() { awk -v s="$(number "$1" seconds)" 'BEGIN { printf "%.3f s", s }'; }

page() {
  local features found wrong far kind
  read -r features found wrong far < <(against_truth)
  cat <<'HTML'
<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>spigolo demo</title>
<style>
body { font: 16px/1.5 sans-serif; max-width: 60em; margin: 2em auto; padding: 0 1em; color: #222; }
img { max-width: 100%; border: 1px solid #ccc; }
table { border-collapse: collapse; margin: .5em 0 1.5em; }
td, th { padding: .2em 1em .2em 0; border-bottom: 1px solid #ddd; text-align: left; }
td.n { text-align: right; font-variant-numeric: tabular-nums; }
</style></head><body>
<h1>spigolo: sharp features of a raw point cloud</h1>
<p>The cloud is the thesis's cube with a round hole, made without noise: bare coordinates, no normals
and no triangles. Every point was labelled from its neighbors alone.</p>
HTML
  echo "<p><img alt=\"the labelled cloud\" src=\"data:image/png;base64,$(base64 -w 0 \
    "$out/features.png")\"></p>"
  echo '<h2>What was found</h2><table>'
  row 'points' "$(number points)"
  for kind in surface edge corner tip border; do row "$kind" "$(number $kind counts)"; done
  echo '</table><h2>Against the truth</h2><table>'
  row 'points that lie on a feature' "$features"
  row 'of these, labelled' "$found ($(share "$found" "$features"))"
  row 'labelled, but on no feature' "$wrong"
  row 'of these, farther than 1.5 spacings from every feature' "$far"
  echo '</table><h2>Time</h2><table>'
  for kind in read index detect write total; do row "$kind" "$(seconds $kind)"; done
  cat <<'HTML'
</table><h2>The files</h2><table>
<tr><th>file</th><th>what it is</th><th>opens with</th></tr>
<tr><td>hole.ply</td><td>the cloud, with the truth in truth_feature and truth_edge_distance</td>
<td>CloudCompare, MeshLab</td></tr>
<tr><td>features.ply</td><td>the same points in the same order, coloured by label; in scalar_kind 0 is
surface, 1 edge, 2 corner, 3 tip, 4 border</td><td>CloudCompare (choose the scalar field), MeshLab</td></tr>
<tr><td>features.png</td><td>the picture above</td><td>any picture viewer</td></tr>
<tr><td>edges.dxf, edges.step, edges.json</td><td>its edges and corners as curves</td><td>any CAD
program</td></tr>
<tr><td>mesh.ply, mesh.png</td><td>the sharp triangle mesh and a picture of it</td><td>MeshLab, Blender</td></tr>
<tr><td>report.json</td><td>counts, parameters and seconds, for programs</td><td>any text editor</td></tr>
</table></body></html>
HTML
}

page >"$out/report.html.part"
mv "$out/report.html.part" "$out/report.html"
echo "open $out/report.html (the whole story, in any browser)"
echo "     $out/edges.step and edges.dxf (its edges, in a CAD program), $out/mesh.ply (the sharp mesh)"
echo "     $out/features.ply (the labelled points, in CloudCompare or MeshLab)"
