#!/usr/bin/env python3
# Copyright 2026 The spigolo authors
# SPDX-License-Identifier: Apache-2.0
#
# tests/scripts/curve_oracle.py PROGRAM SCRATCH - the curves of a shape as others read our files:
# DXF by ezdxf, STEP by the few lines of Part 21 here, VTP by an XML parser, each against our JSON.
# Two runs give the same bytes. Exit status 77 (skipped) where ezdxf is not installed.
import json
import math
import re
import subprocess
import sys
import xml.etree.ElementTree
from pathlib import Path

TOLERANCE = 1e-9  # of the extent of the curves
SHAPES = ["hole17k", "hole", "cylinders"]  # lines and circles; splines


def run(program, *arguments):
    subprocess.run([program, *map(str, arguments), "--quiet"], check=True)


def files_of(program, folder, shape, unit):
    """Two runs; the bytes of all files must be the same."""
    cloud = folder / f"{shape}.ply"
    options = ["--sampling", "blue"] if shape == "cylinders" else []
    run(program, "synth", shape, *options, "-o", cloud)
    runs = []
    for n in (1, 2):
        paths = [folder / f"{shape}-{n}.{ending}" for ending in ("dxf", "step", "json", "vtp")]
        outputs = [word for path in paths for word in ("-o", path)]
        run(program, "lines", cloud, *outputs, "--unit", unit, "--threads", n)
        runs.append(paths)
    for first, second in zip(*runs):
        assert first.read_bytes() == second.read_bytes(), f"{first.name} differs between two runs"
    return runs[0]


class Extent:
    def __init__(self, network):
        places = [p for curve in network["curves"] for p in curve["polyline"]]
        self.size = max(max(p) for p in zip(*places)) - min(min(p) for p in zip(*places))

    def same(self, a, b):
        return math.dist(a, b) <= TOLERANCE * self.size


def ours(network):
    """Curves as (kind, places and numbers that say all of it)."""
    curves = []
    for curve in network["curves"]:
        shape, poles = curve["shape"], curve["spline"]["poles"]
        if shape["type"] == "line":
            curves.append(("line", [curve["polyline"][0], curve["polyline"][-1]]))
        elif shape["type"] == "circle":
            curves.append(("circle", [shape["center"], [shape["radius"], 0, 0], shape["axis"]]))
        elif shape["type"] == "spline":
            knots = [[k, 0, 0] for k in curve["spline"]["knots"]]
            curves.append(("spline", poles + knots))
        else:
            raise AssertionError(f"a {shape['type']}, which no shape here has")
    return curves


def compare(wanted, found, extent, reader):
    assert len(wanted) == len(found), f"{reader}: {len(found)} curves instead of {len(wanted)}"
    left = list(found)
    for kind, numbers in wanted:
        match = next((f for f in left if f[0] == kind and len(f[1]) == len(numbers) and all(
            extent.same(a, b) for a, b in zip(f[1], numbers))), None)
        assert match, f"{reader}: no {kind} {numbers[:3]}"
        left.remove(match)


def from_dxf(path):
    import ezdxf
    from ezdxf.math import OCS

    document = ezdxf.readfile(path)
    errors = document.audit().errors
    assert not errors, f"ezdxf names {len(errors)} errors: {errors[0].message}"
    curves, corners = [], []
    for entity in document.modelspace():
        dxf = entity.dxf
        if entity.dxftype() == "POINT":
            assert dxf.layer == "CORNER", dxf.layer
            corners.append(list(dxf.location))
            continue
        assert dxf.layer in ("EDGE_CONVEX", "EDGE_CONCAVE", "EDGE_UNKNOWN", "BORDER"), dxf.layer
        if entity.dxftype() == "LINE":
            curves.append(("line", [list(dxf.start), list(dxf.end)]))
        elif entity.dxftype() == "CIRCLE":
            center = OCS(dxf.extrusion).to_wcs(dxf.center)
            curves.append(("circle", [list(center), [dxf.radius, 0, 0], list(dxf.extrusion)]))
        elif entity.dxftype() == "SPLINE":
            poles = [list(p) for p in entity.control_points]
            curves.append(("spline", poles + [[k, 0, 0] for k in entity.knots]))
        else:
            raise AssertionError(f"a {entity.dxftype()}")
    return curves, corners, document.header["$INSUNITS"]


