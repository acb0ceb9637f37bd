"""Boundary elements: another solver's answers, shapes, what is refused, and Ctrl-C."""

from __future__ import annotations

import _thread
import inspect
import pickle
import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest

import truearea as ta
from support import REFERENCE, Columns, numbers, refused_naming, words

UNCD = "builtin:uncd-reconstructed"
GLASS = ta.Material("100 GPa", 0.0, indentation_hardness="3 GPa")
UM = 1e-6
# The references are in units of the modulus.
UNIT = ta.Material("70 GPa", 0.0)
E_STAR = 70e9


def wave(rows: int = 32, columns: int = 32) -> npt.NDArray[np.float64]:
    """An egg box."""
    y, x = (2.0 * np.pi * np.arange(points) / points for points in (rows, columns))
    return 1e-8 * np.cos(y)[:, None] * np.cos(x)


def reference_map(name: str) -> tuple[npt.NDArray[Any], tuple[float, float]]:
    """Heights (rows, columns) in m, in the byte order of the file, and (lx, ly)."""
    netcdf = pytest.importorskip("scipy.io").netcdf_file
    with netcdf(REFERENCE / f"bem_{name}.nc", mmap=False) as file:
        heights, x, y = (file.variables[key] for key in ("heights", "x", "y"))
        assert heights.dimensions == ("x", "y")
        scaled: npt.NDArray[Any] = (heights.data.T * UM).astype(">f8")
        return scaled, (float(x.length) * UM, float(y.length) * UM)


@pytest.mark.parametrize("name", ["a", "b"])
def test_maps_are_pressed_as_another_solver_presses_them(name: str, reference: Callable[[str], Columns]) -> None:
    table = reference("boundary_elements.csv")
    heights_m, size = reference_map(name)
    assert heights_m.dtype.byteorder == ">" and not heights_m.flags.c_contiguous
    points = heights_m.size
    saturations = numbers(table, "saturation_over_e_star")
    of_map = np.array(words(table, "map")) == name
    for saturation in np.unique(saturations[of_map]):
        at = of_map & (np.isnan(saturations) if np.isnan(saturation) else saturations == saturation)
        exact = {column: numbers(table, column)[at] for column in table if column != "map"}
        pressed = ta.boundary_elements(
            heights_m,
            size=size,
            pressure=exact["pressure_over_e_star"] * E_STAR,
            material=UNIT,
            saturation=None if np.isnan(saturation) else saturation * E_STAR,
            periodic=True,
            tolerance=1e-10,
            fields=True,
        )
        within = 3.0 / points + np.finfo(float).eps
        assert np.all(np.abs(pressed.area_fraction - exact["area_fraction"]) <= within)
        plastic = np.nan_to_num(exact["plastic_area_fraction"])
        assert np.all(np.abs(pressed.plastic_area_fraction - plastic) <= within)
        largest_gap_m = pressed.gap_m.max(axis=(1, 2))
        for found, column in ((pressed.mean_gap_m, "mean_gap_um"), (pressed.mean_plastic_depth_m, "mean_plastic_depth_um")):
            bar_m = np.maximum(1e-5 * np.maximum(exact[column] * UM, 1e-3 * largest_gap_m), 1e-15)
            assert np.all(np.abs(found - exact[column] * UM) <= bar_m), column
        largest = pressed.largest_pressure_pa / E_STAR
        assert np.allclose(largest, exact["largest_pressure_over_e_star"], rtol=1e-6, atol=0.0)


def test_fields_carry_the_load_and_lie_as_the_heights_do() -> None:
    # A ridge along x, at row 5: axis 0 is y.
    heights_m = np.zeros((16, 24))
    heights_m[5] = 1e-7
    pressed = ta.boundary_elements(
        heights_m, size=(1.5e-6, 1e-6), pressure=[1e7, 1e8], material=GLASS, periodic=True, fields=True
    )
    assert pressed.pressure_pa.shape == pressed.gap_m.shape == (2, 16, 24)
    assert pressed.axes("pressure_pa") == ("load", "row", "column") and pressed.axes("height_m") == ("row", "column")
    assert np.allclose(pressed.pressure_pa.mean(axis=(1, 2)), [1e7, 1e8], rtol=1e-9)
    assert np.all(pressed.pressure_pa[0].sum(axis=1)[[row for row in range(16) if row != 5]] == 0.0)
    assert np.allclose(pressed.height_m, heights_m - heights_m.mean(), atol=1e-20)
    assert np.allclose(np.maximum(pressed.gap_m, 0.0).mean(axis=(1, 2)), pressed.mean_gap_m, rtol=1e-9)
    # Contact along x shuts the ways along y alone.
    assert pressed.open_along_x[0] == 1.0 and pressed.open_along_y[0] == 0.0


