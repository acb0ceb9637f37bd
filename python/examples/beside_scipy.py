"""The four statistical models by `four_models_in_scipy` and by `truearea.contact`: time and error.

Prints the table of docs/python/beside-scipy.md. The references have 20 digits.
"""

import csv
import time
import warnings
from pathlib import Path
from typing import cast

import four_models_in_scipy as scipy_script
import numpy as np

import truearea as ta
from truearea._choices import StatisticalModel

REFERENCE = Path(__file__).resolve().parents[2] / "tests" / "reference" / "statistical_many.csv"
LAWS = {
    "hertz": scipy_script.hertz,
    "ep-sphere": scipy_script.ep_sphere,
    "elastic-sine": scipy_script.elastic_sine,
    "ep-sine": scipy_script.ep_sine,
}
COLUMNS = ("youngs_modulus_pa", "poisson_ratio", "yield_strength_pa", "radius_m", "density_per_m2", "sigma_s_m")


def rows_of(model: str) -> list[dict[str, float]]:
    """The rows of a model without a strain gradient that a careful script can be asked: separations of -4 to 10 sigma."""
    lines = [line for line in REFERENCE.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    chosen = [row for row in csv.DictReader(lines) if row["model"] == model and not row["strain_gradient_length_m"]]
    names = (*COLUMNS, "separation_m", "pressure_pa", "area_fraction")
    rows = [{name: float(row[name]) for name in names} for row in chosen]
    return [row for row in rows if -4.0 < row["separation_m"] / row["sigma_s_m"] < 10.0]


def by_scipy(model: str, rows: list[dict[str, float]]) -> tuple[np.ndarray, float]:
    found, begun = [], time.perf_counter()
    for row in rows:
        law = LAWS[model](*(row[name] for name in COLUMNS[:5]))
        try:
            found.append(scipy_script.at_pressure(law, row["sigma_s_m"], row["pressure_pa"])[1])
        except (ValueError, OverflowError, ZeroDivisionError):
            found.append(np.nan)
    return np.array(found), time.perf_counter() - begun


def by_truearea(model: str, rows: list[dict[str, float]]) -> tuple[np.ndarray, float]:
    column = {name: np.array([row[name] for row in rows]) for name in rows[0]}
    begun = time.perf_counter()
    materials = [ta.Material(row["youngs_modulus_pa"], row["poisson_ratio"], yield_strength=row["yield_strength_pa"]) for row in rows]
    states = ta.contact(
        model=cast(StatisticalModel, model),
        material=materials,
        radius=column["radius_m"],
        density=column["density_per_m2"],
        sigma_s=column["sigma_s_m"],
        pressure=column["pressure_pa"],
        tolerance=1e-10,
    )
    return states.area_fraction, time.perf_counter() - begun


def main() -> None:
    warnings.simplefilter("ignore")
    ta.set_threads(1)
    print("| model | states | scipy: a state | median error | largest | no answer | truearea: a state | median error | largest | no answer | times faster |")
    print("|---|---|---|---|---|---|---|---|---|---|---|")
    for model in LAWS:
        rows = rows_of(model)
        exact = np.array([row["area_fraction"] for row in rows])
        cells = []
        seconds = []
        for how in (by_scipy, by_truearea):
            found, spent = how(model, rows)
            error = np.abs(found / np.minimum(exact, 1.0) - 1.0)
            answered = error[~np.isnan(error)]
            cells += [f"{spent / len(rows) * 1e6:.3g} us", f"{np.median(answered):.1e}", f"{answered.max():.1e}"]
            cells.append(str(int(np.isnan(error).sum())))
            seconds.append(spent)
        print(f"| {model} | {len(rows)} | {' | '.join(cells)} | {seconds[0] / seconds[1]:.0f} |")


if __name__ == "__main__":
    main()
