# SPDX-License-Identifier: MIT
"""Apart from _tables.py, as it imports numpy."""
from __future__ import annotations

from typing import Any

import numpy

from ._types import Plain


class Rows(numpy.ndarray[Any, Any]):
    """An array of numpy in which array[k] = coin sets a row."""

    def __setitem__(self, key: Any, value: Any) -> None:
        row = numpy.array(value)[()] if isinstance(value, Plain) else value
        super().__setitem__(key, row)  # type: ignore[no-untyped-call]
