"""Boundary elements on one map, ours beside what users have, at the same complementarity.

    boundary_elements.py PROGRAM [POINTS] [COMPETITORS]

PROGRAM is `truearea-work-precision`, built optimised, which has the command `press`; POINTS the points along a side,
512 if not given; COMPETITORS some of `tamaas,contactmechanics`, both if not given.

Everybody presses the same map: Gaussian, periodic over a square of side 1, 64 waves at the shortest
and a roll-off at 8, Hurst exponent 0.8, an rms gradient of 1, modulus 1. One script judges all
answers from their pressures alone: displacements are computed from these anew, and the residual is
the sum of p|g| over the sum of p times the rms height, gaps g being counted from their mean in contact. Each
is run at the loosest of its tolerances that brings this to 1e-8 (1e-6 for ContactMechanics, which gets no further).
Times are those of the processor, one thread; ours is the difference between runs that press once and several
times, so that it leaves out start-up and reading but has planning, laying out and writing the pressures; theirs is
the call that solves. Every solve has a process of its own, whose peak memory counts in full: interpreter and
libraries are part of what a user needs.
"""
import os

for threads in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ[threads] = "1"

import multiprocessing
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

import numpy

LOADS = [0.01, 0.03, 0.1, 0.5]
RESIDUAL = 1e-8
RESIDUAL_OF_CONTACT_MECHANICS = 1e-6
TOLERANCES = [10.0 ** (-7 - k / 4) for k in range(0, 17)]


def surface(points, shortest=64, rolloff=8, hurst=0.8, seed=1):
    """Heights with an rms gradient of 1 over a square of side 1."""
    wave = numpy.fft.fftfreq(points, 1 / points)
    q = numpy.hypot(wave[:, None], wave[None, :])
    noise = numpy.fft.fft2(numpy.random.default_rng(seed).normal(size=(points, points)))
    band = (q >= 1) & (q <= shortest)
    modes = numpy.where(band, noise / numpy.abs(noise) * numpy.maximum(q, rolloff) ** (-1 - hurst), 0)
    heights = numpy.fft.ifft2(modes).real
    power = numpy.abs(numpy.fft.fft2(heights)) ** 2
    return heights / (numpy.sqrt((power * (2 * numpy.pi * q) ** 2).sum()) / points**2)


def residual(heights, pressures):
    """Complementarity, the largest overlap over ten rms heights, and the share of points in contact."""
    points = len(heights)
    wave = 2 * numpy.pi * numpy.fft.fftfreq(points, 1 / points)
    q = numpy.hypot(wave[:, None], wave[None, : points // 2 + 1])
    q[0, 0] = numpy.inf
    gaps = numpy.fft.irfft2(numpy.fft.rfft2(pressures) * 2 / q, s=heights.shape) - heights
    touching = pressures > 1e-10 * pressures.mean()
    gaps -= gaps[touching].mean()
    rms = heights.std()
    balance = (pressures * numpy.abs(gaps))[touching].sum() / (pressures.sum() * rms)
    overlap = 0 if touching.all() else max(-gaps[~touching].min(), 0) / (10 * rms)
    return balance, overlap, touching.mean()


def of_processor(function):
    start = time.process_time()
    answer = function()
    return answer, time.process_time() - start


def peak_bytes():
    """Largest memory that this process has held; None where the system does not say."""
    status = pathlib.Path("/proc/self/status")
    lines = status.read_text().splitlines() if status.exists() else []
    return next((int(line.split()[1]) * 1024 for line in lines if line.startswith("VmHWM:")), None)


def ours(program, folder):
    def solve(heights, load, tolerance):
        heights.astype("<f8").tofile(folder / "heights")

        def run(times):
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            arguments = [program, "press", folder / "heights", folder / "pressures", str(load), str(tolerance), str(times)]
            told = subprocess.run(arguments, check=True, capture_output=True, text=True).stdout
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            return told.split(), after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime

        (iterations, operators, peak, *_), once = run(1)
        _, several = run(5)
        pressures = numpy.fromfile(folder / "pressures", "<f8").reshape(heights.shape)
        return pressures, (several - once) / 4, int(iterations), int(operators), int(peak)

    return solve


def tamaas(heights, load, tolerance):
    import tamaas as tm

    tm.set_log_level(tm.LogLevel.error)
    model = tm.Model(tm.model_type.basic_2d, [1.0, 1.0], list(heights.shape))
    model.E, model.nu = 1.0, 0.0
    solver = tm.PolonskyKeerRey(model, heights, tolerance)
    solver.max_iter = 20000
    _, seconds = of_processor(lambda: solver.solve(load))
    return numpy.array(model.traction), seconds, None, None, peak_bytes()


def contact_mechanics(heights, load, tolerance):
    from ContactMechanics import PeriodicFFTElasticHalfSpace, make_system
    from SurfaceTopography import Topography

    half_space = PeriodicFFTElasticHalfSpace(heights.shape, 1.0, (1.0, 1.0))
    surface = Topography(heights, (1.0, 1.0))
    system = make_system(interaction="hardwall", substrate=half_space, surface=surface)
    pentol = 100 * tolerance * heights.std()
    answer, seconds = of_processor(lambda: system.minimize_proxy(external_force=load, pentol=pentol))
    return numpy.asarray(answer.jac) * heights.size, seconds, int(answer.nit), None, peak_bytes()


def in_its_own_process(function):
    def solve(*arguments):
        with multiprocessing.get_context("spawn").Pool(1) as process:
            return process.apply(function, arguments)

    return solve


COMPETITORS = {
    "tamaas": (tamaas, RESIDUAL),
    "contactmechanics": (contact_mechanics, RESIDUAL_OF_CONTACT_MECHANICS),
}


def loosest(solve, enough, heights, load):
    """The answer at the loosest tolerance whose residual is small enough."""
    for tolerance in TOLERANCES:
        pressures, *costs = solve(heights, load, tolerance)
        balance, overlap, area = residual(heights, pressures)
        if balance <= enough:
            return balance, overlap, area, *costs
    return None


def row(found, own):
    """The cells of an answer: empty for what is unknown."""
    balance, overlap, area, seconds, iterations, operators, peak = found
    numbers = [f"{seconds:.3f}", f"{seconds / own:.2f}", f"{balance:.1e}", f"{overlap:.1e}", f"{area:.6f}"]
    return numbers + ["" if count is None else str(count) for count in (iterations, operators, peak)]


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    points = int(sys.argv[2]) if len(sys.argv) > 2 else 512
    wanted = sys.argv[3].split(",") if len(sys.argv) > 3 else list(COMPETITORS)
    heights = surface(points)
    columns = "seconds,ratio,residual,overlap,area_fraction,iterations,operators,peak_bytes"
    print(f"points,pressure_over_gradient,engine,{columns}")
    with tempfile.TemporaryDirectory() as folder:
        engines = {"truearea": (ours(program, pathlib.Path(folder)), RESIDUAL)}
        engines |= {name: (in_its_own_process(COMPETITORS[name][0]), COMPETITORS[name][1]) for name in wanted}
        for load in LOADS:
            own = None
            for name, (solve, enough) in engines.items():
                try:
                    found = loosest(solve, enough, heights, load)
                except ImportError as error:
                    print(f"{name} is missing: {error}", file=sys.stderr)
                    found = None
                if name == "truearea" and not found:
                    sys.exit(f"truearea does not come to a residual of {enough} at {load}")
                own = own or found[3]
                cells = row(found, own) if found else [""] * len(columns.split(","))
                print(",".join([str(points), str(load), name, *cells]), flush=True)


if __name__ == "__main__":
    main()