def test_arrays_of_any_kind_are_the_same_surface() -> None:
    rng = np.random.default_rng(1)
    whole = rng.integers(-5, 5, size=(16, 16))

    def area(h: Any) -> ta.Pressed:
        return ta.boundary_elements(h, size="16 m", pressure="1 GPa", material=GLASS, periodic=True)

    once = area(whole.astype(np.float64))
    for h in (whole, whole.astype(np.int8), whole.astype(np.float32), whole.astype(">i4"), whole.tolist()):
        assert area(h) == once
    strided = np.zeros((32, 48))
    strided[::2, ::3] = whole
    assert area(strided[::2, ::3]) == once
    assert area(np.asfortranarray(whole.astype(float))) == once
    assert area(np.ma.masked_array(whole, mask=False)) == once


def test_edges_are_free_unless_said_otherwise_and_a_plane_is_subtracted() -> None:
    tilted = wave() + np.linspace(0.0, 1e-7, 32)
    options: dict[str, Any] = {"pressure": "100 MPa", "material": GLASS}
    free = ta.boundary_elements(tilted, size="1 um", **options)
    assert np.allclose(free.area_fraction, ta.boundary_elements(wave(), size="1 um", **options).area_fraction, atol=2 / 1024)
    lying = ta.boundary_elements(tilted, size="1 um", detrend="mean", **options)
    assert lying.area_fraction[0] < free.area_fraction[0]
    assert ta.boundary_elements(wave(), size="1 um", periodic=True, **options) != ta.boundary_elements(wave(), size="1 um", **options)


class Topography:
    """As those of SurfaceTopography: heights by (x, y), with a size, a unit, and whether it repeats itself."""

    unit = "um"
    physical_sizes = (1.5, 1.0)
    is_periodic = True

    def heights(self) -> npt.NDArray[np.float64]:
        return wave(16, 24).T * 1e6


def test_topographies_know_their_size_and_edges() -> None:
    options: dict[str, Any] = {"pressure": "100 MPa", "material": GLASS, "fields": True}
    given = ta.boundary_elements(Topography(), **options)
    assert given.pressure_pa.shape == (1, 16, 24)
    by_hand = ta.boundary_elements(wave(16, 24), size=("1.5 um", "1 um"), periodic=True, **options)
    assert np.allclose(given.pressure_pa, by_hand.pressure_pa, rtol=1e-6, atol=1.0)
    free = ta.boundary_elements(Topography(), periodic=False, **options)
    assert free.area_fraction != given.area_fraction
    with refused_naming("size", "Topography"):
        ta.boundary_elements(Topography(), size=1e-6, **options)


@pytest.mark.parametrize("edges", ["periodic", "free"])
def test_scans_are_pressed_as_the_command_line_presses_files(edges: str, command_line: Callable[..., Columns]) -> None:
    file = REFERENCE / "bem_b.nc"
    loads = ["--pressure", "100MPa", "--pressure", "1GPa", "--boundary", edges]
    crates = command_line("bem", str(file), "--youngs-modulus", "100GPa", "--poisson-ratio", "0", *loads)
    pressed = ta.boundary_elements(
        ta.read_scan(file), pressure=["100 MPa", "1 GPa"], material=GLASS, periodic=edges == "periodic"
    )
    # The command line says the gradient in a note.
    assert list(pressed) == [*crates, "rms_gradient"]
    for name in crates:
        assert np.array_equal(pressed[name], numbers(crates, name), equal_nan=True), name
    if edges == "periodic":
        assert ta.boundary_elements(ta.read_scan(file), pressure=["100 MPa", "1 GPa"], material=GLASS) == pressed


RANDOM: dict[str, Any] = {"grid": 32, "realisations": 3, "shortest": "1 um", "seed": 5}
TYPED = "--grid 32 --realisations 3 --shortest 1um --seed 5 --youngs-modulus 100GPa --poisson-ratio 0".split()