class Step:
    """The instances of a Part 21 file, by number: name and the text of the arguments."""

    def __init__(self, path):
        text = path.read_text().replace("\n", "")
        data = text[text.index("DATA;") : text.rindex("ENDSEC;")]
        pattern = r"#(\d+)\s*=\s*([A-Z0-9_]*)\s*\((.*?)\);(?=#|\s|$)"
        self.rows = {int(n): (name, rest) for n, name, rest in re.findall(pattern, data)}

    def references(self, n):
        return [int(r) for r in re.findall(r"#(\d+)", self.rows[n][1])]

    def numbers(self, n):
        return [float(x) for x in re.findall(r"-?\d+\.\d*(?:E[+-]?\d+)?", self.rows[n][1])]

    def curve(self, n):
        name, rest = self.rows[n]
        if name == "TRIMMED_CURVE":
            basis, *ends = self.references(n)
            kind, numbers = self.curve(basis)
            if kind == "line":
                return "line", [self.numbers(end) for end in ends]
            return kind, numbers  # all round
        if name == "LINE":
            return "line", []
        if name == "CIRCLE":
            center, axis, _ = self.references(self.references(n)[0])
            return "circle", [self.numbers(center), [self.numbers(n)[-1], 0, 0], self.numbers(axis)]
        if name == "B_SPLINE_CURVE_WITH_KNOTS":
            poles = [self.numbers(p) for p in self.references(n)]
            lists = re.findall(r"\(([^()]*)\)", rest)
            counts, knots = [int(c) for c in lists[-2].split(",")], lists[-1].split(",")
            row = [[float(k), 0, 0] for k, c in zip(knots, counts) for _ in range(c)]
            return "spline", poles + row
        raise AssertionError(f"a {name}")

    def content(self):
        sets = [n for n, (name, _) in self.rows.items() if name == "GEOMETRIC_CURVE_SET"]
        members = [m for n in sets for m in self.references(n)]
        sets = [n for n, (name, _) in self.rows.items() if name == "GEOMETRIC_SET"]
        members += [m for n in sets for m in self.references(n)]
        points = [m for m in members if self.rows[m][0] == "CARTESIAN_POINT"]
        curves = [m for m in members if self.rows[m][0] not in ("CARTESIAN_POINT",)]
        return [self.curve(c) for c in curves], [self.numbers(p) for p in points]


def check_vtp(path, network):
    root = xml.etree.ElementTree.parse(path).getroot()
    assert root.tag == "VTKFile" and root.get("type") == "PolyData", root.tag
    piece = root.find("PolyData/Piece")
    assert int(piece.get("NumberOfLines")) == len(network["curves"])
    assert int(piece.get("NumberOfVerts")) == len(network["corners"])
    count = int(piece.get("NumberOfPoints"))
    for array in root.iter("DataArray"):
        if array.get("format") == "ascii" and array.get("Name") == "connectivity":
            assert all(0 <= int(i) < count for i in (array.text or "").split())


def check(program, folder, shape):
    dxf, step, table, vtp = files_of(program, folder, shape, "mm")
    network = json.loads(table.read_text())
    extent, curves = Extent(network), ours(network)
    corners = [[c["x"], c["y"], c["z"]] for c in network["corners"]]
    found, points, unit = from_dxf(dxf)
    assert unit == 4, f"$INSUNITS {unit} is not mm"
    compare(curves, found, extent, "DXF")
    compare([("corner", [c]) for c in corners], [("corner", [p]) for p in points], extent, "DXF")
    found, points = Step(step).content()
    compare(curves, found, extent, "STEP")
    compare([("corner", [c]) for c in corners], [("corner", [p]) for p in points], extent, "STEP")
    check_vtp(vtp, network)
    print(f"{shape}: {len(curves)} curves and {len(corners)} corners, the same in DXF, STEP and VTP")


def main():
    try:
        import ezdxf  # noqa: F401
    except ImportError:
        print("skipped: ezdxf is not installed (./dev test installs it)")
        sys.exit(77)
    program, folder = sys.argv[1], Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    for shape in SHAPES:
        check(program, folder, shape)


main()
