"""The laws of one asperity in Python, a number at a time, and in numpy, a thousand at once.

    laws_of_one.py FOLDER

FOLDER has `sphere.csv` and `sinusoid_interference.csv`, whose values have 20 digits. Prints time and error of each law at
each row. Times are the shortest of several, in seconds of the processor per evaluation.
"""
import csv
import math
import pathlib
import sys
import time

import numpy

from laws import law_of

SECONDS = 1e-3
BATCH = 1000
LAWS = {
    "hertz": ("sphere.csv", "hertz_force_n", "hertz_area_m2"),
    "ep-sphere": ("sphere.csv", "jackson_green_force_n", "jackson_green_area_m2"),
    "elastic-sine": ("sinusoid_interference.csv", "pressure_elastic_pa", "area_fraction_elastic"),
    "ep-sine": ("sinusoid_interference.csv", "pressure_ep_pa", "area_fraction_ep"),
}


def shortest(function):
    best, spent, calls = float("inf"), 0.0, 0
    while calls < 2 or spent < SECONDS:
        start = time.process_time()
        answer = function()
        took = time.process_time() - start
        best, spent, calls = min(best, took), spent + took, calls + 1
    return answer, best


def asperity(model, row):
    """One asperity per square metre with a spread of one metre, so that pressure is force; sinusoids by their wavelength."""
    case = {**row, "model": model, "sigma_s_m": 1.0, "density_per_m2": 1.0}
    if "wavelength_m" in row:
        amplitude = row["aspect_ratio"] * row["wavelength_m"]
        case["density_per_m2"] = 2.0 / row["wavelength_m"]**2
        case["radius_m"] = (row["wavelength_m"] / math.tau)**2 / amplitude
    return law_of(case)


def relative(found, exact):
    return 0.0 if found == exact else abs(found / exact - 1)


def main():
    folder = pathlib.Path(sys.argv[1])
    rows = csv.writer(sys.stdout, lineterminator="\n")
    rows.writerow(["law", "program", "seconds", "error"])
    for model, (table, *exact) in LAWS.items():
        with open(folder / table) as file:
            lines = [{name: float(cell) for name, cell in row.items() if cell}
                     for row in csv.DictReader(line for line in file if not line.startswith("#"))]
        results = {"Python": [], f"numpy, each of {BATCH}": []}
        for row in lines:
            law, at = asperity(model, row), row["interference_m"]
            many = numpy.full(BATCH, at)
            one, took = shortest(lambda: (law.pressure(at), law.area(at)))
            arrays, array_took = shortest(lambda: law.arrays(many))
            for results_of, found, seconds in zip(results.values(), (one, [each[0] for each in arrays]),
                                                  (took, array_took / BATCH)):
                results_of.append((seconds, max(relative(a, row[b]) for a, b in zip(found, exact))))
        for program, found in results.items():
            rows.writerows([model, program, seconds, error] for seconds, error in found)


if __name__ == "__main__":
    main()