@pytest.mark.parametrize("each", [False, True])
def test_random_surfaces_are_those_of_the_command_line_bit_for_bit(each: bool, command_line: Callable[..., Columns]) -> None:
    loads = ["--pressure", "10MPa", "--pressure", "300MPa", "--saturation", "1GPa"]
    crates = command_line("bem", UNCD, *TYPED, *loads, *(["--per-realisation"] if each else []))
    pressed = ta.boundary_elements(
        ta.read_psd(UNCD), pressure=["10 MPa", "300 MPa"], material=GLASS, saturation="1 GPa", per_realisation=each, **RANDOM
    )
    assert set(crates) - set(pressed) == ({"realisation", "standard_error"} if each else set())
    for name in set(pressed) - {"rms_gradient"}:
        array = np.broadcast_to(pressed[name][:, None], (2, 3)) if each and name == "nominal_pressure_pa" else pressed[name]
        assert np.array_equal(array.reshape(-1), numbers(crates, name), equal_nan=True), name
    assert pressed.axes("area_fraction") == (("load", "surface") if each else ("load",))


def test_means_and_standard_errors_are_those_of_the_surfaces() -> None:
    options: dict[str, Any] = {"pressure": [1e8, 1e9], "material": GLASS, "fields": True} | RANDOM
    spectrum = ta.read_psd(UNCD)
    each = ta.boundary_elements(spectrum, per_realisation=True, **options)
    mean = ta.boundary_elements(spectrum, **options)
    assert np.allclose(mean.area_fraction, each.area_fraction.mean(axis=1), rtol=1e-14)
    best = each.area_fraction_extrapolated
    assert np.allclose(mean.standard_error, best.std(axis=1, ddof=1) / np.sqrt(3.0), rtol=1e-10)
    assert mean.pressure_pa.shape == (2, 3, 32, 32) and mean.height_m.shape == (3, 32, 32)
    assert np.array_equal(mean.pressure_pa, each.pressure_pa)
    assert np.allclose(mean.pressure_pa.mean(axis=(2, 3)), [[1e8] * 3, [1e9] * 3], rtol=1e-9)
    touching = (mean.pressure_pa > 1e-10 * np.array([1e8, 1e9])[:, None, None, None]).mean(axis=(2, 3))
    assert np.allclose(touching, each.area_fraction, atol=1e-15)
    assert any("3 surfaces of 32 x 32 points" in note for note in mean.notes)


def test_no_digit_depends_on_threads() -> None:
    before = ta.threads()
    options: dict[str, Any] = {"pressure": [1e8, 1e9], "material": GLASS} | RANDOM
    try:
        ta.set_threads(1)
        one = ta.boundary_elements(ta.read_psd(UNCD), **options)
        ta.set_threads(4)
        assert ta.boundary_elements(ta.read_psd(UNCD), **options) == one
    finally:
        ta.set_threads(before)


def test_results_are_pickled_and_framed() -> None:
    pytest.importorskip("xarray")
    pressed = ta.boundary_elements(
        wave(), size="1 um", pressure=[1e7, 1e8], material=GLASS, periodic=True, fields=True
    )
    assert pickle.loads(pickle.dumps(pressed)) == pressed
    data = pressed.to_xarray()
    assert data.pressure_pa.dims == ("load", "row", "column") and data.gap_m.attrs["units"] == "m"
    assert set(data.coords) == {"nominal_pressure_pa", "x_m", "y_m"}
    assert float(data.sel(x_m=0.5e-6, y_m=0.0, method="nearest").x_m) == 0.5e-6
    table = ta.boundary_elements(wave(), size="1 um", pressure=[1e7, 1e8], material=GLASS).to_pandas()
    assert len(table) == 2 and table["standard_error"].isna().all()


