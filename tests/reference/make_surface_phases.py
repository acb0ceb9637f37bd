"""Random numbers of the waves of surfaces, by ChaCha with 8 rounds as Bernstein (2008) describes it, in plain Python.

    python3 make_surface_phases.py OUT
"""

import os
import struct
import sys

MASK = 0xFFFFFFFF


def quarter_round(x, a, b, c, d):
    for (p, q, r, turn) in ((a, b, d, 16), (c, d, b, 12), (a, b, d, 8), (c, d, b, 7)):
        x[p] = (x[p] + x[q]) & MASK
        x[r] ^= x[p]
        x[r] = ((x[r] << turn) | (x[r] >> (32 - turn))) & MASK


def block(key, stream, counter):
    start = list(struct.unpack("<4I", b"expand 32-byte k")) + list(struct.unpack("<8I", key))
    start += [counter & MASK, counter >> 32, stream & MASK, stream >> 32]
    x = list(start)
    for _ in range(4):
        for column in range(4):
            quarter_round(x, column, column + 4, column + 8, column + 12)
        for i in range(4):
            quarter_round(x, i, 4 + (i + 1) % 4, 8 + (i + 2) % 4, 12 + (i + 3) % 4)
    return [(a + b) & MASK for a, b in zip(x, start)]


def draw(seed, realisation, m, n):
    key = struct.pack("<QQ", seed, realisation) + b"truearea surface"
    stream = 2 * n if n >= 0 else -2 * n - 1
    words = block(key, stream, 4 * m // 16)
    low, high, low_share, high_share = words[4 * m % 16 : 4 * m % 16 + 4]
    unit = lambda low, high: ((high << 32 | low) >> 11) / 2**53
    return unit(low, high), unit(low_share, high_share)


WAVES = [(0, 1), (0, 2), (1, 0), (2, 0), (1, 1), (1, -1), (2, 1), (3, -2), (5, 4), (7, 0), (0, 7), (6, -3)]

with open(os.path.join(sys.argv[1], "surface_phases.csv"), "w") as out:
    out.write("# ChaCha8 of the seed, the realisation and the wave; see make_surface_phases.py\n")
    out.write("seed,realisation,wave_x,wave_y,turn,share\n")
    for seed, realisation in ((1, 0), (1, 7), (18446744073709551615, 3)):
        for m, n in WAVES:
            turn, share = draw(seed, realisation, m, n)
            out.write(f"{seed},{realisation},{m},{n},{turn!r},{share!r}\n")
