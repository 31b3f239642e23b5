"""Recessed hydrostatic and hybrid bearings: pads, thrust rings, journal bearings, jacking pockets."""

from babbitt.core.kind import SPEED_AND_LOAD, Kind

HERE = "babbitt.kinds.hydrostatic"

PRESSURE_AND_LOAD = (("supply.pressure", "supply.pump_flow", "speed"), ("load",))
"""A pump carries the film, whether the surfaces slide or not."""


def _recessed(
    name: str,
    description: str,
    model: str,
    meanings: str,
    envelope: tuple[tuple[str, ...], tuple[str, ...]] = PRESSURE_AND_LOAD,
) -> Kind:
    return Kind(
        name=name,
        description=description,
        model=f"{HERE}.case.{model}",
        template=f"{HERE}:{name}.yaml",
        views={"film": f"{HERE}.view:FILM", "quick": f"{HERE}.view:QUICK"},
        comparison=f"{HERE}.comparison:compare",
        meanings=f"{HERE}.report.words:{meanings}",
        vocabulary=f"{HERE}.report.words:HYDROSTATIC_WORDS",
        envelope=envelope,
    )


KINDS = (
    _recessed(
        "hydrostatic_pad",
        "hydrostatic pad with one recess: round, annular, rectangular",
        "hydrostatic_pad:HydrostaticPadCase",
        "OF_RUNNERS",
    ),
    _recessed(
        "hydrostatic_thrust_ring",
        "hydrostatic thrust ring with several recesses and tilt",
        "hydrostatic_thrust_ring:HydrostaticThrustRingCase",
        "OF_RUNNERS",
    ),
    _recessed(
        "hydrostatic_journal",
        "recessed journal bearing, hydrostatic or hybrid",
        "hydrostatic_journal:HydrostaticJournalCase",
        "OF_RECESSED_JOURNALS",
        SPEED_AND_LOAD,
    ),
    Kind(
        name="jacking_pocket",
        description="jacking pockets that lift a shaft before it turns",
        model=f"{HERE}.case.jacking:JackingPocketCase",
        template=f"{HERE}:jacking_pocket.yaml",
        views={"film": f"{HERE}.view:JACKING_FILM", "quick": f"{HERE}.view:JACKING_QUICK"},
        comparison=f"{HERE}.comparison:compare_jacking",
        meanings=f"{HERE}.report.words:JACKING",
        envelope=(("relief_pressure", "viscosity"), ("load",)),
    ),
)
