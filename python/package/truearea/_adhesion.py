"""Surfaces that attract each other, pressed or pulled apart point by point."""

from __future__ import annotations

from typing import Any

import numpy as np

from truearea import _native
from truearea._boundary_elements import press
from truearea._choices import Branch
from truearea._curves import Pressures
from truearea._grammar import AnyMaterial
from truearea._material import Quantity
from truearea._notes import noted
from truearea._options import FlatOptions, PressOptions, Unpack, with_options
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
    """Surfaces that attract each other, along the loads, along the branches where both are followed, and along the maps or surfaces.

    The area fraction counts points without a gap, and corrected is less the staircase; the repulsive one counts those under
    compression. Single numbers are ``fuller_tabor`` and ``pastewka_robbins`` of a spectrum, ``hysteresis_...`` where the branches
    differ most, and ``process_zone_points`` of a grid that is coarse.
    """

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
            Trace(self.nominal_pressure_pa, by_branch[:, at, surface], label if surface == 0 else "", condition=at)
            for at, label in enumerate(labels)
            for surface in range(by_branch.shape[2])
        )
        pulls = bool((self.nominal_pressure_pa <= 0.0).any())
        return Picture(self._title, "nominal_pressure_pa", "area_fraction", lines, marker="o", is_linear=pulls)


class PullOff(_AdhesiveStates):
    """Surfaces that are pulled apart step by step, along the states; ``realisation`` counts the surfaces where there are several.

    ``pull_off_...`` are those at the largest pull, the mean over the surfaces.
    """

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


@with_options(FlatOptions)
def adhesion(
    surface: Any,
    material: AnyMaterial,
    *,
    pressure: Pressures,
    work_of_adhesion: Quantity,
    adhesion_range: Quantity,
    branch: Branch = "apart",
    **options: Unpack[FlatOptions],
) -> AdhesiveContact:
    """Press surfaces that repeat themselves and attract each other by ``(w / rho) exp(-gap / rho)``, on a grid that resolves the process zone.

    Parameters
    ----------
    surface, material, tolerance : as for ``boundary_elements``
        The surfaces, the bodies in contact, and the residual at which the iteration stops.
    pressure : float, str, or sequence of them
        Nominal pressures, as for :func:`boundary_elements`; negative ones pull.
    branch : {"apart", "contact", "both"}, default "apart"
        History of the load: from first touch, which is usual, from full contact, or both, one behind the other.
    """
    arguments = {
        "pressure": pressure,
        "work_of_adhesion": work_of_adhesion,
        "adhesion_range": adhesion_range,
        "branch": branch,
        **options,
    }
    answer, beside, several = press(_native.press_adhesive, surface, material, arguments)
    columns = {name: np.asarray(values) for name, values in answer.columns.items()}
    numbers, of_states = columns.pop("realisation", None), columns.pop("branch")
    branches = list(dict.fromkeys(of_states.tolist()))
    surfaces = 1 if numbers is None else int(np.max(numbers, initial=1.0))
    # The core goes through the loads of one branch of one surface after the other.
    shape = (surfaces, len(branches), -1)
    along = {"load": 2, **({"branch": 1} if len(branches) > 1 else {}), **({} if numbers is None else {several: 0})}
    drop = tuple(axis for axis in range(3) if axis not in along.values())
    arrays, axes = _beside(beside, several)
    for name, values in columns.items():
        turned = values.reshape(shape).transpose((*along.values(), *drop))
        arrays[name], axes[name] = np.ascontiguousarray(turned.reshape(turned.shape[: len(along)])), tuple(along)
    arrays["nominal_pressure_pa"] = columns["nominal_pressure_pa"].reshape(shape)[0, 0].copy()
    axes["nominal_pressure_pa"] = ("load",)
    arrays["branch"] = np.array(branches if "branch" in along else branches[0])
    axes["branch"] = ("branch",) if "branch" in along else ()
    return AdhesiveContact(arrays, axes, noted(answer.notes))


@with_options(PressOptions)
def pull_off(
    surface: Any,
    material: AnyMaterial,
    *,
    work_of_adhesion: Quantity,
    adhesion_range: Quantity,
    periodic: bool | None = None,
    **options: Unpack[PressOptions],
) -> PullOff:
    """Pull surfaces apart that repeat themselves and attract each other, from contact until they part.

    Parameters
    ----------
    surface, material, tolerance : as for ``boundary_elements``
        The surfaces, the bodies in contact, and the residual at which the iteration stops.
    """
    arguments = {"work_of_adhesion": work_of_adhesion, "adhesion_range": adhesion_range, "pull_off": True, **options}
    arguments["periodic"] = periodic
    answer, beside, several = press(_native.press_adhesive, surface, material, arguments)
    columns = {name: np.asarray(values) for name, values in answer.columns.items()}
    arrays, axes = _beside(beside, several)
    return PullOff(columns | arrays, dict.fromkeys(columns, ("state",)) | axes, noted(answer.notes))


def _beside(beside: dict[str, Any], several: str) -> tuple[dict[str, AnyArray], dict[str, tuple[str, ...]]]:
    """Single numbers, and the gradient of each map, with their axes."""
    gradients = np.asarray(beside.pop("rms_gradient"))
    is_map = several == "map"
    arrays = {name: np.asarray(value, dtype=np.float64) for name, value in beside.items()}
    axes: dict[str, tuple[str, ...]] = {**dict.fromkeys(arrays, ()), "rms_gradient": ("map",) if is_map else ()}
    return {**arrays, "rms_gradient": gradients if is_map else gradients[0]}, axes
