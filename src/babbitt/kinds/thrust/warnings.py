"""What is doubtful about the films of a thrust bearing."""

from __future__ import annotations

from collections.abc import Iterator

from babbitt.core.notices import Notice
from babbitt.design.warnings import (
    LARGEST_RISE,
    OPEN_HEAT,
    warnings_about_heat_balance,
    warnings_about_heating,
    warnings_about_pressure,
)
from babbitt.kinds.thrust.design import ThrustDesign, ThrustState
from babbitt.kinds.thrust.state import CONTACT, condensed
from babbitt.kinds.thrust.values import effective_viscosity, hottest_oil, reynolds_number, rise_of_passing_oil

__all__ = ["LEAST_SHARE", "sharing_warnings"]

LEAST_SHARE = 0.01
"""Pad load over the mean below which a pad is as good as unloaded."""
CONSERVED = 1e-6
"""Error of oil, over what passes a pad, beyond which is no verdict; of heat `OPEN_HEAT`."""
FEWEST = 2.0
"""Pads loaded alike, (sum W)^2/sum W^2, that hold a collar square to the shaft at least; of two pads 1.5."""
LAMINAR_UP_TO = 1000.0
"""Reynolds number of a film, rho U h/mu, up to which it is taken as laminar: Ng and Pan's theory departs there."""


def sharing_warnings(design: ThrustDesign, state: ThrustState) -> Iterator[Notice]:
    """Warnings about the static share."""
    share, bearing = state.share, design.bearing
    even = state.films.height_for(share.mean_load)
    nearest = -float(bearing.departures().min())
    runout = sum(one.amplitude for one in design.runouts)
    if nearest >= even:
        pad = 1 + int(bearing.departures().argmin())
        yield Notice("W201", "uneven", {"pad": pad, "nearer": nearest, "film": even})
    elif runout > 0.0 and nearest + runout >= even:
        yield Notice("W201", "runout", {"runout": runout, "nearer": nearest + runout, "film": even})
    least = float(share.loads.min() / share.mean_load)
    if least < LEAST_SHARE:
        yield Notice("W201", "light", {"pad": 1 + int(share.loads.argmin()), "share": least})
    yield from warnings_about_pressure(max(pad.maximum_pressure for pad in share.states), "pad")
    yield from _about_the_model(design, state)
    films = [pad.minimum_film_thickness for pad in share.states]
    if (film := min(films)) <= CONTACT:
        pad = films.index(film)
        yield Notice("W207", values={
            "pad": 1 + pad, "film": film, "load": share.states[pad].load, "contact": CONTACT,
        })  # fmt: skip
    reynolds = reynolds_number(design, share, effective_viscosity(design, state), state.temperatures)
    if design.turbulence is None and reynolds > LAMINAR_UP_TO:
        yield Notice("W204", values={"film_reynolds_number": reynolds, "limit": LAMINAR_UP_TO})
    known = (*hottest_oil(share).values(), *([] if state.temperatures is None else [state.temperatures.trailing]))
    hottest = max(known, default=design.oil.effective_temperature)
    if hottest is not None:
        yield from warnings_about_heating(hottest, design.oil.supply_temperature, design.lubricant)


def _about_the_model(design: ThrustDesign, state: ThrustState) -> Iterator[Notice]:
    """Notices of what lies outside the validity of the model: these have no verdict."""
    share = state.share
    lost = max(pad.mass_balance_error for pad in share.states)
    if not lost < CONSERVED:
        yield Notice("W211", "oil", {"error": lost, "bound": CONSERVED})
    heat = 0.0 if state.temperatures is None else abs(state.temperatures.error)
    if not heat < OPEN_HEAT:
        yield Notice("W211", "heat", {"error": heat, "bound": OPEN_HEAT})
    else:
        yield from warnings_about_heat_balance(heat)
    if state.temperatures is None and (rise := rise_of_passing_oil(design, share)) > LARGEST_RISE:
        yield Notice("W127", "passing", {"rise": rise, "limit": LARGEST_RISE})
    damping = [condensed(pad, design.speed, share.bearing.inertia).imag for pad in share.states]
    if min(damping) < 0.0:
        pad, least = 1 + damping.index(min(damping)), float(min(damping) / design.speed)
        yield Notice("W212", "shaft", {"pad": pad, "damping": least})
    loads, number = share.loads, share.bearing.number
    alike = float(loads.sum() ** 2 / (loads**2).sum())
    if alike < min(FEWEST, 0.75 * number):
        most = float(loads.max() / loads.sum())
        yield Notice("W213", values={
            "pad": 1 + int(loads.argmax()), "share": most, "pads": number, "alike": alike,
        })  # fmt: skip
