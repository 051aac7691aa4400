#!/usr/bin/env python3
# Copyright 2026 The spigolo authors
# SPDX-License-Identifier: Apache-2.0
#
# tests/scripts/schema_oracle.py PROGRAM SCRATCH - the JSON of `spigolo lines` against its schema in
# docs, by a validator of others. Exit status 77 (skipped) where jsonschema is not installed.
import copy
import json
import subprocess
import sys
from pathlib import Path

SCHEMA = Path(__file__).resolve().parents[2] / "docs" / "lines.schema.json"
CLOUDS = {  # lines, circles and arcs; splines; borders; noise; nothing at all
    "hole17k": ["hole17k"],
    "cylinders": ["cylinders", "--sampling", "blue", "--points", "5000"],
    "patch": ["patch", "--sampling", "blue", "--points", "2000"],
    "noisy": ["star", "--sampling", "random", "--points", "5000", "--noise", "0.3"],
    "sphere": ["sphere", "--sampling", "blue", "--points", "2000"],
}


def lines_of(program, folder, name, options):
    cloud, table = folder / f"{name}.ply", folder / f"{name}.json"
    subprocess.run([program, "synth", *options, "-o", cloud, "--quiet"], check=True)
    subprocess.run([program, "lines", cloud, "-o", table, "--unit", "mm", "--quiet"], check=True)
    return json.loads(table.read_text())


def spoiled(network):
    """Copies of a network with one fault each: the schema must name them."""
    faults = [
        lambda n: n.pop("spacing"),
        lambda n: n.update(units="furlong"),
        lambda n: n["curves"][0].pop("polyline"),
        lambda n: n["curves"][0].update(polyline=[[0, 0]]),
        lambda n: n["corners"][0].update(valence=0),
        lambda n: n.update(more=1),
    ]
    for fault in faults:
        bad = copy.deepcopy(network)
        fault(bad)
        yield bad


def main():
    try:
        from jsonschema import Draft202012Validator
    except ImportError:
        print("skipped: jsonschema is not installed (./dev test installs it)")
        sys.exit(77)
    program, folder = sys.argv[1], Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    schema = json.loads(SCHEMA.read_text())
    Draft202012Validator.check_schema(schema)
    validator = Draft202012Validator(schema)
    for name, options in CLOUDS.items():
        network = lines_of(program, folder, name, options)
        validator.validate(network)
        print(f"{name}: {len(network['curves'])} curves, {len(network['corners'])} corners: valid")
        if name == "hole17k":
            for i, bad in enumerate(spoiled(network)):
                assert not validator.is_valid(bad), f"fault {i} is not seen"


main()
