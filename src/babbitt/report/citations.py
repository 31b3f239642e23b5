"""What to cite for the methods that a case uses."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from babbitt import __version__
from babbitt.case import Case, design_cases
from babbitt.case.designs import EveryDesign
from babbitt.kinds.footstep.model_case import HeelCase
from babbitt.kinds.footstep.states import Method
from babbitt.kinds.hydrostatic.jacking_model import JackingCase
from babbitt.kinds.hydrostatic.model import HydrostaticCase
from babbitt.kinds.journal.film.bore import WornBore
from babbitt.kinds.journal.film.model import FilmCase, PressureLaw
from babbitt.kinds.journal.grooved_long_bearing.model import SegmentCase
from babbitt.kinds.journal.infinitely_long_bearing.model import LongFilmCase
from babbitt.kinds.journal.iso7902.model import Curves, DesignCase, Friction
from babbitt.kinds.shaft_line.design import LineDesign
from babbitt.kinds.thrust.design import ThrustDesign
from babbitt.properties.lubricants import AstmD341, Exponential, Lubricant, Vogel, Walther
from babbitt.reynolds.model import Cavitation

BABBITT = f"The Babbitt developers: Babbitt {__version__}, calculation and design of fluid-film bearings, 2026."
ISO_7902 = (
    "ISO 7902-1:2020, with ISO 7902-2 and ISO 7902-3: Hydrodynamic plain journal bearings under steady-state "
    "conditions, "
    "circular cylindrical bearings (procedure; the characteristics are computed by Babbitt, not copied)."
)
REYNOLDS = (
    "O. Reynolds: On the theory of lubrication and its application to Mr. Beauchamp Tower's experiments. "
    "Philosophical Transactions of the Royal Society 177 (1886) 157-234 (equation and rupture condition)."
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
UNFOUND = "Author, title and journal could not be looked up: what rests on it alone counts as an assumption."
LONG_FILM = (
    "Long film with heat exchange: an unnamed thermo-hydrodynamic model of a gear box bearing of a geared "
    "turbofan, reconstructed and made to conserve the flow by Babbitt (`babbitt validate long_film_table`). "
    f"{UNFOUND}"
)
SEGMENTS = (
    "Heat balance by segments: an unnamed method for a bearing with a groove in the loaded zone, reconstructed "
    f"by Babbitt (`babbitt validate grooved_segments`). {UNFOUND}"
)
REVERSE_GEAR = (
    "Marine reverse gear: a study of its bearings, 2023, vol. 15, no. 5, p. 825 ff. of a Russian journal "
    f"(`babbitt validate reverse_gear`). {UNFOUND}"
)
KIRICHENKO = (
    "A. S. Kirichenko: study of a hydrostatic footstep with a screw-grooved heel in a three-screw pump. "
    "Problems of "
    "Tribology (2011) (equations, corrected; see `babbitt validate screw_heel_claims`)."
)
NARROW_GROOVE = (
    "J. H. Vohr, C. Y. Chow: Characteristics of herringbone-grooved, gas-lubricated journal bearings. Journal "
    "of Basic "
    "Engineering 87 (1965) 568-578 (narrow-groove theory)."
)
WITTRICK = (
    "W. H. Wittrick, F. W. Williams: A general algorithm for computing natural frequencies of elastic structures. "
    "Quarterly Journal of Mechanics and Applied Mathematics 24 (1971) 263-284."
)
SIDORIKA = (
    "I. N. Sidorika: dynamic load capacity of the main thrust bearing of a geared-diesel trawler. "
    "Eastern-European "
    "Journal of Enterprise Technologies 4/7 (70) (2014)."
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
WALTHER = "ASTM D341: Viscosity-temperature equations and charts for liquid petroleum or hydrocarbon products."
VOGEL = (
    "H. Vogel: Das Temperaturabhängigkeitsgesetz der Viskosität von Flüssigkeiten. Physikalische Zeitschrift 22 "
    "(1921) 645-646."
)
VISCOSITY_LAWS: dict[type, str] = {Walther: WALTHER, AstmD341: WALTHER, Vogel: VOGEL, Exponential: REYNOLDS}
"""Sources of the laws of viscosity over temperature."""


def citations_of(case: Case) -> tuple[str, ...]:
    """References for the software, the procedure, the characteristics and the lubricant of a case."""
    found = [BABBITT]
    designs = design_cases(case)
    standard = [design for design in designs if isinstance(design, DesignCase)]
    films = [design for design in designs if isinstance(design, FilmCase)]
    long_films = [design for design in designs if isinstance(design, LongFilmCase)]
    segments = [design for design in designs if isinstance(design, SegmentCase)]
    if standard:
        found.append(ISO_7902)
    kinds = {design.curves for design in standard}
    if Curves.COMPUTED in kinds or films or long_films or segments:
        found.append(REYNOLDS)
    if _rests_on_the_reverse_gear(case, designs):
        found.append(REVERSE_GEAR)
    if Curves.CLOSED_FORM in kinds:
        found.append(DIN_31652)
    if any(film.cavitation is Cavitation.MASS_CONSERVING for film in films):
        found.append(JFO)
    if films:
        found.append(LUND)
    if any(isinstance(film.bearing.bore, WornBore) for film in films):
        found.append(DUFRANE)
    if long_films:
        found.append(LONG_FILM)
    if segments:
        found.append(SEGMENTS)
    heels = [design for design in designs if isinstance(design, HeelCase)]
    if heels:
        found.append(KIRICHENKO)
    if any(heel.method is Method.NARROW_GROOVE for heel in heels):
        found.append(NARROW_GROOVE)
    hydrostatic = [design for design in designs if isinstance(design, HydrostaticCase)]
    if hydrostatic or any(isinstance(design, JackingCase) for design in designs):
        found.append(REYNOLDS)
    if any(isinstance(design, ThrustDesign | LineDesign) for design in designs):
        found.append(REYNOLDS)
    if any(isinstance(design, LineDesign) for design in designs):
        found += [SIDORIKA, WITTRICK]
    found += [source for design in designs for source in _laws(design)]
    oils = {oil.name: oil for oil in map(_oil, designs) if oil is not None}
    found += [f"{oil.name}: {oil.source}" for oil in oils.values()]
    return tuple(dict.fromkeys(found))


def _rests_on_the_reverse_gear(case: Case, designs: Iterable[EveryDesign]) -> bool:
    """Whether a number comes from that study alone: limits of its metal, its friction, its load share."""
    metals = [getattr(getattr(design, "bearing", design), "metal", None) for design in designs]
    return (
        case.kind == "overhung_coupling"
        or any(metal is not None and metal.name == "B83" for metal in metals)
        or any(isinstance(design, DesignCase) and design.friction is Friction.CURVE360 for design in designs)
    )


def _laws(design: EveryDesign) -> Iterator[str]:
    """Sources of the laws of a design: turbulence, own temperatures, viscosity over pressure and temperature."""
    if isinstance(design, FilmCase | ThrustDesign) and design.turbulence is not None:
        yield design.turbulence.source
    if isinstance(design, FilmCase):
        if design.heat is not None:
            yield DOWSON
        if design.pressure_viscosity is not None:
            yield BARUS if design.pressure_viscosity.law is PressureLaw.BARUS else ROELANDS
    oil = _oil(design)
    if oil is not None and (source := VISCOSITY_LAWS.get(type(oil.viscosity_law))) is not None:
        yield source


def _oil(design: EveryDesign) -> Lubricant | None:
    """The oil of a design, where the case names one rather than a viscosity."""
    match design:
        case HeelCase() | JackingCase():
            return None
        case HydrostaticCase():
            return design.oil.lubricant
        case _:
            return design.lubricant
