"""Scans: what files hold, arrays beside files of the same heights, and composites of all of them."""

from __future__ import annotations

import io
import pickle
import subprocess
import sys
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest

import truearea as ta
from support import Columns, numbers, refused_naming, words

Floats = npt.NDArray[np.float64]


def heights(seed: int = 1, shape: tuple[int, ...] = (48, 64)) -> Floats:
    """A rough map or line, some nm high."""
    walk: Floats = 1e-9 * np.random.default_rng(seed).standard_normal(shape).cumsum(axis=-1)
    return walk


def saved(folder: Path, h: Floats, name: str = "scan.npy") -> Path:
    path = folder / name
    np.save(path, h)
    return path


def same_spectrum(one: ta.Spectrum, other: ta.Spectrum) -> bool:
    errors, others = one.c1d_se_m3, other.c1d_se_m3
    if errors is None or others is None:
        same_errors = errors is others
    else:
        same_errors = np.array_equal(errors, others, equal_nan=True)
    return same_errors and np.array_equal(one.wavelengths_m, other.wavelengths_m) and np.array_equal(one.c1d_m3, other.c1d_m3)


# Files.


def test_a_file_tells_its_heights_and_what_is_in_it(tmp_path: Path) -> None:
    h = heights()
    scan = ta.read_scan(saved(tmp_path, h), unit="m", size="4 um")
    assert np.array_equal(scan.heights_m, h)
    assert not np.ma.isMaskedArray(scan.heights_m)
    assert scan.size_m == (4e-6, 4e-6 / 64 * 48)
    assert scan.spacing_m == (4e-6 / 64, 4e-6 / 64)
    assert (scan.name, scan.format, scan.channel, scan.positions_m) == ("scan.npy", "NumPy", None, None)
    assert (scan.is_periodic, scan.tip_radius_m, len(scan.sha256)) == (False, None, 64)
    assert any("size along x" in note for note in scan.notes)
    assert repr(scan) == "Scan('scan.npy', NumPy, 48 x 64 points, 4e-06 m x 3e-06 m)"
    row = scan.summary()
    assert row.points_x.tolist() == [64.0] and row.points_y.tolist() == [48.0]
    assert row.rms_height_m[0] == pytest.approx(h.std(), rel=1e-12)
    assert row.to_pandas().shape[0] == 1
    with refused_naming("read-only", by=ValueError):
        scan.heights_m[0, 0] = 1.0


def test_gaps_are_masked_and_lines_have_one_axis(tmp_path: Path) -> None:
    h = heights()
    h[3, 5] = np.nan
    scan = ta.read_scan(saved(tmp_path, h), unit="m", size=1e-6)
    assert isinstance(scan.heights_m, np.ma.MaskedArray)
    assert np.argwhere(np.ma.getmaskarray(scan.heights_m)).tolist() == [[3, 5]]
    assert scan.summary().gaps.tolist() == [1.0]
    text = tmp_path / "line.txt"
    text.write_text("# x (nm) h (nm)\n0 1\n1 3\n3 2\n4 2\n")
    line = ta.read_scan(text)
    assert line.heights_m.tolist() == [1e-9, 3e-9, 2e-9, 2e-9]
    assert line.positions_m is not None and line.positions_m.tolist() == [0.0, 1e-9, 3e-9, 4e-9]
    assert line.size_m == (4e-9,)


def test_pictures_and_pickles_of_scans(tmp_path: Path) -> None:
    scan = ta.read_scan(saved(tmp_path, heights()), unit="nm", size="4 um")
    picture = scan._repr_html_()
    assert picture.startswith("<div><svg") and "data:image/png;base64," in picture and picture.count("</svg>") == 1
    again = pickle.loads(pickle.dumps(scan))
    assert np.array_equal(again.heights_m, scan.heights_m) and repr(again) == repr(scan)
    (tmp_path / "scan.npy").unlink()
    assert same_spectrum(ta.composite([pickle.loads(pickle.dumps(scan))]), ta.composite([scan]))
    line = tmp_path / "line.txt"
    line.write_text("# x (nm) h (nm)\n0 1\n1 3\n2 2\n3 2\n")
    assert ta.read_scan(line)._repr_html_().startswith("<div><svg")


