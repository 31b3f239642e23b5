"""The bore and what feeds it: lands between grooves, pockets, holes and steps."""

from __future__ import annotations

import math
from dataclasses import dataclass

from babbitt.core.notices import InputError

__all__ = ["END_DAM", "Land", "Pocket", "Step", "check_lands", "grooved_bore"]

END_DAM = 0.025
"""Share of the width over which the pressure of a groove as wide as the bearing falls to that of the side, either
end. Assumption: real grooves end before the edge, or leak through their ends by an amount that no film knows."""


@dataclass(frozen=True)
class Land:
    """Part of the bore between two groove edges.

    Attributes
    ----------
    start_angle, end_angle : float
        rad, counter-clockwise from +x, end above start, at most one turn apart.
    clearance : float or None
        Radius of the land's bore less that of the journal, m. None: the clearance of the bearing.
    centre : tuple of float
        Centre of the land's bore, m (lobes, offset halves).
    start_pressure, end_pressure : float
        Gauge pressures of the grooves at either edge, Pa.
    profile : tuple of float
        Departure of the bore from its circle, m, outward positive, at equally spaced angles from edge to edge
        (wear, measured form). Empty: none.
    start_fill : float
        Share of the gap that the groove from which the journal enters the land can fill, 0 to 1: 1 flooded, less
        where it is starved. A starved groove stands at the cavitation pressure.
    """

    start_angle: float
    end_angle: float
    clearance: float | None = None
    centre: tuple[float, float] = (0.0, 0.0)
    start_pressure: float = 0.0
    end_pressure: float = 0.0
    profile: tuple[float, ...] = ()
    start_fill: float = 1.0


@dataclass(frozen=True)
class Pocket:
    """A rectangular supply of part width, held at its pressure; a hole is a square of the same area.

    Attributes
    ----------
    centre_angle, extent : float
        rad.
    axial_centre, axial_length : float
        m, from the mid-plane.
    pressure : float
        Gauge, Pa.
    fill : float
        Share of the gap behind it that it can fill, 0 to 1: 1 flooded, less where it is starved; it stands then
        at the cavitation pressure.
    closed : bool
        Whether nothing feeds it, so that its pressure follows the journal: stiffness and damping count that. The
        pressure at which its net flow vanishes must be given.
    """

    centre_angle: float
    extent: float
    axial_length: float
    axial_centre: float = 0.0
    pressure: float = 0.0
    fill: float = 1.0
    closed: bool = False

    @classmethod
    def hole(
        cls, angle: float, diameter: float, bore: float, axial_centre: float = 0.0, pressure: float = 0.0
    ) -> Pocket:
        """A round hole of ``diameter`` in a bearing of diameter ``bore``, both m."""
        side = 0.5 * math.sqrt(math.pi) * diameter
        return cls(angle, 2.0 * side / bore, side, axial_centre, pressure)


@dataclass(frozen=True)
class Step:
    """A rectangle of the bore that lies deeper and is part of the film: dam, relief track, shallow pocket.

    Attributes
    ----------
    centre_angle, extent : float
        rad.
    axial_centre, axial_length : float
        m, from the mid-plane.
    depth : float
        m; negative where the rectangle stands out.
    """

    centre_angle: float
    extent: float
    axial_length: float
    depth: float
    axial_centre: float = 0.0


def check_lands(lands: tuple[Land, ...], cavitation_pressure: float) -> None:
    """Refuse lands that are empty, overlap, do not close, or are supplied below the cavitation pressure."""
    if not lands:
        raise InputError("E101", "lands is empty; a film needs at least one land.")
    turn = 2.0 * math.pi
    for land in lands:
        extent = land.end_angle - land.start_angle
        if not 0.0 < extent <= turn * (1.0 + 1e-12):
            raise InputError("E101", f"a land runs from {land.start_angle} to {land.end_angle} rad; "
                             "its end must lie above its start by at most one turn.")  # fmt: skip
        for pressure in (land.start_pressure, land.end_pressure):
            if not pressure >= cavitation_pressure:
                raise InputError("E101", f"a groove has {pressure} Pa, less than the cavitation pressure "
                                 f"{cavitation_pressure} Pa; raise the supply pressure.")  # fmt: skip
    ordered = sorted(lands, key=lambda land: land.start_angle % turn)
    for land, following in zip(ordered, [*ordered[1:], ordered[0]], strict=True):
        distance = (following.start_angle - land.start_angle) % turn or turn
        if land.end_angle - land.start_angle > distance * (1.0 + 1e-12) + 1e-12:
            raise InputError("E101", f"the land that starts at {land.start_angle} rad overlaps that which starts "
                             f"at {following.start_angle} rad.")  # fmt: skip
        if not math.isclose(land.end_pressure, following.start_pressure, rel_tol=1e-9, abs_tol=1e-6):
            here, there = land.end_pressure, following.start_pressure
            raise InputError(
                "E101", f"a groove has one pressure; that behind {land.end_angle} rad has {here} and {there} Pa."
            )


def grooved_bore(
    groove_angles: tuple[float, ...], groove_extent: float, pressure: float = 0.0
) -> tuple[Land, ...]:
    """Lands of a round bore with equal axial grooves as wide as the bearing.

    Parameters
    ----------
    groove_angles : tuple of float
        Middles of the grooves, rad, ascending, within one turn.
    groove_extent : float
        Angle that each groove takes, rad; zero is a line of supply.
    pressure : float
        Gauge supply pressure of all grooves, Pa.

    Returns
    -------
    tuple of Land

    Examples
    --------
    >>> import math
    >>> [round(math.degrees(land.end_angle - land.start_angle)) for land in grooved_bore((0.0, math.pi), 0.35)]
    [160, 160]
    """
    ends = (*groove_angles[1:], groove_angles[0] + 2.0 * math.pi)
    half = 0.5 * groove_extent
    return tuple(
        Land(start + half, end - half, start_pressure=pressure, end_pressure=pressure)
        for start, end in zip(groove_angles, ends, strict=True)
    )
