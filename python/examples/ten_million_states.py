"""Ten million states of contact: 100,000 random materials and spectra, each under 100 pressures, on as many workers as there are.

    python ten_million_states.py FOLDER [SAMPLES]

Started again after it was killed, it continues.
"""

from __future__ import annotations

import sys
from typing import Any

import numpy as np
import truearea as ta

PRESSURES_PA = np.geomspace(1e5, 1e7, 100)
WAVEVECTORS_PER_M = 2 * np.pi / np.geomspace(1e-4, 1e-7, 31)


def samples(count: int) -> dict[str, Any]:
    """Draws steels, and surfaces whose Hurst exponent, roll-off and height are known within bounds."""
    numbers = np.random.default_rng(1)
    return {
        "youngs_modulus": numbers.normal(210e9, 5e9, count),
        "yield_strength": np.exp(numbers.normal(np.log(1e9), 0.2, count)),
        "hurst": numbers.uniform(0.6, 0.9, count),
        "rolloff": np.exp(numbers.uniform(np.log(5e-6), np.log(50e-6), count)),
        "rms_height": np.exp(numbers.normal(np.log(0.2e-6), 0.3, count)),
    }


class States:
    """States of the samples, an array element for each row; rows of one sample share its material and its asperities."""

    def __init__(self, drawn: dict[str, Any]) -> None:
        self.drawn = drawn

    def __call__(self, sample: Any, pressure: Any) -> dict[str, Any]:
        distinct, index = np.unique(sample, return_inverse=True)
        materials = np.empty(len(distinct), dtype=object)
        asperities = np.empty((3, len(distinct)))
        for at, number in enumerate(distinct):
            of = {name: values[number] for name, values in self.drawn.items()}
            materials[at] = ta.Material(of["youngs_modulus"], 0.3, yield_strength=of["yield_strength"])
            level = np.maximum(WAVEVECTORS_PER_M * of["rolloff"] / (2 * np.pi), 1.0) ** (-1.0 - 2.0 * of["hurst"])
            shape = ta.Spectrum(WAVEVECTORS_PER_M, level).moments()
            # Heights scale with the root of the spectrum.
            scale = of["rms_height"] / np.sqrt(shape.m0_m2[-1])
            asperities[:, at] = shape.radius_m[-1] / scale, shape.density_per_m2[-1], shape.sigma_s_m[-1] * scale
        radius, density, sigma_s = asperities[:, index]
        found = ta.contact(
            model="ep-sphere", material=materials[index], radius=radius, density=density, sigma_s=sigma_s, pressure=pressure
        )
        return {"area_fraction": found.area_fraction, "separation_m": found.separation_m, "error": found.error_estimate}


def main(folder: str, count: int) -> None:
    """Fills the folder, and prints the quantiles of the area under the smallest and the largest pressure."""
    import pandas as pd
    from distributed import Client, LocalCluster

    axes = {"sample": np.arange(count), "pressure": PRESSURES_PA}
    # On a cluster under Slurm or Kubernetes: dask_jobqueue.SLURMCluster or dask_kubernetes.operator.KubeCluster. Its workers
    # write into the folder, which they must share.
    with LocalCluster(n_workers=2, threads_per_worker=1) as cluster, Client(cluster) as client:
        ta.sweep(States(samples(count)), axes, folder, client, vectorised=True)
    for pressure in PRESSURES_PA[[0, -1]]:
        areas = pd.read_parquet(folder, columns=["area_fraction"], filters=[("pressure", "==", pressure)])["area_fraction"]
        low, median, high = areas.quantile([0.025, 0.5, 0.975])
        print(f"{pressure:.3g} Pa: {median:.4f} of the area touches, 95 %: {low:.4f} to {high:.4f}")


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 100_000)