def test_channels_are_those_of_the_command_line(tmp_path: Path, command_line: Callable[..., Columns]) -> None:
    h = heights()
    h[3, 5] = np.nan
    path = saved(tmp_path, h)
    of_command = command_line("scan", str(path), "--unit", "m", "--size", "4um")
    found = ta.scan_channels(path, unit="m", size="4 um")
    for name in of_command:
        if name in ("file", "format", "channel", "note"):
            assert name == "channel" or list(found[name]) == list(of_command[name])
        else:
            assert np.array_equal(found[name], numbers(of_command, name), equal_nan=True), name
    assert found.note[0] == words(of_command, "note")[0]


def test_what_lies_beside_a_file_is_read(tmp_path: Path) -> None:
    path = saved(tmp_path, heights())
    (tmp_path / "meta.yml").write_text(
        "surfaces:\n- name: steel\n  topographies:\n  - name: first\n    size: [4, 3]\n    unit: µm\n"
        "    height_scale: 1000000.0\n    datafile:\n      original: scan.npy\n"
    )
    scan = ta.read_scan(path)
    assert scan.name == "first"
    assert scan.size_m == pytest.approx((4e-6, 3e-6), rel=1e-15)
    again = pickle.loads(pickle.dumps(scan))
    assert again.size_m == scan.size_m


def test_a_measurement_of_a_container_is_chosen(tmp_path: Path) -> None:
    path = tmp_path / "plate.zip"
    names = ("first", "second")
    entry = "  - name: {0}\n    size: [4, 4]\n    unit: nm\n    datafile:\n      original: {0}.npy\n"
    with zipfile.ZipFile(path, "w") as container:
        container.writestr("meta.yml", "surfaces:\n- name: plate\n  topographies:\n" + "".join(map(entry.format, names)))
        for seed, name in enumerate(names):
            content = io.BytesIO()
            np.save(content, heights(seed, (16, 16)))
            container.writestr(f"{name}.npy", content.getvalue())
    with refused_naming("(first, second)", "measurement"):
        ta.read_scan(path)
    with refused_naming("measurement 'third'"):
        ta.read_scan(path, measurement="third")
    second = ta.read_scan(path, measurement="second")
    assert second.name == "second" and second.size_m == pytest.approx((4e-9, 4e-9), rel=1e-15)
    both = ta.composite([path]).scans
    assert both is not None and list(both.scan) == list(names)
    assert list(ta.scan_channels(path).channel) == list(names)


def test_files_that_do_not_do_are_told(tmp_path: Path) -> None:
    path = saved(tmp_path, heights())
    with pytest.raises(FileNotFoundError):
        ta.read_scan(tmp_path / "none.npy")
    with pytest.raises(FileNotFoundError):
        ta.composite([path, tmp_path / "none.npy"], unit="m", size="4 um")
    refusals: list[tuple[dict[str, Any], str]] = [
        ({"unit": "m"}, " size"),
        ({"size": "4 um"}, "unit of heights; set it with unit"),
        ({"unit": "furlong"}, "unit: 'furlong'"),
        ({"unit": "m", "size": -1.0}, "size -1;"),
        ({"unit": "m", "size": 1.0, "gaps": "none"}, "'none' refuse, harmonic, lines"),
        ({"unit": "m", "size": 1.0, "tip_radius": "sharp"}, "tip_radius: "),
    ]
    for options, words in refusals:
        with refused_naming(*words.split()):
            ta.read_scan(path, **options)
    psd = tmp_path / "psd.csv"
    psd.write_text("Wavevector (1/m),C1D_m3\n" + "".join(f"{q},{1e-20 / q}\n" for q in (1e5, 1e6, 1e7)))
    with refused_naming("read_psd"):
        ta.read_scan(psd)
    nothing = tmp_path / "nothing.dat"
    nothing.write_bytes(b"\x00\x01\x02")
    with refused_naming("nothing.dat"):
        ta.read_scan(nothing)
    with refused_naming("read_scan", by=TypeError):
        ta.Scan()


# Arrays.


def test_an_array_has_the_spectrum_of_its_file(tmp_path: Path) -> None:
    h = heights()
    of_file = ta.composite([saved(tmp_path, h)], unit="m", size="4 um", tip_radius="8 nm")
    of_array = ta.Spectrum.from_heights(h, size=(4e-6, 3e-6), tip_radius=8e-9)
    assert same_spectrum(of_file, of_array)
    assert of_array.name == "heights"
    assert [note for note in of_array.notes if "Parseval" in note] == []
    with_gaps = h.copy()
    with_gaps[3, 5:9] = np.nan
    of_file = ta.composite([saved(tmp_path, with_gaps)], unit="m", size="4 um")
    of_array = ta.Spectrum.from_heights(np.ma.masked_invalid(with_gaps), size=("4 um", "3 um"))
    assert same_spectrum(of_file, of_array)
    assert any("no height" in note for note in of_array.notes)


