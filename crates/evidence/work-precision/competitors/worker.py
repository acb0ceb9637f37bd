"""Answers questions about what an engine computes and how long that takes.

Reads one JSON object per line and writes one per line. Times are the shortest of
several repetitions, in seconds of the processor per state: calls that take
milliseconds are interrupted on any busy machine.
"""
import importlib.metadata
import json
import platform
import sys
import time

import numpy
import scipy

import engines
from laws import law_of

try:
    from ContactMechanics.ReferenceSolutions.GreenwoodTripp import Fn
except Exception as error:                     # an installation may fail in any way it likes
    Fn, MISSING = None, {"ContactMechanics": f"{type(error).__name__}: {error}"}
else:
    MISSING = {}


def greeting():
    versions = {"Python": platform.python_version(), "numpy": numpy.__version__, "scipy": scipy.__version__}
    for package in ("ContactMechanics", "SurfaceTopography", "tamaas"):
        try:
            versions[package] = importlib.metadata.version(package)
        except importlib.metadata.PackageNotFoundError:
            pass
    return {"versions": versions, "missing": MISSING}


def shortest(function, seconds):
    """The answer, and the shortest time of at least two calls, as many as fit into some seconds."""
    best, spent, calls, answer = float("inf"), 0.0, 0, None
    while calls < 2 or spent < seconds:
        start = time.process_time()
        answer = function()
        took = time.process_time() - start
        best, spent, calls = min(best, took), spent + took, calls + 1
    return answer, best


def row(numbers, seconds):
    return {"numbers": [float(number) for number in numbers], "seconds": seconds}


def prepared(case):
    law = law_of(case)
    law.found_breaks, law.fn = law.breaks(), Fn
    return law


def states(request):
    """One row per state asked for: separation over sigma, pressure, area fraction."""
    law = prepared(request["case"])
    engine, by_pressure = request["engine"], request["by_pressure"]
    setting, seconds = request["setting"], request["seconds"]
    if engine in engines.BATCHED:
        compute = engines.BATCHED[engine][by_pressure]
        asked = filled(request["at"])
        answer, took = shortest(lambda: compute(law, asked, setting), seconds)
        return [row([values[i] for values in answer], took / len(asked)) for i in range(len(request["at"]))]
    compute = engines.SINGLE[engine][by_pressure]
    return [row(*shortest(lambda: compute(law, at, setting), seconds)) for at in request["at"]]


def filled(at):
    """The states asked for, among as many others between them as make a batch."""
    others = numpy.linspace(min(at), max(at), engines.BATCH - len(at))
    return numpy.concatenate([at, others])


def kernel(request):
    """Pressure and area of one asperity: a number at a time, and as an array of a thousand."""
    law, s, seconds = law_of(request["case"]), request["at"], request["seconds"]
    many = numpy.full(1000, s)
    scalar, took = shortest(lambda: (law.pressure(s), law.area(s)), seconds)
    array, array_took = shortest(lambda: law.arrays(many), seconds)
    return [row(scalar, took), row([values[0] for values in array], array_took / len(many))]


def main():
    print(json.dumps(greeting()), flush=True)
    for line in sys.stdin:
        try:
            request = json.loads(line)
            answer = {"rows": kernel(request) if request["engine"] == "kernel" else states(request)}
        except Exception as error:             # reported as this engine's answer
            answer = {"error": f"{type(error).__name__}: {error}"}
        print(json.dumps(answer), flush=True)


if __name__ == "__main__":
    main()
