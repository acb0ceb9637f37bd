"""Names that calls take, as types: a mistyped one is found by a type checker, and offered by an editor."""

from __future__ import annotations

from typing import Literal

StackedModel = Literal["elastic-plastic", "elastic"]
"""Models of the stack."""

StatisticalModel = Literal["hertz", "ep-sphere", "elastic-sine", "ep-sine", "bgt"]
"""Models of a population of asperities."""

PerssonModel = Literal["persson", "persson-plastic"]
"""Persson's theory for bodies that do not yield, and that do."""

LawModel = Literal[PerssonModel, StatisticalModel]
"""Models with a distance between the surfaces."""

GapModel = Literal[LawModel, "bem"]
"""Models with a distance between the surfaces, and boundary elements."""

ShearedModel = Literal["persson", "hertz", "elastic-sine", "bgt", "bem"]
"""Models with a distance between the surfaces that do not yield."""

CurveModel = Literal[StackedModel, StatisticalModel, PerssonModel]
"""Models with an area."""

Band = Literal["1d", "2d"]
"""Waves that a cutoff ends: those of profiles, or those of the surface."""

EnergyFactor = float | Literal["fitted"]
"""Elastic energy factor of mean gaps: a number, or the form fitted to boundary elements."""

Correction = Literal["wang-muser", "yang-persson", "algebraic", "algebraic-nayak"]
"""Corrected forms of Persson's theory."""

HardnessFormula = Literal["2005", "cosine"]
"""Forms of the hardness of spheres that yield."""

Flattening = Literal["area", "area-and-force"]
"""Quantities of flattened spheres that no longer grow."""

SummitHeights = Literal["gaussian", "exponential"]
"""Distributions of the heights of elastic spheres."""

YieldingAreaLaw = Literal["blended", "elastic-shape"]
"""Areas of scales of a stack that yield."""

InterferenceLaw = Literal["rostami-jackson", "bem"]
"""Laws of pressure against interference of elastic sinusoids."""

Branch = Literal["apart", "contact", "both"]
"""Histories of a load with adhesion: from first touch, from full contact, or both."""

NoteLevel = Literal["note", "caution", "error"]
"""Levels of notes, by how much they change the conclusion."""

Normalisation = Literal["parseval", "as-printed"]
"""Factors of spectral moments."""

AmplitudeDefinition = Literal["eq5", "parseval"]
"""Definitions of the amplitude of a scale."""

Convention = Literal["c1d", "w1", "frequency", "ciso", "persson"]
"""Conventions of the values of a spectrum."""

Abscissa = Literal["wavelength", "wavevector", "frequency"]
"""Quantities of the first column of a spectrum."""

Detrend = Literal["none", "mean", "line", "plane"]
"""Trends that are subtracted from heights; none and the mean are one."""

Window = Literal["hann", "none"]
"""Windows of the transform."""

Average = Literal["log-unbiased", "log", "arithmetic"]
"""Means across scans that share a bin."""

Gaps = Literal["refuse", "harmonic", "lines", "keep"]
"""Treatments of missing points; kept ones are refused by spectra."""

MapGaps = Literal["refuse", "keep"]
"""Treatments of missing points of a map that is pressed."""

Compliance = Literal["none", "punch", "even"]
"""Compliances of a specimen as a whole that are taken out of a stiffness."""

FlowEdges = Literal["periodic", "reservoirs", "channel"]
"""Conditions at the edges of a gap that fluid flows through."""

Direction = Literal["x", "y", "both"]
"""Axes of a map along which spectra are taken."""

Phases = Literal["fixed-modulus", "gaussian"]
"""Random quantities of random surfaces."""

Dialect = Literal["abaqus", "calculix", "csv"]
"""Codes that read contact laws."""

UnitSystem = Literal["SI", "N-mm", "uN-um", "lbf-in"]
"""Units of finite element models."""

LawForm = Literal["table", "exponential"]
"""Forms of a contact law."""

LawQuantity = Literal["pressure", "heat", "current"]
"""Quantities that a law has."""

Gas = Literal["air", "nitrogen", "helium", "argon", "hydrogen"]
"""Gases with known properties."""

ConductanceCorrelation = Literal["cooper-mikic-yovanovich", "yovanovich"]
"""Correlations of conductances for flowed peaks."""

ConductanceModel = Literal[LawModel, ConductanceCorrelation]
"""Models of conductances."""

Form = Literal["none", "mean", "plane", "second-order"]
"""Forms that are removed before roughness parameters are taken; none and the mean are one."""

Conventions = Literal["usual", "all"]
"""Conventions of roughness parameters."""

Template = Literal[
    "new",
    "uncd-measured",
    "uncd-reconstructed",
    "gasket",
    "electrical-contact",
    "bolted-joint",
    "contact-challenge",
]
"""Scenes that come with the program."""
