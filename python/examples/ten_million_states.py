"""Ten million states of contact: 100,000 random materials and spectra, each under 100 pressures, on as many workers as there are.

    python ten_million_states.py FOLDER [SAMPLES]

Begun again after it was ended, it goes on where it was.
"""

from __future__ import annotations

import sys
from typing import Any

import numpy as np
import truearea as ta

PRESSURES_PA = np.geomspace(1e5, 1e7, 100)
WAVEVECTORS_PER_M = 2 * np.pi / np.geomspace(1e-4, 1e-7, 31)


def samples(count: int) -> dict[Any, Any]:
    """Steels with surfaces of which the Hurst exponent, the roll-off and the height are known within bounds."""
    numbers = np.random.default_rng(1)
    return {
        "youngs_modulus": numbers.normal(210e9, 5e9, count),
        "yield_strength": np.exp(numbers.normal(np.log(1e9), 0.2, count)),
        "hurst": numbers.uniform(0.6, 0.9, count),
        "rolloff": np.exp(numbers.uniform(np.log(5e-6), np.log(50e-6), count)),
        "rms_height": np.exp(numbers.normal(np.log(0.2e-6), 0.3, count)),
    }


def states(
    youngs_modulus: Any, yield_strength: Any, hurst: Any, rolloff: Any, rms_height: Any, pressure: Any
) -> dict[str, Any]:
    """A row for each state; neighbouring rows of one sample share its material and its asperities."""
    first = np.flatnonzero(np.r_[True, np.diff(youngs_modulus) != 0.0])
    index = np.repeat(np.arange(len(first)), np.diff(np.r_[first, len(youngs_modulus)]))
    materials = np.empty(len(first), dtype=object)
    asperities = np.empty((3, len(first)))
    for at, row in enumerate(first):
        materials[at] = ta.Material(youngs_modulus[row], 0.3, yield_strength=yield_strength[row])
        level = np.maximum(WAVEVECTORS_PER_M * rolloff[row] / (2 * np.pi), 1.0) ** (-1.0 - 2.0 * hurst[row])
        shape = ta.Spectrum(WAVEVECTORS_PER_M, level).moments()
        # Heights scale with the root of the spectrum.
        scale = rms_height[row] / np.sqrt(shape.m0_m2[-1])
        asperities[:, at] = shape.radius_m[-1] / scale, shape.density_per_m2[-1], shape.sigma_s_m[-1] * scale
    radius, density, sigma_s = asperities[:, index]
    found = ta.contact(
        model="ep-sphere", material=materials[index], radius=radius, density=density, sigma_s=sigma_s, pressure=pressure
    )
    return {"area_fraction": found.area_fraction, "separation_m": found.separation_m, "error": found.error_estimate}


def main(folder: str, count: int) -> None:
    """Fills the folder, and tells the quantiles of the area under the smallest and the largest pressure."""
    from distributed import Client, LocalCluster

    drawn = samples(count)
    over = {tuple(drawn): tuple(drawn.values()), "pressure": PRESSURES_PA}

    cluster = LocalCluster(n_workers=2, threads_per_worker=1)
    # On a cluster under Slurm, in place of the line above:
    #   from dask_jobqueue import SLURMCluster
    #   cluster = SLURMCluster(cores=1, memory="2 GB", walltime="01:00:00"); cluster.scale(100)
    # and under Kubernetes:
    #   from dask_kubernetes.operator import KubeCluster
    #   cluster = KubeCluster(name="truearea", image="IMAGE-WITH-TRUEAREA", n_workers=100)
    # Its workers write into the folder, so that it is to be one that they share.
    with cluster, Client(cluster) as client:
        frame = ta.sweep(states, over, vectorised=True, to=folder, client=client, progress=True)
        for pressure in PRESSURES_PA[[0, -1]]:
            areas = frame[frame["pressure"] == pressure]["area_fraction"].compute()
            low, median, high = areas.quantile([0.025, 0.5, 0.975])
            print(f"{pressure:.3g} Pa: {median:.4f} of the area touches, 95 %: {low:.4f} to {high:.4f}")


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 100_000)