def test_a_line_and_a_square_map_take_one_length(tmp_path: Path) -> None:
    line = heights(shape=(512,))
    of_line = ta.Spectrum.from_heights(line, size="1 mm")
    of_file = ta.composite([saved(tmp_path, line)], unit="m", size=1e-3)
    assert same_spectrum(of_line, of_file)
    assert same_spectrum(of_line, ta.Spectrum.from_heights(line, size=(1e-3,)))
    square = heights(shape=(64, 64))
    one = ta.Spectrum.from_heights(square, size=1e-6)
    assert same_spectrum(one, ta.Spectrum.from_heights(square, size=(1e-6, 1e-6)))


@pytest.mark.parametrize(
    "turn",
    [
        lambda h: h.astype(">f8"),
        lambda h: np.asfortranarray(h),
        lambda h: np.repeat(h, 2, axis=1)[:, ::2],
        lambda h: h[::-1, ::-1][::-1, ::-1],
        lambda h: h.tolist(),
        lambda h: np.ma.masked_array(h),
    ],
)
def test_however_an_array_lies_its_spectrum_is_the_same(turn: Callable[[Floats], Any]) -> None:
    h = heights()
    before = h.copy()
    assert same_spectrum(ta.Spectrum.from_heights(turn(h), size=(4e-6, 3e-6)), ta.Spectrum.from_heights(h, size=(4e-6, 3e-6)))
    assert np.array_equal(h, before)


def test_whole_numbers_and_single_precision_are_converted() -> None:
    whole = np.arange(48 * 64).reshape(48, 64) % 7
    assert same_spectrum(
        ta.Spectrum.from_heights(whole, size=1e3 * np.ones(2)),
        ta.Spectrum.from_heights(whole.astype(float), size=(1e3, 1e3)),
    )


def test_periodic_heights_need_no_window() -> None:
    x = np.arange(256) / 256
    h = 1e-9 * np.sin(2 * np.pi * 8 * x) * np.ones((256, 1)) + 1e-12 * heights(shape=(256, 256)) / 1e-9
    periodic = ta.Spectrum.from_heights(h, size="1 um", periodic=True)
    other = ta.Spectrum.from_heights(h, size="1 um")
    assert not np.array_equal(periodic.c1d_m3, other.c1d_m3)
    assert "window none" in periodic.remarks[1] and "window hann" in other.remarks[1]


@pytest.mark.skipif(not Path("/proc/self/clear_refs").exists(), reason="peaks of memory are told by Linux")
def test_arrays_are_copied_once() -> None:
    script = """
import numpy as np
from truearea import _native
from truearea._composite import heights_of
h = np.random.default_rng(1).standard_normal((4096, 2048))
def peak():
    lines = open("/proc/self/status").read().splitlines()
    return next(1024 * int(line.split()[1]) for line in lines if line.startswith("VmHWM"))
open("/proc/self/clear_refs", "w").write("5")
before = peak()
scan = _native.Scan.of_heights(heights_of("h", "size", "h", h, (1.0, 1.0), None))
print((peak() - before) / h.nbytes)
"""
    beside = Path(ta.__file__).parents[1]
    done = subprocess.run([sys.executable, "-c", script], cwd=beside, check=True, capture_output=True, text=True)
    assert 0.5 < float(done.stdout) < 1.2


def test_pickled_spectra_of_heights_come_back() -> None:
    gaps = np.ma.masked_array(heights(), mask=heights() > 2e-8)
    for spectrum in (
        ta.Spectrum.from_heights(heights(), size=(4e-6, 3e-6), name="plate"),
        ta.Spectrum.from_heights(gaps, size=(4e-6, 3e-6)),
        ta.composite([(heights(1), (4e-6, 3e-6)), (heights(2), ("4 um", "3 um"))], instrument="AFM"),
    ):
        again = pickle.loads(pickle.dumps(spectrum))
        assert same_spectrum(again, spectrum)
        assert (again.name, again.notes, again.remarks, again.scans) == (
            spectrum.name,
            spectrum.notes,
            spectrum.remarks,
            spectrum.scans,
        )


