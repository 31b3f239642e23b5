"""How a case gave its numbers, in an engineer's words, for the report: one label and one line each."""

from __future__ import annotations

from collections.abc import Iterator

from babbitt.case.case_file import CaseFile
from babbitt.case.parts.clearance import (
    ClearanceInput,
    DeviationsClearance,
    DiametralClearance,
    FitClearance,
    LimitsClearance,
    RadialClearance,
    RelativeClearance,
)
from babbitt.case.parts.cooling import Cooling, CylinderHousing, Housing, InMachine, PedestalHousing
from babbitt.case.parts.load_and_speed import LOADS, SPEEDS
from babbitt.case.parts.materials import Materials, Structure
from babbitt.case.parts.surfaces import DrawingSurfaces
from babbitt.core.units import written
from babbitt.kinds.journal.case.journal import JournalBearing
from babbitt.kinds.journal.case.operating_point import OperatingPoint, stating
from babbitt.kinds.journal.case.supply_element import (
    GrooveElement,
    HoleElement,
    PocketElement,
    SlotElement,
    SupplyElementInput,
    UnevenPockets,
)
from babbitt.properties.fits import tolerance_limits
from babbitt.properties.materials import structural_material

Words = tuple[str, str]
"""A label and what stands there."""

PLACES = {
    "opposite": "opposite the load",
    "side": "at one side of the load",
    "both_sides": "at both sides of the load",
}
"""Where a supply element is, by the word of the case language."""


def words_of(
    bearing: JournalBearing,
    point: OperatingPoint | None,
    clearance_case: str,
    cooling: Cooling | None,
    materials: Materials,
) -> tuple[Words, ...]:
    """Say how the numbers of one bearing at one operating point were given.

    Parameters
    ----------
    bearing : JournalBearing
    point : OperatingPoint or None
    clearance_case : str
        minimum, mean or maximum.
    cooling, materials
        Of the bearing, with what it shares with its machine.

    Returns
    -------
    tuple of (str, str)
        Label and words.
    """
    return (
        *_of_words(bearing),
        *_of_geometry(bearing, point),
        *_of_clearance(bearing, clearance_case),
        *_of_materials(materials),
        *_of_operation(bearing, point),
        *_of_cooling(cooling),
    )


def _of_words(bearing: JournalBearing) -> Iterator[Words]:
    """What a bearing of a machine says of itself; what a whole file says stands before the bearings."""
    if isinstance(bearing, CaseFile):
        return
    for label, words in (("Source of the numbers", bearing.source), ("Notes", bearing.notes)):
        if words:
            yield label, words


def _of_geometry(bearing: JournalBearing, point: OperatingPoint | None) -> Iterator[Words]:
    if bearing.width_ratio is not None:
        yield "Width", f"{bearing.width_ratio:g} of the diameter"
    element = bearing.element_at(point)
    if element is not None:
        yield "Supply element", _element(element)
    surfaces = bearing.surfaces
    if isinstance(surfaces, DrawingSurfaces):
        profile = surfaces.profile_tolerance_bearing, surfaces.profile_tolerance_journal
        roundness = surfaces.roundness_tolerance_bearing, surfaces.roundness_tolerance_journal
        for label, (bore, journal) in (("Profile tolerance TFP", profile), ("Roundness tolerance TFR", roundness)):
            yield label, f"bore {_micrometres(bore)} µm, journal {_micrometres(journal)} µm"


def _element(element: SupplyElementInput) -> str:
    match element:
        case HoleElement():
            what = "hole" if element.number == 1 else f"{element.number} holes"
            return f"{what} {_millimetres(element.diameter)} mm, {PLACES[element.place]}"
        case SlotElement():
            sides = f"{_millimetres(element.length)} mm x {_millimetres(element.width)} mm"
            return f"slot {sides}, {PLACES[element.place]}"
        case PocketElement():
            return f"pocket {_millimetres(element.width)} mm wide, {PLACES[element.place]}"
        case GrooveElement():
            around = "the whole circumference" if element.kind == "groove_360" else "the unloaded half"
            return f"groove {_millimetres(element.width)} mm wide around {around}"
        case UnevenPockets():
            before, behind = _degrees(element.entry_angle), _degrees(element.exit_angle)
            size = f"{_millimetres(element.width)} mm wide, {_degrees(element.extent)} long each"
            return f"pockets centred {before} before and {behind} behind the load, {size}"


