"""Surfaces that attract each other, pressed or pulled apart point by point."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from truearea import _native
from truearea._notes import noted
from truearea._picture import Drawn, Picture, Trace
from truearea._results import AnyArray, FloatArray, Result


class _AdhesiveStates(Drawn, Result):
    """States of surfaces that attract each other, and the indicators of them."""

    __slots__ = ()
    nominal_pressure_pa: FloatArray
    branch: AnyArray
    area_fraction: FloatArray
    area_fraction_corrected: FloatArray
    repulsive_area_fraction: FloatArray
    mean_gap_m: FloatArray
    mean_attraction_pa: FloatArray
    largest_contact_pressure_pa: FloatArray
    residual: FloatArray
    rms_gradient: FloatArray
    process_zone_points: FloatArray
    fuller_tabor: FloatArray
    pastewka_robbins: FloatArray


class AdhesiveContact(_AdhesiveStates):
    """Surfaces that attract each other under loads, along the loads, along the branches where both are followed, and along the surfaces."""

    _title = "boundary elements with adhesion"
    __slots__ = ()
    hysteresis_pressure_pa: FloatArray
    hysteresis_apart_area_fraction: FloatArray
    hysteresis_contact_area_fraction: FloatArray

    def _picture(self) -> Picture:
        areas = np.asarray(self.area_fraction_corrected)
        branches = [str(branch) for branch in np.reshape(self.branch, -1)]
        by_branch = areas.reshape(len(areas), len(branches), -1)
        labels = branches if len(branches) > 1 else [""]
        lines = tuple(
            Trace(self.nominal_pressure_pa, by_branch[:, at, surface], label, condition=at)
            for at, label in enumerate(labels)
            for surface in range(by_branch.shape[2])
        )
        pulls = bool((self.nominal_pressure_pa <= 0.0).any())
        return Picture(self._title, "nominal_pressure_pa", "area_fraction", lines, marker="o", is_linear=pulls)


class PullOff(_AdhesiveStates):
    """Surfaces that are pulled apart step by step, along the states; ``realisation`` counts the surfaces where there are several."""

    _title = "pull-off"
    __slots__ = ()
    realisation: FloatArray
    pull_off_pressure_pa: FloatArray
    pull_off_mean_gap_m: FloatArray
    pull_off_area_fraction: FloatArray

    def _picture(self) -> Picture:
        surface = self.get("realisation", np.ones(len(self.mean_gap_m)))
        numbers = np.unique(surface)
        lines = tuple(
            Trace(
                self.mean_gap_m[surface == at],
                -self.nominal_pressure_pa[surface == at],
                f"surface {at:.0f}" if len(numbers) > 1 else "",
            )
            for at in numbers
        )
        return Picture(self._title, "mean_gap_m", "pull_pa", lines, marker=".", is_linear=True)


def adhesive_result(answer: _native.Answer, beside: Mapping[str, Any], several: str) -> AdhesiveContact | PullOff:
    """The states of a table, and single numbers beside them."""
    columns = {name: np.asarray(values) for name, values in answer.columns.items()}
    gradients = np.asarray(beside["rms_gradient"])
    arrays: dict[str, AnyArray] = {
        name: np.asarray(value, dtype=np.float64) for name, value in beside.items() if name != "rms_gradient"
    }
    axes: dict[str, tuple[str, ...]] = dict.fromkeys(arrays, ())
    arrays["rms_gradient"], axes["rms_gradient"] = (
        (gradients, ("map",)) if several == "map" else (gradients[0], ())
    )
    if "pull_off_pressure_pa" in beside:
        return PullOff(columns | arrays, dict.fromkeys(columns, ("state",)) | axes, noted(answer.notes))
    numbers, branch = columns.pop("realisation", None), columns.pop("branch")
    branches = list(dict.fromkeys(branch.tolist()))
    surfaces = 1 if numbers is None else int(np.max(numbers, initial=1.0))
    # The core goes through the loads of one branch of one surface after the other.
    shape = (surfaces, len(branches), -1)
    along = {"load": 2, **({"branch": 1} if len(branches) > 1 else {}), **({} if numbers is None else {several: 0})}
    drop = tuple(axis for axis in range(3) if axis not in along.values())
    states: dict[str, AnyArray] = {}
    for name, values in columns.items():
        turned = values.reshape(shape).transpose((*along.values(), *drop))
        states[name] = np.ascontiguousarray(turned.reshape(turned.shape[: len(along)]))
    of_states: dict[str, tuple[str, ...]] = dict.fromkeys(states, tuple(along))
    states["nominal_pressure_pa"] = columns["nominal_pressure_pa"].reshape(shape)[0, 0].copy()
    of_states["nominal_pressure_pa"] = ("load",)
    states["branch"] = np.array(branches if "branch" in along else branches[0])
    of_states["branch"] = ("branch",) if "branch" in along else ()
    return AdhesiveContact(states | arrays, of_states | axes, noted(answer.notes))