NAN = heights()
NAN[1, 2] = np.nan


@pytest.mark.parametrize(
    ("given", "size", "words"),
    [
        (NAN, (1.0, 1.0), "h[1, 2] NaN; numpy.ma.masked_invalid(h)"),
        (np.array([1.0, np.inf, 2.0]), 1.0, "h[1] inf;"),
        (heights(), None, "size (lx, ly)"),
        (heights(), 1e-6, "size: 48 64 (lx, ly)"),
        (heights(), (1.0, 2.0, 3.0), "size: 3 (lx, ly)"),
        (heights(shape=(9,)), (1.0, 2.0), "size: 2"),
        (heights(), (0.0, 1.0), "size[0] 0;"),
        (heights(), (1.0, np.nan), "size[1] NaN;"),
        (heights(), ("1", "1 um"), "size[0]: "),
        (np.float64(1.0), 1.0, "h: 0"),
        (np.zeros((2, 2, 2)), 1.0, "h: 3"),
        (np.zeros((0, 0)), 1.0, "h: columns 0, 2"),
        (np.zeros((1, 5)), (1.0, 1.0), "h: rows 1, 2"),
        (np.zeros(0), 1.0, "h: points 0, 2"),
        (np.zeros((8, 8)), 1.0, "heights: "),
        (np.array(["a", "b"]), 1.0, "h[0]: 'a'"),
        (np.array([1j, 2j]), 1.0, "h: complex128"),
        (np.array([True, False]), 1.0, "h: bool"),
        (np.ma.masked_array(np.zeros((8, 8)), mask=True), 1.0, "heights: "),
    ],
)
def test_arrays_that_cannot_be_scans_are_refused(given: Any, size: Any, words: str) -> None:
    with refused_naming(*words.split()):
        ta.Spectrum.from_heights(given, size)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"detrend": "sphere"}, "detrend: 'sphere' mean, line, plane"),
        ({"window": "flat"}, "'flat' hann, none"),
        ({"bins_per_decade": 0}, "bins_per_decade 0;"),
        ({"bins_per_decade": 2.5}, "bins_per_decade 2.5;"),
        ({"tip_radius": -1e-9}, "tip_radius -0.000000001;"),
        ({"direction": "z"}, "'z' x, y, both"),
        ({"gaps": 3}, "gaps: int"),
    ],
)
def test_choices_that_do_not_exist_are_refused(options: dict[str, Any], words: str) -> None:
    with refused_naming(*words.split()):
        ta.Spectrum.from_heights(heights(), (4e-6, 3e-6), **options)


# Topographies.


class Topography:
    """What an object of SurfaceTopography can do."""

    def __init__(self, h: Any, size: tuple[float, ...], unit: str, is_periodic: bool = False) -> None:
        self._h, self.physical_sizes, self.unit, self.is_periodic = h, size, unit, is_periodic

    def heights(self) -> Any:
        return self._h


def test_topographies_are_taken_where_heights_are() -> None:
    h = heights()
    given = Topography(np.ascontiguousarray(h.T) / 1e-9, (4000.0, 3000.0), "nm", True)
    of_object = ta.Spectrum.from_heights(given)
    of_array = ta.Spectrum.from_heights(np.ascontiguousarray(h.T).T / 1e-9 / 1e9, (4e-6, 3e-6), periodic=True)
    assert same_spectrum(of_object, of_array)
    assert same_spectrum(ta.composite([given]), of_object)
    assert not same_spectrum(ta.Spectrum.from_heights(given, periodic=False), of_object)
    with refused_naming("size: ", "h "):
        ta.Spectrum.from_heights(given, 1.0)


# Composites.


def test_scans_of_every_kind_make_one_spectrum(tmp_path: Path) -> None:
    paths = [saved(tmp_path, heights(seed), f"{seed}.npy") for seed in range(4)]
    of_files = ta.composite(paths, unit="m", size="4 um")
    topography = Topography(heights(3).T, (4e-6, 3e-6), "m")
    mixed = ta.composite(
        [paths[0], ta.read_scan(paths[1], unit="m", size="4 um"), (heights(2), (4e-6, 3e-6)), topography],
        unit="m",
        size="4 um",
    )
    assert same_spectrum(mixed, of_files)
    assert of_files.name == " + ".join(str(path) for path in paths)
    assert of_files.scans is not None and mixed.scans is not None
    assert np.array_equal(of_files.scans.slope_along, mixed.scans.slope_along)
    assert len(of_files.scans.verdict) == 4 and of_files.scans.used_from_m[0] > of_files.scans.used_to_m[0]
    assert "SHA-256" in of_files.remarks[1]
    assert ta.read_psd("builtin:uncd-measured").scans is None


