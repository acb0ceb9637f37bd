"""Compare the statistical integrals with an existing table, row by row."""
import argparse
import multiprocessing
import pathlib

from mpmath import mp, mpf

from statistical import SCHEMES, evaluate, surface_from
from tables import WORKING_DIGITS, as_decimal, as_double, read_table


def deviations(row):
    result = []
    for read in (as_double, as_decimal):
        mp.dps = WORKING_DIGITS
        surface, d = surface_from(row, read)
        values = evaluate(row["model"], surface, d, SCHEMES[0])
        given = mpf(row["pressure_pa"]), mpf(row["area_fraction"])
        result.append([float(abs(v / g - 1)) for v, g in zip(values, given)])
    return result


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("table", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=1)
    arguments = parser.parse_args()
    rows = read_table(arguments.table)
    with multiprocessing.Pool(arguments.jobs) as pool:
        for row, (doubles, decimals) in zip(rows, pool.imap(deviations, rows)):
            print(f"{row['model']:13s}h*={row['strain_gradient_length_m'] or '-':12s}"
                  "doubles {:.1e} {:.1e}  decimals {:.1e} {:.1e}".format(*doubles, *decimals),
                  flush=True)


if __name__ == "__main__":
    main()
