"""Objects of SurfaceTopography, as far as they can be told apart by what they can do."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from truearea import InputError
from truearea._topography import heights_and_size, is_topography


class Topography:
    """What such an object has, heights by (x, y)."""

    def __init__(self, heights: Any, size: Any, unit: Any = "nm", **others: Any) -> None:
        self._heights = heights
        self.physical_sizes = size
        self.unit = unit
        self.__dict__.update(others)

    def heights(self) -> Any:
        return self._heights


def test_heights_come_by_row_and_column_in_metres() -> None:
    given = np.array([[1.0, 2.0, 3.0], [4.0, 5.0, 5.65]])
    before = given.copy()
    heights_m, size_m, is_periodic = heights_and_size(Topography(given, (2.0, 3.0), is_periodic=True))
    assert heights_m.tolist() == [[1e-9, 4e-9], [2e-9, 5e-9], [3e-9, 5.65e-9]]
    assert (size_m, is_periodic) == ((2e-9, 3e-9), True)
    assert np.array_equal(given, before)
    assert heights_and_size(Topography(given, [2, 3], "m"))[1:] == ((2.0, 3.0), False)


def test_lines_have_one_size() -> None:
    heights_m, size_m, _ = heights_and_size(Topography(np.arange(4), (2.0,), "µm"))
    assert heights_m.tolist() == [0.0, 1e-6, 2e-6, 3e-6]
    assert size_m == (2e-6,)
    assert heights_and_size(Topography(np.arange(4), 2.0, "µm"))[1] == (2e-6,)


def test_gaps_stay_gaps() -> None:
    gaps = np.ma.masked_invalid([[1.0, np.nan], [3.0, 4.0], [5.0, 6.0]])
    heights_m, _, _ = heights_and_size(Topography(gaps, (3.0, 2.0)))
    assert isinstance(heights_m, np.ma.MaskedArray)
    assert np.ma.getmaskarray(heights_m).tolist() == [[False, False, False], [True, False, False]]
    assert not np.ma.isMaskedArray(heights_and_size(Topography(np.ma.masked_array([1.0, 2.0]), (1.0,)))[0])


@pytest.mark.parametrize(
    ("given", "message"),
    [
        (3, "h: an object with heights() and physical_sizes is needed, and this is of type int"),
        (np.zeros((2, 2)), "h: an object with heights() and physical_sizes is needed, and this is of type ndarray"),
        (Topography(np.zeros(3), (1.0,), None), "h: its unit is None; give it one, such as unit='nm' where it is made"),
        (Topography(np.zeros(3), (1.0,), "V"), "h: 'V' is not a unit of length; use one of m, cm, mm, µm, nm, Å, kÅ"),
        (Topography(np.zeros(3), (1.0,), is_uniform=False), "h: its points are unevenly spaced; make it even with"),
        (Topography(np.zeros(3), None), "h: its physical_sizes is None; give it one where it is made"),
        (Topography(np.zeros(3), (1.0, 2.0)), "h: its heights have 1 axes and its physical_sizes 2"),
        (Topography(np.zeros((2, 2, 2)), (1.0, 2.0)), "h: heights of one or two axes are needed, and these have 3"),
        (Topography(np.array(["a"]), (1.0,)), "h[0]: numbers are needed, and this is text"),
    ],
)
def test_what_cannot_be_used_is_told(given: Any, message: str) -> None:
    with pytest.raises(InputError) as refused:
        heights_and_size(given, "h")
    assert str(refused.value).startswith(message)


def test_topographies_are_told_by_what_they_can_do() -> None:
    assert is_topography(Topography(np.zeros(3), (1.0,)))
    assert not is_topography(np.zeros(3)) and not is_topography("scan.asc")