@pytest.mark.parametrize(
    ("h", "size", "changes", "told"),
    [
        (np.ma.masked_array(wave(), wave() > 0.9e-8), 1e-6, {}, "surface: 42 1024 masked"),
        (np.where(wave() > 0.9e-8, np.nan, wave()), 1e-6, {}, "surface: 42 1024 NaN"),
        (np.full((4, 4), np.inf), 1e-6, {}, "surface: 16 NaN"),
        (wave()[0], 1e-6, {}, "surface: 1"),
        (wave()[None, None], 1e-6, {}, "surface: 4"),
        (3.0, 1e-6, {}, "surface: 0"),
        ([["1", "2"], ["3", "4"]], 1e-6, {}, "surface[0][0]: unit"),
        ([[1.0, 2.0], [3.0]], 1e-6, {}, "surface: array"),
        (wave().astype(complex), 1e-6, {}, "surface: complex128"),
        (np.empty((0, 0)), 1e-6, {}, "surface: no heights"),
        (wave()[:1], (1e-6, 1e-6), {}, "surface: row periodic"),
        (1e40 * wave(), 1e-6, {}, "height"),
        (wave(), None, {}, "size (lx, ly)"),
        (wave(16, 32), 1e-6, {}, "size 16 32"),
        (wave(), (1e-6, 1e-6, 1e-6), {}, "size: 3"),
        (wave(), (1e-6, -1e-6), {}, "size[1] -0.000001;"),
        (wave(), "1 kg", {}, "size[0]:"),
        (wave(), (None, 1e-6), {}, "size[0]: '5 um' NoneType"),
        (wave(), 1e-6, {"pressure": -1.0}, "pressure -1; 0"),
        (wave(), 1e-6, {"pressure": []}, "pressure:"),
        (wave(), 1e-6, {"saturation": "1 kPa"}, "pressure 1 MPa saturation"),
        (wave(), 1e-6, {"saturation": 0.0}, "saturation 0;"),
        (wave(), 1e-6, {"tolerance": 0.5}, "tolerance 0.5;"),
        (wave(), 1e-6, {"tolerance": float("nan")}, "tolerance NaN;"),
        (wave(), 1e-6, {"detrend": "cubic"}, "detrend: cubic mean line plane"),
        (wave(), 1e-6, {"grid": 64}, "grid heights spectrum"),
        (wave(), 1e-6, {"per_realisation": True}, "per_realisation heights"),
    ],
)
def test_heights_that_cannot_be_pressed_are_refused(h: Any, size: Any, changes: dict[str, Any], told: str) -> None:
    given: dict[str, Any] = {"pressure": "1 MPa", "material": GLASS} | changes
    with refused_naming(*told.split()):
        ta.boundary_elements(h, size=size, **given)


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({"size": 1e-6}, "size heights"),
        ({"periodic": True}, "periodic spectrum"),
        ({"detrend": "mean"}, "detrend spectrum"),
        ({"grid": 8}, "grid 8; 16 16384"),
        ({"grid": 10**30}, "grid 1000000000000000000000000000000; 16"),
        ({"grid": 32.5}, "grid 32.5;"),
        ({"grid": True}, "grid bool"),
        ({"realisations": 0}, "realisations 0; 1"),
        ({"seed": -1}, "seed -1; 0"),
        ({"longest": "long"}, "longest:"),
        ({"side": -1.0}, "side -1;"),
        ({"phases": 3}, "phases: int"),
        ({"phases": "none"}, "phases: none fixed-modulus gaussian"),
        ({"longest": 1e-3, "shortest": 1e-6}, f"{UNCD}: 1 mm 1 µm 32 points"),
        ({"longest": 1e-6, "shortest": 2e-6}, "roughness"),
    ],
)
def test_surfaces_that_cannot_be_made_are_refused(changes: dict[str, Any], told: str) -> None:
    given: dict[str, Any] = {"pressure": "1 MPa", "material": GLASS, "grid": 32} | changes
    with refused_naming(*told.split()):
        ta.boundary_elements(ta.read_psd(UNCD), **given)


def test_what_is_no_material_is_told() -> None:
    steel: Any = "steel"
    for h, size in ((wave(), 1e-6), (ta.read_psd(UNCD), None)):
        with refused_naming("material:", "steel"):
            ta.boundary_elements(h, size=size, pressure=1.0, material=steel)


def test_a_saturation_in_hardnesses_needs_one() -> None:
    with refused_naming("saturation", "H", "indentation_hardness"):
        ta.boundary_elements(wave(), size=1e-6, pressure="1 MPa", material=UNIT, saturation="1 H")


def test_fields_beyond_memory_are_a_memory_error() -> None:
    with pytest.raises(MemoryError):
        ta.boundary_elements(
            ta.read_psd(UNCD), pressure="1 GPa", material=GLASS, grid=16384, realisations=2**31, shortest="1 um", fields=True
        )


