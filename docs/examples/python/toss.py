#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Ten thousand quarters are thrown in one call, by all processors: how many
show heads.  One processor takes some 7 s.

    python3 toss.py [COINS]
"""
import sys

import numpy
import rollcoin as rc

count = sys.argv[1] if len(sys.argv) > 1 else "10000"
if not count.isdigit() or int(count) < 1:
    sys.exit(f"toss.py: {count} coins, where 1 or more belong")
count = int(count)
p = rc.disc(0.00567, 0.01213, 9.80665)
table = rc.Table(mu_static=0.4, mu_kinetic=0.3, restitution=0.5)
table.losses.dry = 5e-3 * p.mass * p.gravity * p.radius

coins = numpy.zeros(count, rc.Body)
coins["y"] = 0.5  # m
coins["vy"] = 2  # m/s
coins["s"]["theta"] = 1  # tails up
coins["s"]["wX"] = 200 + numpy.arange(count) / 100  # rad/s
coins["s"]["wZ"] = 5
rc.move(coins, p, table, numpy.inf, 1e-6, workers=-1)
print(f"{(coins['s']['theta'] < 0).sum()} of {count} show heads")