def test_a_composite_is_that_of_the_command_line(tmp_path: Path, command_line: Callable[..., Columns]) -> None:
    paths = [saved(tmp_path, heights(seed), f"{seed}.npy") for seed in range(2)]
    options = "unit=m,size=4um"
    of_command = command_line(
        "psd", f"{paths[0]}:{options},tip-radius=8nm", f"{paths[1]}:{options}", "--average", "log", "--bins-per-decade", "7"
    )
    found = ta.composite(
        paths, unit="m", size="4 um", tip_radius=["8 nm", None], average="log", bins_per_decade=7
    )
    assert np.array_equal(found.c1d_m3, numbers(of_command, "C1D_m3"))
    assert np.array_equal(found.wavelengths_m, numbers(of_command, "wavelength_m"))


def test_what_is_said_of_scans_counts_for_each_or_for_all(tmp_path: Path) -> None:
    maps = [(heights(seed), (4e-6, 3e-6)) for seed in range(2)]
    for_each = ta.composite(maps, shortest=["0.5 um", None])
    assert for_each.scans is not None
    assert for_each.scans.limit[0] == "shortest given" and for_each.scans.limit[1] != "shortest given"
    for_all = ta.composite(maps, shortest=0.5e-6)
    assert for_all.scans is not None and list(for_all.scans.limit) == ["shortest given"] * 2
    assert not np.array_equal(
        ta.composite(maps, direction="y").c1d_m3, ta.composite(maps, direction="x").c1d_m3
    )


def test_composites_that_do_not_do_are_told(tmp_path: Path) -> None:
    path = saved(tmp_path, heights())
    pair = (heights(), (4e-6, 3e-6))

    refusals: list[tuple[Any, dict[str, Any], str]] = [
        ([], {}, "scans: empty"),
        (heights(), {}, "scans: list paths"),
        ([heights()], {}, "scans[0]: path, Scan, (heights, size) topography"),
        ([pair, 3], {}, "scans[1]: path, Scan, (heights, size)"),
        ([pair, (heights(), None)], {}, "scans[1][1] (lx, ly)"),
        ([pair], {"tip_radius": ["1 nm", "2 nm"]}, "tip_radius 2 1"),
        ([pair], {"unit": "nm"}, "unit files scans"),
        ([path, pair], {"unit": ["m", "m"], "size": "4 um"}, "unit[1] files scans[1]"),
        ([path], {}, f"scans[0]: {path}: "),
        ([pair, pair], {"instrument": "AFM", "z_calibration": ["3 %", "4 %"]}, "scans[1]: "),
        ([pair], {"z_calibration": 2.0}, "z_calibration: "),
        ([pair], {"slope_uncertainty": "x"}, "slope_uncertainty: "),
        ([pair], {"instrument": " "}, "instrument: "),
    ]
    for scans, options, words in refusals:
        with refused_naming(*words.split()):
            ta.composite(scans, **options)


def test_what_terminals_obey_leaves_no_file(tmp_path: Path) -> None:
    """A hostile name of a channel is text in tables, pages and messages, and no argument makes them long."""
    obeyed = "\x1b]0;owned\x07\x1b[2J\u202e"
    text = f"""fileType      Image
version       PicoView 0x10c04
comment       a
xPixels       3
yPixels       2
xLength       3.0e-006
yLength       1.0e-006
  more        bufferLabel
bufferLabel   a{obeyed}
bufferRange   3.2768e+000
bufferUnit    um
trace         Trace
data          ASCII
1
2
3
4
5
-6
"""
    path = tmp_path / "a.mi"
    path.write_text(text, encoding="utf-8")
    channels = ta.scan_channels(path)
    shown = [repr(channels), channels._repr_html_()]
    for channel in ("x", f"x{obeyed}", "x" * 20_000):
        with pytest.raises(ta.InputError) as refused:
            ta.read_scan(path, channel=channel)
        shown.append(str(refused.value))
        assert len(str(refused.value)) < 5_000
    assert not any(letter in text for text in shown for letter in obeyed if not letter.isprintable()), shown
