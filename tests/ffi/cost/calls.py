# SPDX-License-Identifier: MIT
"""As many steps as the second argument says, in the way that the first says:
"call", one call each; "run", one call of this module's run() each; "sample", a
state for each step, all in one call; "batch", a step of each of so many coins,
all in one call; the name of a function that reads a coin, one call of that for
so many."""
import sys

import rollcoin as rc

way, n = sys.argv[1], int(sys.argv[2])
p = rc.disc(0.00567, 0.01213, 9.80665)
s = rc.State(theta=0.3, wY=5, wZ=40)
if way == "call":
    step = rc.lib.coin_run
    for _ in range(n):
        step(s, p, rc.RK4, 1e-3, 1, None)
elif way == "run":
    for _ in range(n):
        rc.run(s, p, rc.RK4, 1e-3, 1)
elif way == "batch":
    rc.run_batch(bytearray(bytes(s) * n), p, rc.RK4, 1e-3, 1)
elif way != "sample":
    import numpy
    table = numpy.frombuffer(bytes(s) * n, rc.State)
    getattr(rc, way)(table, *([] if way == "quaternion" else [p]))
else:
    rc.sample(s, p, rc.RK4, 1e-3, 1, n)
