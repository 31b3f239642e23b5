"""What is doubtful about the films of a thrust bearing."""

from __future__ import annotations

from collections.abc import Iterator

from babbitt.core.notices import Notice
from babbitt.design.warnings import LARGEST_RISE, OPEN_HEAT, warnings_about_heating, warnings_about_pressure
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
    yield from warnings_about_pressure(max(pad.maximum_pressure for pad in share.states), "in the film of a pad")
    yield from _about_the_model(design, state)
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
        yield from warnings_about_heating(hottest, design.oil.supply_temperature, design.lubricant)


def _about_the_model(design: ThrustDesign, state: ThrustState) -> Iterator[Notice]:
    """Notices of what lies outside the validity of the model: these have no verdict."""
    share = state.share
    lost = max(pad.mass_balance_error for pad in share.states)
    if not lost < CONSERVED:
        yield Notice("W211", f"oil by {lost:.1e} of what passes a pad, bound {CONSERVED:g}")
    heat = 0.0 if state.temperatures is None else abs(state.temperatures.error)
    if not heat < OPEN_HEAT:
        yield Notice("W211", f"heat by {heat:.1e} of the friction power, bound {OPEN_HEAT:g}")
    if state.temperatures is None and (rise := rise_of_passing_oil(design, share)) > LARGEST_RISE:
        yield Notice(
            "W127", f"friction warms the oil that passes the pads by {rise:.0f} K, > {LARGEST_RISE:.0f} K"
        )
    damping = [condensed(pad, design.speed, share.bearing.inertia).imag for pad in share.states]
    if min(damping) < 0.0:
        said = f"pad {1 + damping.index(min(damping))} at the frequency of the shaft"
        yield Notice("W212", f"{said}, {min(damping) / design.speed:.3g} N s/m")
    loads, number = share.loads, share.bearing.number
    alike = float(loads.sum() ** 2 / (loads**2).sum())
    if alike < min(FEWEST, 0.75 * number):
        yield Notice(
            "W213",
            f"pad {1 + int(loads.argmax())} carries {loads.max() / loads.sum():.0%} of the thrust; {number} pads "
            f"carry as {alike:.1f} loaded alike",
        )
