"""Flow through a gap, point by point."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

import numpy as np

from truearea import _native
from truearea._boundary_elements import maps_of
from truearea._choices import FlowEdges
from truearea._material import Quantity
from truearea._notes import noted
from truearea._options import documented
from truearea._picture import Drawn
from truearea._progress import Progress, observed
from truearea._results import FloatArray, Result
from truearea._scan import file_of, given

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes


class GapFlow(Drawn, Result):
    """Flow through a gap under a mean pressure gradient along x, and under one along y.

    A flow factor is the flow over that through a parallel slot of the mean gap, 0 where no path leads through, and its error that by
    the spacing of the points, estimated from every second one; ``closed_fraction`` is the share of the points in contact, ``open_along_x`` and ``open_along_y`` are 1 or 0. ``flow_along_x`` and ``flow_along_y`` are the
    flow through each point over the mean flow, of shape (rows, columns, 2) with the components along x and y last.
    """

    _title = "flow through a gap"
    __slots__ = ()
    flow_factor_x: FloatArray
    flow_factor_y: FloatArray
    flow_factor_x_error: FloatArray
    flow_factor_y_error: FloatArray
    mean_gap_m: FloatArray
    closed_fraction: FloatArray
    open_along_x: FloatArray
    open_along_y: FloatArray
    residual: FloatArray
    iterations: FloatArray
    flow_along_x: FloatArray
    flow_along_y: FloatArray
    gap_m: FloatArray
    x_m: FloatArray
    y_m: FloatArray

    def _size_m(self) -> list[float]:
        steps = [float(self[name][1]) if len(self[name]) > 1 else 0.0 for name in ("x_m", "y_m")]
        return [(step or max(steps) or 1.0) * len(self[name]) for step, name in zip(steps, ("x_m", "y_m"))]

    def _draw(self, ax: Axes) -> Axes:
        from truearea._plot import draw_map

        with np.errstate(divide="ignore"):
            decades = np.log10(np.hypot(*np.moveaxis(self.flow_along_x, -1, 0)))
        decades = np.where(self.gap_m > 0.0, np.maximum(decades, -2.0), np.nan)
        ax.set_title("flow along x")
        return draw_map(ax, decades, tuple(self._size_m()), "log10 of the flow over its mean", "", "0.6")

    def _drawing(self) -> str:
        return _native.flow_picture("x", self.flow_along_x, self.gap_m, self._size_m())

    def _is_coordinate(self, name: str) -> bool:
        return name in ("x_m", "y_m")


@documented
def flow(
    gap: Any,
    *,
    size: Quantity | Sequence[Quantity] | None = None,
    edges: FlowEdges | None = None,
    unit: str | None = None,
    height_unit: str | None = None,
    channel: str | None = None,
    progress: Progress | None = None,
) -> GapFlow:
    """Solve the flow through a gap along x and along y by Reynolds' equation, div(g^3 grad p) = 0.

    Parameters
    ----------
    gap : array_like of float, shape (rows, columns), or Scan, topography or path
        Gaps in m; contact where they are not above 0, NaN or masked. Of a file the channel ``gap`` is read where it has one, as
        those of ``truearea bem --fields`` do.
    edges : {"periodic", "reservoirs", "channel"}, optional
        The gap repeats itself in both directions, as where left out; or one reservoir feeds a whole edge and one drains the opposite
        edge, and the gap repeats itself at its sides; or likewise with walls at the sides.
    unit, height_unit, channel : optional
        Of a path, as for ``read_scan``.

    Raises
    ------
    FileNotFoundError
        If the file does not exist.
    InputError
        With argument, value and bound.

    Examples
    --------
    >>> import numpy as np
    >>> import truearea as ta
    >>> x = np.linspace(0, 2 * np.pi, 64, endpoint=False)
    >>> found = ta.flow(1e-6 * (1 + 0.5 * np.cos(x)) * np.ones((64, 1)), size="1 mm", edges="periodic")
    >>> bool(found.flow_factor_x < 1 < found.flow_factor_y)
    True
    """
    arguments = {"edges": edges}
    reading = {"unit": unit, "height_unit": height_unit, "channel": channel}
    source: Any
    if isinstance(gap, (str, os.PathLike)):
        source = (*file_of(gap), given({"size": size, **reading}))
    else:
        idle = next((name for name, value in reading.items() if value is not None), None)
        if idle is not None:
            raise _native.InputError(f"{idle} has no effect on gaps that were read already, only on a path; leave it out")
        source = maps_of("gap", gap, size, True)
    with observed(progress) as observer:
        answer, beside = _native.flow_of_gap(source, arguments, observer)
    arrays: dict[str, Any] = {name: np.asarray(values).reshape(()) for name, values in answer.columns.items()}
    axes: dict[str, tuple[str, ...]] = dict.fromkeys(arrays, ())
    for name in ("flow_along_x", "flow_along_y", "gap_m"):
        arrays[name] = beside[name]
        axes[name] = ("row", "column", "component")[: beside[name].ndim]
    for name, axis, length_m in zip(("x_m", "y_m"), ("column", "row"), beside["size_m"]):
        count = arrays["gap_m"].shape[1 if axis == "column" else 0]
        arrays[name], axes[name] = np.arange(count) * (length_m / count), (axis,)
    return GapFlow(arrays, axes, noted(answer.notes))
