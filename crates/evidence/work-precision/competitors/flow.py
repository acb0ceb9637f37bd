"""Flow factors of ten fields, ours beside reynoldsflow's, to 1e-6.

    flow.py PROGRAM [POINTS]

PROGRAM is the example `flow_speed` of truearea-transport, built optimised:

    cargo build --release --package truearea-transport --example flow_speed

POINTS are those along a side, 256 if not given. Both programs solve the same equations: harmonic means of g^3 between neighbours,
contact impermeable, periodic in both directions under a mean gradient. The fields are Gaussian surfaces cut at a height, with a
gap that rises from the edge of contact as distance^1.5, and 2 to 40 % contact. reynoldsflow solves directly (SuperLU).
Exit status 1 if a factor differs by more than 1e-6 of itself.
"""
import csv
import pathlib
import subprocess
import sys
import tempfile
import time

import numpy
from reynoldsflow import transport

TOLERANCE = 1e-6


def gaps(points, closed, seed):
    wave = numpy.fft.fftfreq(points, 1 / points)
    q = numpy.hypot(wave[:, None], wave[None, :])
    noise = numpy.fft.fft2(numpy.random.default_rng(seed).normal(size=(points, points)))
    band = (q >= 4) & (q <= points / 8)
    heights = numpy.fft.ifft2(numpy.where(band, noise * numpy.maximum(q, 4) ** -1.8, 0)).real
    heights /= heights.std()
    return numpy.maximum(heights - numpy.quantile(heights, closed), 0) ** 1.5


def theirs(field):
    """Factor along the first axis, and the seconds of the solution."""
    start = time.process_time()
    filtered, _, flux = transport.solve_fluid_problem(
        field / field.mean(), boundary_mode="periodic", solver="scipy-spsolve"
    )
    seconds = time.process_time() - start
    if filtered is None:
        return 0.0, seconds
    return transport.compute_total_flux(filtered, flux, len(field), boundary_mode="periodic")[0], seconds


def main(program, points):
    transport.set_verbosity("error")
    transport.warmup_numba_functions()
    worst = 0.0
    print("field, share in contact, direction, ours, theirs, relative difference, our seconds of the processor, theirs")
    with tempfile.TemporaryDirectory() as folder:
        for seed, closed in enumerate(numpy.linspace(0.02, 0.4, 10)):
            field = gaps(points, closed, seed)
            path = pathlib.Path(folder) / f"{seed}.f64"
            path.write_bytes(field.astype("<f8").tobytes())
            lines = subprocess.run([program, path], check=True, capture_output=True, text=True).stdout.splitlines()
            rows = csv.DictReader(lines, skipinitialspace=True)
            for row, along in zip(rows, [field.T, field]):
                factor, seconds = theirs(numpy.ascontiguousarray(along))
                ours = float(row["flow factor"])
                off = abs(ours - factor) / factor if factor else float(ours != 0)
                worst = max(worst, off)
                print(
                    f"{seed}, {closed:.3f}, {row['direction']}, {ours:.9e}, {factor:.9e}, {off:.1e}, "
                    f"{row['seconds of the processor']}, {seconds:.2f}",
                    flush=True,
                )
    print(f"largest difference: {worst:.1e}")
    return int(worst > TOLERANCE)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 256))
