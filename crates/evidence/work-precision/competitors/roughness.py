"""Roughness parameters of measured maps, ours beside those of surfalize.

    roughness.py PROGRAM FOLDER

PROGRAM is the command line `truearea`, FOLDER has the five maps. Both subtract the least-squares plane. surfalize gets the heights
as SurfaceTopography reads them, so that neither reader is ours; it needs a height at every point, and takes the nearest one where
there is none. Prints a row for each map and parameter, and on stderr how surfalize's own reader differs.
"""
import csv
import io
import pathlib
import subprocess
import sys
import warnings

import numpy

MAPS = ["plu-1.plu", "sur-2.sur", "metropro-1.dat", "opd-1.opd", "gain_control_uncd_35_z03tr3R.001"]
PARAMETERS = (
    ["Sa", "Sq", "Ssk", "Sku", "Sp", "Sv", "Sz", "Sdq", "Sdr", "Sal", "Str"]
    + ["Sk", "Spk", "Svk", "Smr1", "Smr2", "Vmp", "Vmc", "Vvc", "Vvv"]
)
NAMES = {"Smr1": "Smrk1", "Smr2": "Smrk2"}
"""Names of surfalize that differ from ours."""
UNITS = {"um": 1.0, "um3/um2": 1.0, "1": 1.0, "%": 1.0, "": 1.0}
"""Units of ours over those of surfalize."""


def read(path):
    """The map for surfalize, and the number of points without a height."""
    from surfalize import Surface
    from SurfaceTopography import open_topography

    topography = open_topography(str(path)).topography().to_unit("um")
    heights = numpy.ma.filled(numpy.ma.masked_array(topography.heights()), numpy.nan).T
    steps = [length / points for length, points in zip(topography.physical_sizes, topography.nb_grid_pts)]
    return Surface(heights, *steps), int(numpy.isnan(heights).sum())


def compare_readers(path, surface):
    """Say on stderr how the heights of surfalize's own reader differ."""
    from surfalize import Surface

    try:
        other = Surface.load(path)
    except Exception as error:  # Whatever a library raises for a file that it cannot read.
        print(f"# {path.name}: surfalize reads no such file: {type(error).__name__}", file=sys.stderr)
        return
    ratio = numpy.nanmedian(abs(other.data)) / numpy.nanmedian(abs(surface.data))
    scaled = other.data / ratio - surface.data
    points = int((abs(scaled) > 1e-3 * numpy.nanstd(surface.data)).sum())
    print(f"# {path.name}: surfalize reads heights {ratio:.6g} times as large, and {points} that differ", file=sys.stderr)


def ours(program, path):
    """Values by parameter, in the units of surfalize."""
    told = subprocess.run([program, "roughness", path], check=True, capture_output=True, text=True)
    rows = csv.DictReader(line for line in io.StringIO(told.stdout) if not line.startswith("#"))
    return {row["parameter"]: number(row["value"]) * UNITS[row["unit"]] for row in rows}


def number(text):
    return float(text) if text else numpy.nan


def theirs(surface, name):
    try:
        value = getattr(surface, NAMES.get(name, name))()
        return float(numpy.asarray(value))
    except Exception as error:  # Whatever a library raises where it has no answer.
        print(f"# {name}: {type(error).__name__}: {error}", file=sys.stderr)
        return numpy.nan


def main():
    warnings.simplefilter("ignore")
    program, folder = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    print("map,missing_points,parameter,truearea,surfalize,difference")
    for name in MAPS:
        path = next(folder.rglob(name))
        surface, missing = read(path)
        compare_readers(path, surface)
        surface = surface.fill_nonmeasured().level()
        own = ours(program, path)
        for parameter in PARAMETERS:
            other = theirs(surface, parameter)
            difference = own[parameter] / other - 1 if other else numpy.nan
            print(f"{name},{missing},{parameter},{own[parameter]:.7g},{other:.7g},{difference:.1e}", flush=True)


if __name__ == "__main__":
    main()