def _of_clearance(bearing: JournalBearing, clearance_case: str) -> Iterator[Words]:
    diameter, given = bearing.diameter, bearing.clearance
    yield "Clearance", _clearance(given, diameter)
    clearance = given.at_20_degrees(diameter)
    relative = clearance.relative(diameter)
    diametral = [_micrometres(value) for value in (clearance.minimum, clearance.mean, clearance.maximum)]
    permille = [f"{1e3 * value:.4g}" for value in (relative.minimum, relative.mean, relative.maximum)]
    for label, (least, mean, most), unit in (
        ("Diametral clearance", diametral, "µm"),
        ("Relative clearance", permille, "‰"),
    ):
        limits = f", minimum {least} {unit}, maximum {most} {unit}" if given.has_limits else ""
        yield label, f"mean {mean} {unit}{limits}"
    yield "Clearance case", clearance_case


def _clearance(given: ClearanceInput, diameter: float) -> str:
    match given:
        case FitClearance():
            bore, journal = (
                tolerance_limits(name, diameter).limits(diameter) for name in (given.bore, given.journal)
            )
            sizes = _sizes((bore.minimum, bore.maximum), (journal.minimum, journal.maximum))
            return f"Fit {given.bore}/{given.journal}: {sizes}"
        case LimitsClearance():
            return f"Limits of size: {_sizes(given.bore, given.journal)}"
        case DeviationsClearance():
            pairs = (" to ".join(_deviation(one) for one in pair) for pair in (given.bore, given.journal))
            return "Deviations from {} mm: bore {} µm, journal {} µm".format(_millimetres(diameter), *pairs)
        case RelativeClearance():
            return "Relative to the diameter"
        case RadialClearance():
            return "On the radius"
        case DiametralClearance():
            return "On the diameter"


def _sizes(bore: tuple[float, float], journal: tuple[float, float]) -> str:
    bores, journals = (" to ".join(_drawn(size) for size in sizes) for sizes in (bore, journal))
    return f"bore {bores} mm, journal {journals} mm"


def _of_materials(materials: Materials) -> Iterator[Words]:
    for label, material in (("Bearing material", materials.bearing), ("Journal material", materials.journal)):
        if material is not None:
            yield label, _structure(material)
    if materials.bearing_metal is not None:
        name = _named(materials.bearing_metal.name, materials.bearing_metal.metal().name)
        yield "Bearing metal", f"{name}, {materials.load_character or 'calm'} load"


def _structure(material: Structure) -> str:
    expansion = f"expansion {1e6 * material.expansion():.4g} × 10⁻⁶/K"
    if material.name is None:
        return expansion
    return f"{_named(material.name, structural_material(material.name).name)}, {expansion}"


def _named(given: str, catalogued: str) -> str:
    return given if given == catalogued else f"{given} ({catalogued})"


def _of_operation(bearing: JournalBearing, point: OperatingPoint | None) -> Iterator[Words]:
    if point is not None:
        yield "Operating point", point.name
    duty = stating(LOADS, bearing, point)
    if duty.specific_load is not None:
        yield "Load", f"{written(duty.specific_load, 'MPa')} on the projected area"
    speed = stating(SPEEDS, bearing, point).surface_speed
    if speed is not None:
        yield "Surface speed", written(speed, "m/s")


def _of_cooling(cooling: Cooling | None) -> Iterator[Words]:
    if cooling is None:
        return
    if cooling.housing is not None:
        yield "Housing", _housing(cooling.housing)
    if cooling.surface is not None:
        yield "Housing surface", f"{cooling.surface:.4g} m²"
    if cooling.air_speed is not None:
        yield "Air speed", written(cooling.air_speed, "m/s")
    if cooling.heat_transfer_coefficient is not None:
        yield "Heat transfer", f"{cooling.heat_transfer_coefficient:.4g} W/(m² K)"


def _housing(housing: Housing) -> str:
    match housing:
        case CylinderHousing():
            return (
                f"cylinder, diameter {_millimetres(housing.diameter)} mm, width {_millimetres(housing.width)} mm"
            )
        case PedestalHousing():
            return f"pedestal, height {_millimetres(housing.height)} mm, width {_millimetres(housing.width)} mm"
        case InMachine():
            return f"within a machine, surface {housing.factor:g} B D"


def _millimetres(length: float) -> str:
    return f"{1e3 * length:.6g}"


def _micrometres(length: float) -> str:
    return f"{1e6 * length + 0.0:.5g}"


def _drawn(size: float) -> str:
    """Write a size in mm as on a drawing: three decimals, a fourth where it counts.

    >>> _drawn(0.08), _drawn(0.0800125)
    ('80.000', '80.0125')
    """
    return f"{1e3 * size:.4f}".removesuffix("0")


def _deviation(length: float) -> str:
    shown = _micrometres(length)
    return f"+{shown}" if length > 0.0 else shown


def _degrees(angle: float) -> str:
    return written(angle, "°").replace(" ", "")
