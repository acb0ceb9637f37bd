"""Opening an instrument file and its spectrum line by line, ours beside SurfaceTopography.

    scans.py PROGRAM FOLDER

PROGRAM is `truearea-work-precision`, built optimised, which has the command `scan`; FOLDER has the files. Both read the first channel, subtract
the least-squares plane and compute the spectrum of the rows without a window. Every reading has a process of its own;
its processor time counts in full, and beside it that of the calls alone, once Python and its packages are there. The
shortest of several counts. Differences are relative: of heights over their range, in the orientation that fits best, of
spectra over the value at the same wavelength.
"""
import multiprocessing
import pathlib
import resource
import subprocess
import sys
import tempfile
import time
import warnings

import numpy

FILES = {
    "di-4.di": "Nanoscope",
    "example_ps.tiff": "Park TIFF",
    "metropro-1.dat": "MetroPro",
    "mi-1.mi": "Molecular Imaging",
    "plu-1.plu": "Sensofar",
}
REPETITIONS = 5
LENGTHS = {"m": 1.0, "mm": 1e-3, "µm": 1e-6, "nm": 1e-9, "Å": 1e-10}


def ours(program, path, folder):
    outputs = [folder / "heights", folder / "spectrum"]
    best = float("inf")
    for _ in range(REPETITIONS):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        told = subprocess.run([program, "scan", path, *outputs], check=True, capture_output=True, text=True).stdout
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        best = min(best, after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime)
    columns, rows = (int(count) for count in told.split())
    heights, spectrum = (numpy.fromfile(output, "<f8") for output in outputs)
    return heights.reshape(rows, columns), spectrum, best


def read(path):
    """Heights in m, row by row, and spectrum in m^3."""
    from SurfaceTopography import open_topography

    topography = open_topography(str(path)).topography()
    level = topography.detrend("height")
    _, spectrum = level.power_spectrum_from_profile(window="boxcar", resampling_method=None, reliable=False)
    unit = LENGTHS[topography.unit]
    return topography.heights().T * unit, spectrum[1:] * unit**3


def theirs(path):
    """What is read, the time of this process with one reading, and the shortest time of further ones."""
    warnings.simplefilter("ignore")
    read(path)
    whole = time.process_time()
    best = float("inf")
    for _ in range(REPETITIONS):
        start = time.process_time()
        answer = read(path)
        best = min(best, time.process_time() - start)
    return *answer, whole, best


def difference_of_heights(ours, theirs):
    """The largest over the range, about the means, in the orientation that fits best."""
    if ours.shape != theirs.shape:
        return numpy.inf
    theirs = theirs - theirs.mean()
    turned = (ours - ours.mean(), ours[::-1] - ours.mean(), ours[:, ::-1] - ours.mean(), ours[::-1, ::-1] - ours.mean())
    return min(abs(heights - theirs).max() for heights in turned) / numpy.ptp(theirs)


def main():
    program, folder = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    print("format,points_x,points_y,seconds,their_seconds,their_call_seconds,heights_differ,spectra_differ")
    with tempfile.TemporaryDirectory() as scratch:
        for name, kind in FILES.items():
            path = folder / name
            heights, spectrum, seconds = ours(program, path, pathlib.Path(scratch))
            with multiprocessing.get_context("spawn").Pool(1) as process:
                their_heights, their_spectrum, whole, call = process.apply(theirs, [path])
            count = min(len(spectrum), len(their_spectrum))
            differ = [
                difference_of_heights(heights, their_heights),
                abs(spectrum[:count] / their_spectrum[:count] - 1).max(),
            ]
            numbers = [seconds, whole, call, *differ]
            rows, columns = heights.shape
            print(f"{kind},{columns},{rows}," + ",".join(f"{number:.2e}" for number in numbers), flush=True)


if __name__ == "__main__":
    main()
