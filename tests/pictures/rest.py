# SPDX-License-Identifier: MIT
"""Coins that come to rest against the laws of the end, (75)."""
import math

from forms import PI, near

E0, QUARTER0 = 0.1, PI/6
FLAT = 1e-6                       # where a coin lies down, by default (97)
UNIT = math.sqrt(0.01213/9.80665)
# Of each law: its size for the disc; a and b of a e^b = what is left of the
# time, over 1/size; c and d of Q = size c e^d near flat, where psi' is 2/sqrt(e).
LAWS = {"dry": (2e-6, 1/2, 3/2, 1, 0),
        "viscous": (2e-7, 3/16, 2, 2, -1/2),
        "layer": (1e-7, 1/(6*math.sqrt(2)), 9/4, 2*math.sqrt(2), -3/4),
        "gap": (2e-8, 1/8, 3, 2, -3/2),
        "rolling": (1e-3, 3/2, 1/2, 1, 1),
        "damping": (1e-3, 3/2, 1/2, None, None)}


def stops(law, size):
    """The angle at which a radian takes as much as there is, Q = e: the law of
    the end holds above.  Rolling and damping have none."""
    _, _, _, c, d = LAWS[law]
    return (size*c)**(1/(1 - d)) if c and d < 1 else 0


def ends(law, rows):
    """The angle at each time left: the law leaves out e^2, and in time the last
    fall, which from an angle e takes about sqrt(e).  Rolling, whose swing grows,
    rests up to 1.2 units later.  All lie down where e is FLAT."""
    size, a, b, *_ = LAWS[law]
    early = a*FLAT**b/size
    near(f"{law}, start", rows[0][2], E0, 1e-5*E0)
    for _, left, e, _, rate in rows:
        if law == "rolling" and e < E0/100:
            break                                        # it rattles, (76)
        if e < 1.1*FLAT:
            break                                        # it lies down
        want = ((left + early)*size/a)**(1/b)
        off = E0**2 + 2*math.sqrt(stops(law, size))/left/b
        if law == "rolling":
            off += 2*1.2/left
        near(f"{law}, angle", e/want, 1, off)
        near(f"{law}, contact", rate*math.sqrt(e)/2, 1, off)


def faces(law, rows):
    """The turn of the face: w_y = 2 e^(3/2) - wZ, wZ = 5/9 (e0^(3/2) - e^(3/2)),
    by dwZ/de; what is left out is of order e0^2."""
    for _, _, e, turn, _ in rows:
        near(f"{law}, face", turn, (23*e**1.5 - 5*E0**1.5)/9,
             2*E0**2*E0**1.5)


def rest(blocks):
    near("rest, blocks", len(blocks), 12, 0)
    for block, law in zip(blocks, [*LAWS, *LAWS], strict=True):
        near("rest, name", block[0][0].split()[1] == law, 1, 0)
    for law, block in zip(LAWS, blocks):
        ends(law, block)
        if law not in ("rolling", "damping"):
            faces(law, block)
    # The path of the lean and wZ is that of any contour law, to its end.  The
    # next order, e^(5/2), is a part of 0.02 below an angle of 0.06.
    turns = []
    for (law, (_, a, b, *_)), block in zip(LAWS.items(), blocks[6:]):
        near("quarter, angle", block[0][2], QUARTER0, 1e-4*QUARTER0)
        # Rolling, the worst law: 2.4e-3 at 1e-3; here it is 4.8e-3,
        # and the error is as its power 0.8.
        near("quarter, time", block[0][1], 8, 8*2.4e-3*4.8**0.8)
        # (42): wY^2 = sin/IX, and psi' = wY tan.
        near("quarter, contact", (block[0][4]*UNIT)**2,
             4*math.cos(QUARTER0)**2/math.sin(QUARTER0), 1e-3)
        size = a*QUARTER0**b/(8/UNIT)
        if law != "damping":
            turns += [turn*UNIT - 23/9*e**1.5 for _, _, e, turn, _ in block
                      if stops(law, size) < e < 0.06]
    near("quarter, ends", len(turns) > 20, 1, 0)
    for turn in turns:
        near("quarter, face", turn, turns[-1], 0.02*abs(turns[-1]))


def same_size(name, a, b):
    """Errors that are not rounding agree to a tenth."""
    if math.isnan(a) or math.isnan(b):
        near(name, math.isnan(a) and math.isnan(b), 1, 0)
    elif max(a, b) > 1e-9:
        near(name, a/b, 1, 0.1)


def fixed(fresh, kept):
    """A quarter's life: coin_settle() always rests, within 10 tol of a life of
    228 units; fixed steps have their order, and never rest."""
    last = {}
    for now, was in zip(fresh, kept, strict=True):
        method, setting, nine, late, end, how = now
        near("settle, row", was[:2] == now[:2] and was[-1] == how, 1, 0)
        for a, b in zip(now[2:5], was[3:6]):
            same_size(f"{method} {setting}", float(a), float(b))
        near("settle, end", (how == "rests") == (method == "settle"), 1, 0)
        if method == "settle":
            near("settle, rest", float(end), 0, 10*float(setting)*8)
        elif 1e-8 < float(late) < 1e-3:
            # Twice: by what is left of the next order.
            order = {"rk4": 4, "rk8": 8}[method]
            near(f"{method}, order", math.log2(last[method]/float(late)), order,
                 1)
        last[method] = float(late)