def test_a_callable_is_told_of_the_steps_and_may_end_the_work() -> None:
    told: list[tuple[int, int | None]] = []
    options: dict[str, Any] = {"pressure": [1e8, 1e9], "material": GLASS} | RANDOM
    pressed = ta.boundary_elements(ta.read_psd(UNCD), progress=lambda done, of: told.append((done, of)), **options)
    assert pressed == ta.boundary_elements(ta.read_psd(UNCD), **options)
    done, of = told[-1]
    assert done == of and [done for done, _ in told] == sorted(done for done, _ in told)

    def end(done: int, of: int | None) -> None:
        raise RuntimeError("enough")

    with refused_naming("enough", by=RuntimeError):
        ta.boundary_elements(wave(), size="1 um", pressure="1 MPa", material=GLASS, progress=end)
    with refused_naming("progress:", "True", "False", "str", by=TypeError):
        progress: Any = "yes"
        ta.boundary_elements(wave(), size="1 um", pressure="1 MPa", material=GLASS, progress=progress)


def test_ctrl_c_ends_a_long_run() -> None:
    interrupt = threading.Timer(0.5, _thread.interrupt_main)
    begin = time.monotonic()
    interrupt.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            ta.boundary_elements(
                ta.read_psd(UNCD),
                pressure=np.geomspace(1e7, 1e10, 40),
                material=GLASS,
                grid=256,
                realisations=50,
                shortest="100 nm",
                tolerance=1e-10,
            )
    finally:
        interrupt.cancel()
    assert time.monotonic() - begin < 10.0
    # The next call is none the worse for it.
    assert ta.boundary_elements(wave(), size=1e-6, pressure="1 MPa", material=GLASS).area_fraction[0] > 0.0


def test_the_material_may_come_second_as_in_all_other_functions() -> None:
    heights = 1e-9 * np.random.default_rng(5).standard_normal((16, 16))
    steel = ta.Material("210 GPa", 0.3)
    now = ta.boundary_elements(heights, steel, pressure="10 MPa", size="1 um")
    named = ta.boundary_elements(heights, material=steel, pressure="10 MPa", size="1 um")
    assert now == named
    spectrum = ta.read_psd("builtin:uncd-measured")
    assert ta.boundary_elements(spectrum, steel, pressure="10 MPa", grid=16, realisations=2).sizes["load"] == 1
    with pytest.raises(TypeError, match="2 positional"):
        ta.boundary_elements(heights, steel, "10 MPa")  # type: ignore[call-arg]  # pyright: ignore[reportCallIssue]


def test_the_signature_shows_the_order_of_all_other_functions() -> None:
    shown = inspect.signature(ta.boundary_elements).parameters
    assert list(shown)[:4] == ["surface", "material", "pressure", "mean_gap"]
    kinds = {parameter.kind for parameter in list(shown.values())[2:]}
    assert kinds == {inspect.Parameter.KEYWORD_ONLY}
    assert {"saturation", "tolerance", "grid", "periodic", "progress"} <= set(shown)


BUMPS = 1e-9 * np.random.default_rng(3).standard_normal((64, 64))


def test_a_ball_on_a_smooth_flat_is_hertz() -> None:
    # E* = 100 GPa, R = 1 mm, F = 1 mN: a = (3FR/4E*)^(1/3), p0 = 3F/(2 pi a^2).
    radius_m = (0.75 * 1e-3 * 1e-3 / 100e9) ** (1 / 3)
    flat = np.zeros((128, 128))
    flat[0, 0] = -1e-15
    pressed = ta.ball(flat, GLASS, radius="1 mm", force="1 mN", size=8 * radius_m, detrend="mean")
    assert pressed.hertz_radius_m[0] == pytest.approx(radius_m, rel=1e-9)
    assert pressed.effective_radius_m[0] == pytest.approx(radius_m, rel=0.01)
    assert pressed.hertz_pressure_pa[0] == pytest.approx(1.5e-3 / (np.pi * radius_m**2), rel=1e-9)
    assert pressed.peak_mean_pressure_pa[0] == pytest.approx(pressed.hertz_pressure_pa[0], rel=0.05)


