"""Flow through gaps, of arrays and of files, and through pressed surfaces."""

from __future__ import annotations

import pickle
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
import numpy.typing as npt
import pytest

import truearea as ta
from support import refused_naming

matplotlib.use("agg")

GLASS = ta.Material("100 GPa", 0.0)
Floats = npt.NDArray[np.float64]


def rough(points: int = 48) -> Floats:
    """Heights [m] of waves of many directions that repeat themselves."""
    y, x = np.meshgrid(*2 * [2 * np.pi * np.arange(points) / points], indexing="ij")
    return 1e-8 * sum(
        (np.sin((n % 5 - 2) * x + (n % 7 - 3) * y + n * n) / (1 + abs(n % 5 - 2) + abs(n % 7 - 3)) for n in range(1, 40)),
        np.zeros_like(x),
    )


@pytest.mark.parametrize("edges", ["periodic", "reservoirs", "channel"])
def test_gaps_with_a_closed_form_have_it(edges: Any) -> None:
    along = 1e-6 * (1.0 + 0.5 * np.sin(np.arange(16)))
    found = ta.flow(np.tile(along, (8, 1)), size=("16 um", "8 um"), edges=edges)
    cube = along.mean() ** 3
    assert found.flow_factor_x == pytest.approx(1.0 / ((along**-3.0).mean() * cube), rel=1e-12)
    assert found.flow_factor_y == pytest.approx((along**3.0).mean() / cube, rel=1e-12)
    assert found.mean_gap_m == pytest.approx(along.mean()) and found.closed_fraction == 0.0
    # Along x the same flow passes every point.
    assert np.allclose(found.flow_along_x, [1.0, 0.0], atol=1e-11)


def test_turning_a_gap_exchanges_x_and_y() -> None:
    gap = rough() + 1e-8
    one = ta.flow(gap, size="1 um", edges="periodic")
    other = ta.flow(gap.T, size="1 um", edges="periodic")
    assert one.closed_fraction > 0.05 and one.flow_factor_x != one.flow_factor_y
    assert one.flow_factor_x == pytest.approx(float(other.flow_factor_y), rel=1e-10)
    assert np.allclose(one.flow_along_x, np.moveaxis(other.flow_along_y, 0, 1)[..., ::-1], rtol=1e-6, atol=1e-9)


def test_pressed_surfaces_and_their_gaps_have_one_flow() -> None:
    for periodic, edges in ((True, "periodic"), (False, "channel")):
        pressed = ta.boundary_elements(
            rough(), GLASS, pressure=["5 MPa", "10 GPa"], size="10 um", periodic=periodic, flow=True, fields=True
        )
        own = ta.flow(pressed.gap_m[0], size="10 um", edges=edges)  # type: ignore[arg-type]
        assert own.flow_factor_x == pytest.approx(pressed.flow_factor_x[0], rel=1e-12)
        assert list(pressed.open_along_y) == [1.0, 0.0] and pressed.flow_factor_y[1] == 0.0
    each = ta.boundary_elements(np.array([rough(), rough().T]), GLASS, pressure="5 MPa", size="10 um", periodic=True, flow=True)
    assert each.flow_factor_x[0, 0] == pytest.approx(each.flow_factor_y[0, 1], rel=1e-6)


def test_files_are_read_as_the_command_reads_them(tmp_path: Path) -> None:
    np.save(tmp_path / "gap.npy", 1e3 * (rough() + 3e-8))
    found = ta.flow(tmp_path / "gap.npy", unit="mm", size="1 um")
    scan = ta.read_scan(tmp_path / "gap.npy", unit="mm", size="1 um")
    assert found.flow_factor_x == pytest.approx(float(ta.flow(scan).flow_factor_x), rel=1e-9)
    assert any("edges" in note for note in found.notes)
    with refused_naming("unit", "gap.npy"):
        ta.flow(tmp_path / "gap.npy")
    with pytest.raises(FileNotFoundError):
        ta.flow(tmp_path / "nothing.nc")


def test_contact_is_counted_and_a_closed_gap_has_no_flow() -> None:
    gap = np.ma.masked_less(rough(), 0.0)
    found = ta.flow(gap, size="1 um", edges="periodic")
    assert found.closed_fraction == pytest.approx(gap.mask.mean())
    assert any("missing" in note for note in found.notes)
    closed = ta.flow(-np.ones((4, 4)), size="1 um")
    assert closed.flow_factor_x == closed.open_along_y == closed.mean_gap_m == 0.0 and not closed.flow_along_x.any()
    assert ta.flow(np.ones((1, 6)), size=("6 um", "1 um")).flow_factor_y == pytest.approx(1.0)


def test_a_flow_is_drawn_and_pickled() -> None:
    found = ta.flow(rough() + 1e-8, size="1 um", edges="periodic")
    assert found.plot() is not None and "<svg" in found._repr_html_()
    assert pickle.loads(pickle.dumps(found)) == found
    assert ta.flow(np.ones((1, 6)), size=("6 um", "1 um"))._repr_html_()


def test_what_is_no_gap_is_refused() -> None:
    gap = rough() + 1e-8
    with refused_naming("edges", "open"):
        ta.flow(gap, size="1 um", edges="open")  # type: ignore[arg-type]
    with refused_naming("size"):
        ta.flow(gap)
    with refused_naming("unit"):
        ta.flow(gap, size="1 um", unit="nm")
    with refused_naming("gap"):
        ta.flow(np.array([gap, gap]), size="1 um")
    with refused_naming("gap"):
        ta.flow(np.full((4, 4), 1e300), size="1 um")
    with refused_naming("flow_edges", "flow"):
        ta.boundary_elements(gap, GLASS, pressure="1 MPa", size="1 um", flow_edges="channel")
    holed = np.where(gap < 0, np.nan, gap)
    with refused_naming("no height"):
        ta.boundary_elements(holed, GLASS, pressure="1 MPa", size="1 um", gaps="keep", flow=True)
