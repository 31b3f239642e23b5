"""What is doubtful about the films of a thrust bearing."""

from __future__ import annotations

from collections.abc import Iterator

from babbitt.design.doubts import doubt_about_pressure, doubts_about_heating
from babbitt.notices import Notice
from babbitt.thrust.design import ThrustDesign, ThrustState
from babbitt.thrust.state import CONTACT
from babbitt.thrust.values import effective_viscosity, hottest_oil, reynolds_number

__all__ = ["LEAST_SHARE", "share_doubts"]

LEAST_SHARE = 0.01
"""Pad load over the mean below which a pad is as good as unloaded."""
LAMINAR_UP_TO = 1000.0
"""Reynolds number of a film, rho U h/mu, up to which it is taken as laminar: Ng and Pan's theory departs there."""


def share_doubts(design: ThrustDesign, state: ThrustState) -> Iterator[Notice]:
    """Doubts about the static share."""
    share, bearing = state.share, design.bearing
    even = state.films.height_for(share.mean_load)
    nearest = -float(bearing.departures().min())
    runout = sum(one.amplitude for one in design.runouts)
    if nearest >= even:
        yield Notice(
            "W201",
            f"tilt and heights bring pad {1 + int(bearing.departures().argmin())} {nearest * 1e6:.1f} µm "
            "nearer to the collar, more than the "
            f"film of {even * 1e6:.1f} µm that an even share has",
        )
    elif runout > 0.0 and nearest + runout >= even:
        yield Notice(
            "W201",
            f"tilt, heights and a runout of {runout * 1e6:.1f} µm bring a pad up to "
            f"{(nearest + runout) * 1e6:.1f} µm nearer to the collar, more than "
            f"the film of {even * 1e6:.1f} µm that an even share has",
        )
    least = float(share.loads.min() / share.mean_load)
    if least < LEAST_SHARE:
        yield Notice("W201", f"pad {1 + int(share.loads.argmin())} carries {least:.2%} of the mean load")
    yield from doubt_about_pressure(max(pad.maximum_pressure for pad in share.states), "in the film of a pad")
    films = [pad.minimum_film_thickness for pad in share.states]
    if min(films) <= CONTACT:
        yield Notice(
            "W207",
            f"pad {1 + films.index(min(films))} would run on {min(films) * 1e6:.2f} µm under "
            f"{share.states[films.index(min(films))].load / 1e3:.0f} kN; surfaces touch below "
            f"{CONTACT * 1e6:g} µm",
        )
    reynolds = reynolds_number(design, share, effective_viscosity(design, state), state.temperatures)
    if design.turbulence is None and reynolds > LAMINAR_UP_TO:
        yield Notice("W204", f"Re = {reynolds:.0f} > {LAMINAR_UP_TO:.0f}")
    known = (*hottest_oil(share).values(), *([] if state.temperatures is None else [state.temperatures.trailing]))
    hottest = max(known, default=design.oil.effective_temperature)
    if hottest is not None:
        yield from doubts_about_heating(hottest, design.oil.supply_temperature, design.lubricant)
