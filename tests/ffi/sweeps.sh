#!/bin/sh
# SPDX-License-Identifier: MIT
# sweeps.py, with the package installed in an environment of its own.
# From `make sweeps`: SRC OUT PYTHON.
set -eu
work=$OUT/ffi-sweeps
rm -rf "$work"
export PYTHONDONTWRITEBYTECODE=1
command -v mpirun >/dev/null || { echo "sweeps: needs mpirun" >&2; exit 1; }
"$PYTHON" -m venv --system-site-packages --without-pip "$work"
"$work/bin/python" -m pip -q --disable-pip-version-check install --no-index \
    --no-deps "$SRC/docs/examples/python"
"$work/bin/python" "$SRC/tests/ffi/sweeps.py" -q
