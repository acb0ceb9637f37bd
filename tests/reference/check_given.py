"""Compare these formulas with an existing set of point tables.

For each output column the largest relative deviation is printed twice: with
the printed inputs read as doubles, and as exact decimals.
"""
import argparse
import pathlib

from mpmath import mp, mpf

from point_laws import TABLES
from tables import WORKING_DIGITS, as_decimal, as_double, read_table


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=pathlib.Path, help="folder of the given tables")
    arguments = parser.parse_args()
    mp.dps = WORKING_DIGITS
    for name, (inputs, outputs, function) in TABLES.items():
        rows = read_table(arguments.folder / (name + ".csv"))
        print(f"{name}: {len(rows)} rows")
        for label, read in (("doubles", as_double), ("decimals", as_decimal)):
            worst = dict.fromkeys(outputs, mpf(0))
            for row in rows:
                values = function(*(read(row[key]) for key in inputs))
                for key, value in zip(outputs, values):
                    given = mpf(row[key])
                    error = abs(value - given) / (abs(given) or 1)
                    worst[key] = max(worst[key], error)
            for key, error in worst.items():
                print(f"  {label:9s}{key:42s}{mp.nstr(error, 3)}")


if __name__ == "__main__":
    main()
