# SPDX-License-Identifier: BSD-3-Clause
"""mpmath's quad. Reads lines of id family digits u m t K (a = 1; decimals), writes id, value,
evaluations, seconds for a value (of the processor, median of the repeats). The first argument is
the method: tanh-sinh or gauss-legendre. The substitutions are those of the other programs:
s^2 = x^2 + w^2, or s = t/cos(phi)."""
import statistics
import sys
import time

import mpmath
from mpmath import mp, mpf

method = sys.argv[1] if len(sys.argv) > 1 else "tanh-sinh"
enough = float(sys.argv[2]) if len(sys.argv) > 2 else 5e-3
count = 0


def pressure(family, u, m, t, K):
    x = 1 - u

    def below(phi):
        global count
        count += 1
        c, s = mpmath.cos_sin(phi)
        return phi * s / (c * c * mpmath.sqrt(t * t - x * x * c * c))

    def flat(w):
        global count
        count += 1
        return mpmath.acos(t / mpmath.sqrt(x * x + w * w))

    def power(w):
        global count
        count += 1
        return (x * x + w * w) ** ((m - 1) / 2)

    if family == "flat" and x < t:
        return K * t * t / mp.pi * mpmath.quad(below, [0, mpmath.acos(t)], method=method)
    end = mpmath.sqrt(u * (2 - u))
    f = flat if family == "flat" else power
    return K / mp.pi * mpmath.quad(f, [0, end], method=method)


for line in sys.stdin:
    id_, family, digits, *numbers = line.split()
    mp.dps = int(digits) + 3
    u, m, t, K = map(mpf, numbers)
    try:
        pressure(family, u, m, t, K)  # computes the nodes
        times = []
        while not times or (sum(times) < enough and len(times) < 32):
            count = 0
            begun = time.process_time()
            p = pressure(family, u, m, t, K)
            times.append(time.process_time() - begun)
        print(id_, mpmath.nstr(p, int(digits) + 3), count, statistics.median(times), flush=True)
    except (ArithmeticError, ValueError, TypeError) as error:
        print(id_, "none", error, flush=True)
