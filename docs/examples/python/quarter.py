#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A US quarter rolls for a second: the same as quarter.c.

    python3 quarter.py
"""
import rollcoin as rc

p = rc.disc(0.00567, 0.01213, 9.80665)
s = rc.State(theta=0.3, wY=5, wZ=40)  # rad, rad/s

for tenth in range(1, 11):
    rc.run(s, p, rc.RK8, 1e-2, 10)
    print(f"{tenth / 10:.1f} s  lean {s.theta:.9f}  "
          f"centre ({s.x:.9f}, {s.z:.9f}) m")
print(f"energy {rc.energy(s, p):.9f} J, F/N {rc.reaction(s, p).ratio:.9f}")
