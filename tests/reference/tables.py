"""Reading numbers, writing reference tables."""
import csv

from mpmath import mp, mpf, nstr

DIGITS = 20          # significant digits printed
WORKING_DIGITS = 50  # significant digits carried


def as_double(text):
    """The exact value of the double that the decimal text rounds to."""
    return mpf(float(text))


def as_decimal(text):
    """The decimal text itself, to working precision."""
    return mpf(text)


def show(value):
    """Twenty significant digits; an empty cell for None; text passes through."""
    if value is None:
        return ""
    if isinstance(value, str):
        return value
    if isinstance(value, float):
        return repr(value)
    return nstr(value, DIGITS)


def read_table(path):
    """Rows as dicts of text; lines starting with '#' are comments."""
    with open(path, newline="") as handle:
        lines = [line for line in handle if not line.startswith("#")]
    return list(csv.DictReader(lines))


def write_table(path, comments, columns, rows):
    with open(path, "w", newline="") as handle:
        for comment in comments:
            handle.write("# " + comment + "\n")
        writer = csv.writer(handle, lineterminator="\n")
        writer.writerow(columns)
        for row in rows:
            writer.writerow([show(cell) for cell in row])


INPUT_NOTE = ("Inputs: every printed number is read as the nearest double (float(text)), "
              "and the exact value of that double is what enters the formulas.")
PRECISION_NOTE = ("Computed with mpmath at 50 significant digits, printed with 20.")


def condition_number(function, inputs):
    """Largest relative condition number over the outputs of ``function``.

    For each output: the sum over the inputs of |d ln out / d ln in|, by central
    differences with a relative step of 1e-18.  Outputs that are zero, and
    inputs that are zero, contribute nothing.
    """
    step = mpf(10) ** -18
    base = function(*inputs)
    totals = [mpf(0)] * len(base)
    for i, value in enumerate(inputs):
        if value == 0:
            continue
        up, down = list(inputs), list(inputs)
        up[i], down[i] = value * (1 + step), value * (1 - step)
        high, low = function(*up), function(*down)
        for j, out in enumerate(base):
            if out:
                totals[j] += abs((high[j] - low[j]) / (2 * step * out))
    return max(totals)
