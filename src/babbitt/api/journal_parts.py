"""Parts of a journal bearing: what feeds the film, the form of its surfaces, heat, load.

Each is the part of the case language of the same fields, with short names.
"""

from __future__ import annotations

from babbitt.api.part import OwnPart
from babbitt.case.parts import position, walls
from babbitt.kinds.journal.case import (
    dynamic_load,
    film_features,
    film_heat,
    film_oil,
    film_surface,
    grooved_segments,
    heat_exchange,
    mixed_friction,
    oil_system,
    operating_point,
    supply_element,
)

__all__ = [
    "ConductingBush",
    "ConductingHousing",
    "ConductingJournal",
    "Displacement",
    "EdgeCrowning",
    "Groove",
    "GrooveElement",
    "HeatExchange",
    "Hole",
    "HoleElement",
    "Liner",
    "LoadTable",
    "Lobes",
    "MeasuredBore",
    "Misalignment",
    "MixedFriction",
    "OilLine",
    "OilPump",
    "OilSystem",
    "OperatingPoint",
    "ParabolicCrowning",
    "Pocket",
    "PocketElement",
    "Position",
    "PressureDam",
    "PressureViscosity",
    "PumpPoint",
    "Relief",
    "RotatingLoad",
    "RoundBore",
    "SegmentOptions",
    "SlotElement",
    "Step",
    "TableCrowning",
    "TaperedBore",
    "UnevenPockets",
    "Walls",
    "WornBore",
]


class Groove(OwnPart, film_features.GrooveInput):
    """An axial groove as wide as the bearing."""


class Pocket(OwnPart, film_features.PocketInput):
    """A rectangular pocket, narrower than the bearing; one of 360 deg is a circumferential groove."""


class Hole(OwnPart, film_features.SupplyHoleInput):
    """A round hole in the bore."""


class Misalignment(OwnPart, film_features.MisalignmentInput):
    """Misalignment of the journal axis in the bore."""


class RoundBore(OwnPart, film_features.RoundBoreInput):
    """A round bore."""


class Lobes(OwnPart, film_features.LobedBoreInput):
    """A bore of lobes: every land between two grooves is an arc of a larger circle."""


class TaperedBore(OwnPart, film_features.TaperedBoreInput):
    """Lands that are cut back where the oil enters."""


class Relief(OwnPart, film_features.ReliefInput):
    """The track of a pressure dam bearing that relieves its loaded land."""


class PressureDam(OwnPart, film_features.PressureDamBoreInput):
    """A round bore with a recess that ends in a dam, to load the journal from the other side."""


class WornBore(OwnPart, film_features.WornBoreInput):
    """A bore worn by its journal."""


class MeasuredBore(OwnPart, film_features.MeasuredBoreInput):
    """A bore as it was measured."""


class Step(OwnPart, film_surface.StepInput):
    """A rectangle of the bore that lies deeper and belongs to the film."""


class ParabolicCrowning(OwnPart, film_surface.ParabolicCrowningInput):
    """A journal that is a barrel."""


class EdgeCrowning(OwnPart, film_surface.EdgeCrowningInput):
    """A journal, or bore, that is relieved near its edges."""


class TableCrowning(OwnPart, film_surface.TableCrowningInput):
    """A journal as it was measured along its axis."""


class Displacement(OwnPart, film_surface.DisplacementInput):
    """What the gap gains over the bore, by elastic or thermal displacement of its surfaces."""


class Liner(OwnPart, film_heat.LinerInput):
    """The layer of bearing metal on the bush."""


class ConductingBush(OwnPart, film_heat.ConductingBushInput):
    """The bush, or what lies next to the bore."""


class ConductingHousing(OwnPart, film_heat.ConductingHousingInput):
    """What surrounds the bush."""


class ConductingJournal(OwnPart, walls.ConductingJournalInput):
    """The journal, which has one temperature."""


class Walls(OwnPart, film_heat.WallsInput):
    """Bush, housing and journal, which take heat from the film."""


class PressureViscosity(OwnPart, film_oil.PressureViscosityInput):
    """How the viscosity grows with the pressure in the film."""


class HoleElement(OwnPart, supply_element.HoleElement):
    """One hole, or a row of holes, at each place."""


class SlotElement(OwnPart, supply_element.SlotElement):
    """A slot at each place, computed as round holes of the same perimeter and area."""


class PocketElement(OwnPart, supply_element.PocketElement):
    """One pocket at each place."""


class GrooveElement(OwnPart, supply_element.GrooveElement):
    """A groove around the whole circumference or its unloaded half."""


class UnevenPockets(OwnPart, supply_element.UnevenPockets):
    """Two pockets at different angles from the load; they set the angular span."""


class RotatingLoad(OwnPart, dynamic_load.RotatingLoadInput):
    """A load of constant size that rotates, as that of an unbalance."""


class LoadTable(OwnPart, dynamic_load.LoadTableInput):
    """A load by table over the angle that the journal turns."""


class MixedFriction(OwnPart, mixed_friction.MixedFrictionInput):
    """Contact of asperities, for the Stribeck curve with its mixed branch."""


class OilSystem(OwnPart, oil_system.OilSystemInput):
    """Pump, header and a line to each bearing of a machine."""


class OilPump(OwnPart, oil_system.PumpInput):
    """The pump of an oil system."""


class PumpPoint(OwnPart, oil_system.PumpPoint):
    """One point of the curve of a pump."""


class OilLine(OwnPart, oil_system.LineInput):
    """From the header to one bearing: a tube, an orifice, or both."""


class OperatingPoint(OwnPart, operating_point.OperatingPoint):
    """One of several operating points. What it does not give is taken from the bearing."""


class Position(OwnPart, position.PositionInput):
    """Where the journal centre stands."""


class HeatExchange(OwnPart, heat_exchange.HeatExchangeInput):
    """Where heat goes other than into the oil, and how the published calculation is repeated."""


class SegmentOptions(OwnPart, grooved_segments.SegmentsInput):
    """What the heat balance by segments knows of the film."""
