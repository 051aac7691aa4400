#!/usr/bin/env bash
# Copyright 2026 The spigolo authors
# SPDX-License-Identifier: Apache-2.0
#
# tests/scripts/oracle.sh CHECK.py PROGRAM SCRATCH - a check of this folder with the Python of
# ./dev test, or the system's
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
python=$here/../../build/oracles/bin/python
if [[ ! -x $python ]]; then python=$(command -v python3) || { echo "skipped: no python3"; exit 77; }; fi
exec "$python" "$here/$1" "${@:2}"