@pytest.mark.parametrize("kind", ["map", "spectrum"])
def test_balls_are_pressed_as_the_command_line_presses_them(kind: str, command_line: Callable[..., Columns]) -> None:
    ball = ["--ball-radius", "100um", "--force", "1uN", "--tolerance", "1e-5"]
    options: dict[str, Any] = {"radius": "100 um", "force": 1e-6, "tolerance": 1e-5}
    if kind == "map":
        file = REFERENCE / "bem_b.nc"
        crates = command_line("bem", str(file), "--youngs-modulus", "100GPa", "--poisson-ratio", "0", *ball)
        pressed = ta.ball(ta.read_scan(file), GLASS, **options)
    else:
        crates = command_line("bem", UNCD, *TYPED, *ball)
        pressed = ta.ball(ta.read_psd(UNCD), GLASS, **options, **RANDOM)
    assert isinstance(pressed, ta.PressedBall)
    assert set(crates) - set(pressed) == {"realisation"}
    for name in pressed:
        assert np.array_equal(pressed[name], numbers(crates, name), equal_nan=True), name
    assert pressed.axes("real_area_m2") == ("surface",) and pickle.loads(pickle.dumps(pressed)) == pressed


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({"force": None}, "force NoneType"),
        ({"force": "1 MPa"}, "force:"),
        ({"force": -1.0}, "force -1;"),
        ({"radius": None}, "radius NoneType"),
        ({"radius": "1 N"}, "radius:"),
        ({"realisations": 2}, "realisations heights spectrum"),
        ({"force": "1 kN"}, "19.6 500"),
    ],
)
def test_balls_that_cannot_be_pressed_are_refused(changes: dict[str, Any], told: str) -> None:
    given: dict[str, Any] = {"radius": "1 um", "force": "1 nN", "size": "1 um"} | changes
    with refused_naming(*told.split()):
        ta.ball(BUMPS, GLASS, **given)


def test_a_watcher_of_a_ball_does_not_know_the_end() -> None:
    told: list[tuple[int, int | None]] = []
    watch: Any = lambda done, of: told.append((done, of))
    ta.ball(BUMPS, GLASS, radius="100 um", force="1 uN", size="10 um", progress=watch)
    assert told and {of for _, of in told} == {None}


def test_several_maps_are_pressed_as_each_by_itself() -> None:
    maps = np.stack([wave(), 2.0 * wave(), np.roll(wave(), 3, axis=1) + 0.5 * wave()[::-1]])
    options: dict[str, Any] = {"size": "1 um", "periodic": True, "fields": True, "pressure": [1e7, "2e8 Pa"]}
    together = ta.boundary_elements(maps, GLASS, **options)
    assert together.axes("area_fraction") == ("load", "map") and together.axes("pressure_pa") == ("load", "map", "row", "column")
    assert together.axes("nominal_pressure_pa") == ("load",) and together.axes("rms_gradient") == ("map",)
    for at, heights_m in enumerate(maps):
        alone = ta.boundary_elements(heights_m, GLASS, **options)
        for name in ("area_fraction", "mean_gap_m", "pressure_pa", "gap_m", "stiffness_pa_per_m"):
            assert np.array_equal(together[name][:, at], alone[name]), name
        assert np.array_equal(together.height_m[at], alone.height_m) and together.rms_gradient[at] == alone.rms_gradient
    before = ta.threads()
    with ta.threads(1):
        assert ta.boundary_elements(maps, GLASS, **options) == together
    assert ta.threads() == before
    with refused_naming("ball", "map"):
        ta.ball(maps, GLASS, size="1 um", radius="1 mm", force="1 mN")


def test_scans_of_one_size_are_a_stack_of_maps(tmp_path: Path) -> None:
    scans = []
    for number in (1, 2):
        np.save(tmp_path / f"{number}.npy", number * wave() * 1e9)
        scans.append(ta.read_scan(tmp_path / f"{number}.npy", unit="nm", size="1 um"))
    pressed = ta.boundary_elements(scans, GLASS, pressure="10 MPa")
    assert pressed.sizes["map"] == 2
    np.testing.assert_array_equal(pressed.area_fraction[:, 1], ta.boundary_elements(scans[1], GLASS, pressure="10 MPa").area_fraction)
    np.save(tmp_path / "3.npy", wave(16, 16) * 1e9)
    with refused_naming("surface", "size"):
        ta.boundary_elements([*scans, ta.read_scan(tmp_path / "3.npy", unit="nm", size="1 um")], GLASS, pressure="10 MPa")


