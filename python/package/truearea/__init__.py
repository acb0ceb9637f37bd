"""How much of two rough surfaces really touches, and which scales of roughness decide it.

Arrays in, tables out: see the functions and classes that are listed in ``truearea.__all__``. Numbers are in SI units; where a
quantity has a unit, text such as ``"5 MPa"`` or ``"1e-3 H"`` does as well.
"""

from truearea._adhesion import AdhesiveContact, PullOff, adhesion, pull_off
from truearea._boundary_elements import Patches, Pressed, PressedBall, ball, boundary_elements
from truearea import _choices as choices
from truearea._choices import CurveModel, GapModel, LawModel, PerssonModel, ShearedModel, StackedModel, StatisticalModel
from truearea._composite import composite
from truearea._contact import ContactStates, contact
from truearea._curves import StackedCurve, StatisticalCurve, stacked, statistical
from truearea._flow import GapFlow, flow
from truearea._gap import Gaps, gap
from truearea._law import ContactLaw, CurrentConductance, HeatConductance, law
from truearea._material import Material
from truearea._native import VERSION as __version__
from truearea._native import InputError, set_threads
from truearea._names import Materials, Models, materials, models, show_versions
from truearea._notes import Caution, Note, Place
from truearea._persson import PerssonCurve, persson
from truearea._results import Result, Table
from truearea._roughness import Roughness, RoughnessScales, roughness
from truearea._scan import Scan, ScanChannels, read_scan, scan_channels
from truearea._scene import Scene, SceneResults, SceneTable, report
from truearea._spectrum import Amplitudes, Fit, Moments, Samples, Scans, Spectrum, read_psd
from truearea._sweep import sweep
from truearea._tangential import Sheared, tangential
from truearea._threads import threads
from truearea._uncertainty import Advice, Bands, Shares, Uncertainty, uncertainty

__all__ = [
    "AdhesiveContact",
    "Advice",
    "Amplitudes",
    "Bands",
    "Caution",
    "ContactLaw",
    "ContactStates",
    "CurrentConductance",
    "CurveModel",
    "Fit",
    "GapFlow",
    "GapModel",
    "Gaps",
    "HeatConductance",
    "InputError",
    "LawModel",
    "Material",
    "Materials",
    "Models",
    "Moments",
    "Note",
    "Patches",
    "PerssonCurve",
    "PerssonModel",
    "Place",
    "Pressed",
    "PressedBall",
    "PullOff",
    "Result",
    "Roughness",
    "RoughnessScales",
    "Samples",
    "Scan",
    "ScanChannels",
    "Scans",
    "Scene",
    "SceneResults",
    "SceneTable",
    "Shares",
    "Sheared",
    "ShearedModel",
    "Spectrum",
    "StackedCurve",
    "StackedModel",
    "StatisticalCurve",
    "StatisticalModel",
    "Table",
    "Uncertainty",
    "__version__",
    "adhesion",
    "ball",
    "boundary_elements",
    "choices",
    "composite",
    "contact",
    "flow",
    "gap",
    "law",
    "materials",
    "models",
    "persson",
    "pull_off",
    "read_psd",
    "read_scan",
    "report",
    "roughness",
    "scan_channels",
    "set_threads",
    "show_versions",
    "stacked",
    "statistical",
    "sweep",
    "tangential",
    "threads",
    "uncertainty",
]
