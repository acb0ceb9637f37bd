"""Boundary elements with an exponential attraction on one map, ours beside Tamaas, at the same residual.

    adhesion.py PROGRAM [POINTS] [CONTROLS]

PROGRAM is `adhesive_elements` of this package, built optimised; POINTS the points along a side, 512 if not given; CONTROLS
some of `gap,pressure`, the mean gap alone if not given.

Both solve the map of `boundary_elements.py`, with the attraction (w/rho) exp(-g/rho). Weak adhesion has w/rho = 0.05 E* h' and a
process zone l = E* rho^2/w of 16 spacings, strong adhesion 0.3 E* h' and 4 spacings. With `gap` the mean gap is held, with
`pressure` the load that belongs to this gap. Tamaas iterates on the gap, from its own start.

One script judges both from their gaps alone. The gradient r = K^-1(g + h) + s(g) + p, with the load p that makes its mean over
the open points vanish (with `pressure` the given one), has to be zero where the gap is open and not negative where it is closed;
the residual is the largest violation over the rms pressure of full contact. Each runs at the loosest of its tolerances that
brings this to 1e-7. Times are those of the processor on one thread, taken as in `boundary_elements.py`.
"""
import pathlib
import resource
import subprocess
import sys
import tempfile

# First, since it limits the threads of numpy.
from boundary_elements import of_processor, surface

import numpy

RESIDUAL = 1e-7
TOLERANCES = [10.0 ** (-6 - k / 2) for k in range(0, 7)]
CASES = {"weak": (0.05, 16), "strong": (0.3, 4)}
"""Attraction in contact over E* h', and process zone over the spacing."""
GAPS = [2.0, 1.0, 0.5]
"""Mean gaps over the rms height."""


def tractions(displacements):
    """Tractions without mean that make displacements, for a modulus of 1."""
    points = len(displacements)
    wave = 2 * numpy.pi * numpy.fft.fftfreq(points, 1 / points)
    q = numpy.hypot(wave[:, None], wave[None, : points // 2 + 1])
    return numpy.fft.irfft2(numpy.fft.rfft2(displacements) * q / 2, s=displacements.shape)


def judged(heights, gaps, work, rho, pressure=None):
    """The residual, the load and the share of closed points."""
    gradient = tractions(gaps + heights) + work / rho * numpy.exp(-gaps / rho)
    is_open = gaps > 0
    load = -gradient[is_open].mean() if pressure is None else pressure
    gradient += load
    worst = max(abs(gradient[is_open]).max(initial=0), -gradient[~is_open].min(initial=0))
    return worst / tractions(heights).std(), load, 1 - is_open.mean()


def ours(program, folder):
    def solve(heights, work, rho, control, value, tolerance):
        heights.astype("<f8").tofile(folder / "heights")

        def run(times):
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            numbers = [repr(float(number)) for number in (work, rho)]
            arguments = [program, folder / "heights", folder / "gaps", *numbers, control, repr(float(value)), repr(tolerance)]
            told = subprocess.run([*arguments, str(times)], check=True, capture_output=True, text=True).stdout
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            return told.split(), after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime

        (_, operators, *_), once = run(1)
        _, several = run(4)
        gaps = numpy.fromfile(folder / "gaps", "<f8").reshape(heights.shape)
        return gaps, (several - once) / 3, int(operators)

    return solve


def tamaas():
    import tamaas as tm

    tm.set_log_level(tm.LogLevel.error)

    def solve(heights, work, rho, control, value, tolerance):
        model = tm.Model(tm.model_type.basic_2d, [1.0, 1.0], list(heights.shape))
        model.E, model.nu = 1.0, 0.0
        kind = tm.PolonskyKeerRey
        solver = kind(model, heights, tolerance, kind.gap, getattr(kind, control))
        attraction = tm.ExponentialAdhesionFunctional(heights)
        attraction.parameters = {"rho": rho, "surface_energy": work}
        solver.addFunctionalTerm(attraction)
        solver.max_iter = 20000
        _, seconds = of_processor(lambda: solver.solve(value))
        return numpy.array(model["gap"]), seconds, None

    return solve


def loosest(solve, heights, work, rho, control, value):
    """The answer at the loosest tolerance that is good enough."""
    for tolerance in TOLERANCES:
        gaps, seconds, operators = solve(heights, work, rho, control, value, tolerance)
        residual, load, area = judged(heights, gaps, work, rho, value if control == "pressure" else None)
        if residual <= RESIDUAL:
            return seconds, residual, load, area, operators
    return None


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    points = int(sys.argv[2]) if len(sys.argv) > 2 else 512
    controls = sys.argv[3].split(",") if len(sys.argv) > 3 else ["gap"]
    heights = surface(points, shortest=points // 8, rolloff=points // 64)
    print("points,adhesion,control,gap_over_rms_height,engine,seconds,ratio,residual,load,area_fraction,operators")
    with tempfile.TemporaryDirectory() as folder:
        engines = {"truearea": ours(program, pathlib.Path(folder)), "tamaas": tamaas()}
        for case, (strength, zone) in CASES.items():
            rho = strength * zone / points
            work = strength * rho
            for gap in GAPS:
                load = None
                for control in controls:
                    own = None
                    for name, solve in engines.items():
                        value = load if control == "pressure" else gap * heights.std()
                        row = f"{points},{case},{control},{gap},{name}"
                        found = loosest(solve, heights, work, rho, control, value)
                        if found is None:
                            print(f"{row},,,,,,", flush=True)
                            continue
                        seconds, residual, load, area, operators = found
                        own = own or seconds
                        numbers = f"{seconds:.3f},{seconds / own:.2f},{residual:.1e},{load:.6e},{area:.6f}"
                        print(f"{row},{numbers},{operators or ''}", flush=True)


if __name__ == "__main__":
    main()
