# SPDX-License-Identifier: MIT
"""librollcoin in Python: the motion of a coin on a table.

    import rollcoin as rc

    quarter = rc.disc(0.00567, 0.01213, 9.80665)    # kg, m, m/s^2
    s = rc.State(theta=0.3, wY=5, wZ=40)            # rad, rad/s
    rc.run(s, quarter, rc.RK8, 1e-2, 100)           # a second
    print(s.theta, rc.center(s, quarter))

coin.h is the reference; the last words of each docstring name the function
there.  Its structs are classes here (State, Params, ...), its constants lose
their COIN_, and its functions return what C writes through pointers.  A
negative status is raised as Error.

Many coins lie in a table: an array of numpy of dtype State, or of float64 with
8 columns, which is used where it is, without a copy.  What reads a coin reads
a table too: energy(table, quarter) is an array.

What coinf.h has in floats is called by the same names, with a Statef and the
Paramsf of discf(), ringf() or bodyf().

`lib` has every function of both headers by its own name, as ctypes calls it.
"""
from . import (_about, _declarations, _exact, _library, _make, _move, _read,
               _real, _tables)
from ._about import *
from ._declarations import *
from ._exact import *
from ._library import *
from ._make import *
from ._move import *
from ._read import *
from ._real import *
from ._tables import *

__version__: str = version()
__all__ = ["__version__"]
__all__ += _about.__all__
__all__ += _declarations.__all__
__all__ += _exact.__all__
__all__ += _library.__all__
__all__ += _make.__all__
__all__ += _move.__all__
__all__ += _read.__all__
__all__ += _real.__all__
__all__ += _tables.__all__
