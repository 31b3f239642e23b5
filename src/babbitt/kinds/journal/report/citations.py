"""What to cite for the methods of journal bearings."""

from __future__ import annotations

from collections.abc import Iterator

from babbitt.kinds.journal.film.bore import WornBore
from babbitt.kinds.journal.film.model import FilmCase, PressureLaw
from babbitt.kinds.journal.grooved_long_bearing.model import SegmentCase
from babbitt.kinds.journal.infinitely_long_bearing.model import LongFilmCase
from babbitt.kinds.journal.iso7902.model import Curves, DesignCase, Friction
from babbitt.kinds.journal.problems import JournalDesign
from babbitt.report.citations import JOHNSON, REVERSE_GEAR, REYNOLDS, UNFOUND
from babbitt.reynolds.deformation.compliance import ColumnLiner
from babbitt.reynolds.deformation.elastic_ring import ElasticRing
from babbitt.reynolds.deformation.half_space import HalfSpace
from babbitt.reynolds.model import Cavitation

__all__ = ["film_citations", "iso7902_citations", "long_film_citations", "segment_citations"]

ISO_7902 = (
    "ISO 7902-1:2020, with ISO 7902-2 and ISO 7902-3: Hydrodynamic plain journal bearings under steady-state "
    "conditions, "
    "circular cylindrical bearings (procedure; the characteristics are computed by Babbitt, not copied)."
)
DIN_31652 = (
    "DIN 31652-2: Plain bearings, hydrodynamic plain journal bearings, functions (closed-form approximations)."
)
JFO = (
    "B. Jakobsson, L. Floberg: The finite journal bearing, considering vaporization. Transactions of "
    "Chalmers University "
    "of Technology 190 (1957); K.-O. Olsson: Cavitation in dynamically loaded bearings, ibid. 308 (1965)."
)
LUND = (
    "J. W. Lund, K. K. Thomsen: A calculation method and data for the dynamic coefficients of "
    "oil-lubricated journal "
    "bearings. Topics in Fluid Film Bearing and Rotor Bearing System Design and Optimization, ASME (1978) 1-28."
)
DUFRANE = (
    "K. F. Dufrane, J. W. Kannel, T. H. McCloskey: Wear of steam turbine journal bearings at low "
    "operating speeds. "
    "Journal of Lubrication Technology 105 (1983) 313-317."
)
LONG_FILM = (
    "Long film with heat exchange: an unnamed thermo-hydrodynamic model of a gear box bearing of a geared "
    "turbofan, reconstructed and made to conserve the flow by Babbitt (`babbitt validate long_film_table`). "
    f"{UNFOUND}"
)
SEGMENTS = (
    "Heat balance by segments: an unnamed method for a bearing with a groove in the loaded zone, reconstructed "
    f"by Babbitt (`babbitt validate grooved_segments`). {UNFOUND}"
)
DOWSON = (
    "D. Dowson: A generalized Reynolds equation for fluid-film lubrication. International Journal of Mechanical "
    "Sciences 4 (1962) 159-170."
)
BARUS = (
    "C. Barus: Isothermals, isopiestics and isometrics relative to viscosity. American J. Science 45 (1893) 87-96."
)
ROELANDS = (
    "C. J. A. Roelands: Correlational aspects of the viscosity-temperature-pressure relationship of lubricating "
    "oils. Thesis, Delft 1966."
)

GREENWOOD = (
    "J. A. Greenwood, J. H. Tripp: The contact of two nominally flat rough surfaces. Proceedings of the "
    "Institution of Mechanical Engineers 185 (1970) 625-633."
)
TIMOSHENKO = "S. Timoshenko, J. N. Goodier: Theory of Elasticity, 3rd ed., articles 28 and 43 (thick rings)."
ROACHE = (
    "P. J. Roache: Perspective: a method for uniform reporting of grid refinement studies. Journal of Fluids "
    "Engineering 116 (1994) 405-413."
)


def iso7902_citations(problem: DesignCase) -> Iterator[str]:
    """Procedure, and where the characteristics come from."""
    yield ISO_7902
    if problem.curves is Curves.COMPUTED:
        yield REYNOLDS
    if problem.friction is Friction.CURVE360:
        yield REVERSE_GEAR
    yield from _metal(problem)
    if problem.curves is Curves.CLOSED_FORM:
        yield DIN_31652


def film_citations(problem: FilmCase) -> Iterator[str]:
    """Equation, conditions of rupture, coefficients, laws of flow, heat, bore and contact, estimate of errors."""
    yield REYNOLDS
    yield from _metal(problem)
    if problem.cavitation is Cavitation.MASS_CONSERVING:
        yield JFO
    yield LUND
    if isinstance(problem.bearing.bore, WornBore):
        yield DUFRANE
    if problem.turbulence is not None:
        yield problem.turbulence.source
    if problem.heat is not None:
        yield DOWSON
    if problem.pressure_viscosity is not None:
        yield BARUS if problem.pressure_viscosity.law is PressureLaw.BARUS else ROELANDS
    if any(isinstance(one, ColumnLiner | HalfSpace) for one in problem.bearing.compliance):
        yield JOHNSON
    if any(isinstance(one, ElasticRing) for one in problem.bearing.compliance):
        yield TIMOSHENKO
    if problem.asperities is not None:
        yield GREENWOOD
    if problem.error_estimate:
        yield ROACHE


def long_film_citations(problem: LongFilmCase) -> Iterator[str]:
    """Equation and model of the infinitely long film."""
    yield REYNOLDS
    yield from _metal(problem)
    yield LONG_FILM


def segment_citations(problem: SegmentCase) -> Iterator[str]:
    """Equation and model of the film with a groove."""
    yield REYNOLDS
    yield from _metal(problem)
    yield SEGMENTS


def _metal(problem: JournalDesign) -> Iterator[str]:
    """The study that the limits of one metal rest on."""
    if problem.bearing.metal is not None and problem.bearing.metal.name == "B83":
        yield REVERSE_GEAR