def test_a_held_distance_takes_the_load_that_leaves_it() -> None:
    options: dict[str, Any] = {"size": "1 um", "tolerance": 1e-8}
    pressures = np.array([1e7, 1e8, 5e8])
    loaded = ta.boundary_elements(wave(), GLASS, pressure=pressures, periodic=True, **options)
    held = ta.boundary_elements(wave(), GLASS, mean_gap=loaded.mean_gap_m, periodic=True, **options)
    np.testing.assert_allclose(held.nominal_pressure_pa, pressures, rtol=1e-5)
    np.testing.assert_allclose(held.area_fraction, loaded.area_fraction, atol=1.01 / 1024)
    # On surfaces without edges the distance is that from the highest point.
    deep = ta.boundary_elements(wave(), GLASS, indentation=wave().max() - loaded.mean_gap_m, periodic=True, **options)
    np.testing.assert_allclose(deep.nominal_pressure_pa, pressures, rtol=1e-5)
    flows: dict[str, Any] = {**options, "periodic": True, "saturation": "1 H"}
    yielding = ta.boundary_elements(wave(), GLASS, pressure="200 MPa", **flows)
    gap = ta.boundary_elements(wave(), GLASS, mean_gap=yielding.mean_gap_m - yielding.mean_plastic_depth_m, **flows)
    np.testing.assert_allclose(gap.nominal_pressure_pa, 2e8, rtol=1e-5)
    random = ta.boundary_elements(UNCD, GLASS, mean_gap="0.1 nm", grid=32, realisations=3, per_realisation=True)
    assert random.axes("nominal_pressure_pa") == ("load", "surface") and np.ptp(random.nominal_pressure_pa) > 0.0
    refused: list[tuple[dict[str, Any], str]] = [
        ({"mean_gap": "1 um", "periodic": True}, "mean gap"),
        ({"mean_gap": "1 nm"}, "indentation"),
        ({"indentation": "1 um", "periodic": True}, "indentation"),
        ({"mean_gap": "1 nm", "pressure": 1e7, "periodic": True}, "pressure mean_gap"),
        ({}, "pressure mean_gap indentation"),
        ({"mean_gap": -1e-9, "periodic": True}, "mean_gap"),
    ]
    for changes, words in refused:
        with refused_naming(*words.split()):
            ta.boundary_elements(wave(), GLASS, size="1 um", **changes)


def test_loads_are_given_in_units_of_modulus_and_gradient() -> None:
    maps = np.stack([wave(), 3.0 * wave()])
    found = ta.boundary_elements(maps, UNIT, pressure=["0.002 E*", "0.05 E* h'", "500 MPa"], size="1 um", periodic=True)
    np.testing.assert_allclose(found.nominal_pressure_pa[0], 0.002 * E_STAR, rtol=1e-12)
    np.testing.assert_allclose(found.nominal_pressure_pa[1], 0.05 * E_STAR * found.rms_gradient, rtol=1e-12)
    # Under one load in these units a steeper surface of the same shape has the same area.
    assert found.area_fraction[1, 0] == found.area_fraction[1, 1] and found.area_fraction[2, 0] > found.area_fraction[2, 1]
    slopes = [np.diff(wave(), axis=axis) * 32 / 1e-6 for axis in (0, 1)]
    np.testing.assert_allclose(found.rms_gradient[0], np.hypot(*(np.sqrt(np.mean(slope**2)) for slope in slopes)), rtol=1e-12)
    random = ta.boundary_elements(UNCD, UNIT, pressure="0.05 E* h'", grid=32, realisations=2)
    np.testing.assert_allclose(random.nominal_pressure_pa, 0.05 * E_STAR * random.rms_gradient, rtol=1e-12)
    for wrong in ("0 E*", "-1 E* h'", "x E*", "nan E* h'"):
        with refused_naming(by=ta.InputError):
            ta.boundary_elements(wave(), UNIT, pressure=wrong, size="1 um")


STEEL_ON_GLASS = ta.Material("210 GPa", 0.3, counterface=ta.Material("70 GPa", 0.2))
GLASS_ON_STEEL = ta.Material("70 GPa", 0.2, counterface=ta.Material("210 GPa", 0.3))


def rough(seed: int, points: int = 40) -> npt.NDArray[np.float64]:
    """Waves of all directions, in m."""
    y, x = np.mgrid[0:points, 0:points]
    waves = ((0.2 + 0.003 * n * n, 2.4 * n + seed) for n in range(1, 40))
    heights: npt.NDArray[np.float64] = sum(
        5e-8 / (k + 0.3) * np.sin(k * (np.cos(angle) * x + np.sin(angle) * y) + 7.0 * angle * angle) for k, angle in waves
    ) * np.ones((points, points))
    return heights


def disc(heights: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """Heights with NaN outside a disc, and in a hole of it."""
    y, x = np.indices(heights.shape) - 0.5 * (len(heights) - 1)
    kept: npt.NDArray[np.float64] = np.where((np.hypot(x, y) < 18.0) & (np.hypot(x - 5.0, y) > 2.5), heights, np.nan)
    return kept


LOADS: dict[str, Any] = dict(pressure=["10 MPa", "100 MPa"], tolerance=1e-9)


@pytest.mark.parametrize("more", [{}, {"periodic": True}, {"detrend": "none", "compliance": "punch"}])
def test_two_maps_are_their_sum_and_change_places(more: dict[str, Any]) -> None:
    own, other = rough(1), rough(2)
    both = ta.boundary_elements(own, STEEL_ON_GLASS, counterface_surface=other, size="40 um", **LOADS, **more)
    on_flat = ta.boundary_elements(own + other[:, ::-1], STEEL_ON_GLASS, size="40 um", **LOADS, **more)
    exchanged = ta.boundary_elements(other, GLASS_ON_STEEL, counterface_surface=own, size="40 um", **LOADS, **more)
    for found in (on_flat, exchanged):
        assert np.array_equal(both.area_fraction, found.area_fraction)
        for name in ("area_fraction_extrapolated", "stiffness_pa_per_m", "mean_gap_m"):
            np.testing.assert_allclose(getattr(both, name), getattr(found, name), rtol=1e-9)
    assert any(note.code == "facing-maps" for note in both.notes)


def test_missing_points_never_touch_and_lie_outside_or_in_holes() -> None:
    heights = disc(rough(1))
    given: dict[str, Any] = dict(size="40 um", fields=True, **LOADS)
    pressed = ta.boundary_elements(heights, GLASS, gaps="keep", **given)
    missing = np.isnan(heights)
    assert np.array_equal(np.isnan(pressed.height_m), missing) and np.all(pressed.pressure_pa[:, missing] == 0.0)
    assert np.array_equal(np.isnan(pressed.gap_m[0]), missing)
    hole = np.hypot(*(np.indices(heights.shape) - np.array([19.5, 24.5])[:, None, None])) <= 2.5
    specimen = np.count_nonzero(~missing | hole)
    np.testing.assert_allclose(pressed.area_fraction, np.count_nonzero(pressed.pressure_pa > 1.0, axis=(1, 2)) / specimen)
    np.testing.assert_allclose(pressed.pressure_pa.sum(axis=(1, 2)) / specimen, [1e7, 1e8], rtol=1e-9)
    masked = ta.boundary_elements(np.ma.masked_invalid(heights), GLASS, gaps="keep", **given)
    assert np.array_equal(masked.area_fraction, pressed.area_fraction)
    # Between two maps they stay missing without a word.
    kept = ta.boundary_elements(heights, GLASS, counterface_surface=0.0 * heights[:, ::-1], **given)
    assert np.array_equal(kept.area_fraction, pressed.area_fraction)
    stiff = [
        ta.boundary_elements(heights, GLASS, gaps="keep", compliance=kind, **given).stiffness_pa_per_m[0]
        for kind in ("none", "punch", "even")
    ]
    assert stiff[0] == pressed.stiffness_pa_per_m[0] < stiff[1] < stiff[2]


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        ({"gaps": "fill"}, "gaps: fill refuse keep"),
        ({"compliance": "rigid"}, "compliance rigid"),
        ({"periodic": True, "compliance": "even"}, "compliance free"),
        ({"counterface_surface": np.zeros((2, 8, 8))}, "counterface_surface:"),
        ({"counterface_surface": "psd.csv"}, "counterface_surface:"),
        ({"counterface_surface": np.full((8, 8), np.inf)}, "counterface_surface: 64 infinite"),
    ],
)
def test_what_faces_no_map_is_named(given: dict[str, Any], expected: str) -> None:
    with refused_naming(*expected.split()):
        ta.boundary_elements(wave(), GLASS, pressure="1 MPa", size="1 um", **given)
