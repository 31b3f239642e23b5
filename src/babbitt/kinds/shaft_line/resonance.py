"""Where a line resonates, and how far its excitations are from there.

An excitation resonates at the maxima of its own response that exceed twice the static pad force, and at the
damped modes that so little damps that they could; both with films and tilts at that frequency. Undamped
frequencies on the stiffness of films at rest are information only.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from babbitt.kinds.shaft_line.damped import DampedMode, damped_modes
from babbitt.kinds.shaft_line.excitation import RunoutHarmonic
from babbitt.kinds.shaft_line.losses import separation
from babbitt.kinds.shaft_line.model import LineState
from babbitt.kinds.shaft_line.natural import Mode
from babbitt.kinds.shaft_line.response import THRUST, ResponsePeak, response_peaks

__all__ = ["NEAR", "Encounter", "Resonances", "lobes_of", "resonances_about", "resonances_of"]

NEAR = 0.2
"""Relative distance from a resonance that is advised, as for other shaft vibration."""
BELOW, ABOVE = 3.0, 2.0
"""Peaks are sought from the lowest excitation over this to the highest times that, and beyond the first mode."""
ABOUT = 1.5
"""The same about one excitation of many, as for each speed of a map."""
COARSE = 1.03
"""Ratio of neighbouring frequencies there."""


@dataclass(frozen=True)
class Encounter:
    """An excitation and the resonance next to it.

    Attributes
    ----------
    excitation : float
        rad/s.
    order : float
        Frequency over that of the shaft.
    resonance : float
        rad/s.
    amplification : float or None
        Of the pad force at a peak of the response; None for a damped mode.
    damping_ratio : float or None
        Of a damped mode.
    """

    excitation: float
    order: float
    resonance: float
    amplification: float | None = None
    damping_ratio: float | None = None

    @property
    def separation(self) -> float:
        """Relative distance."""
        return separation(self.excitation, self.resonance)


@dataclass(frozen=True)
class Resonances:
    """Resonances of a line.

    Attributes
    ----------
    modes : tuple of DampedMode
        Those that belong to undamped ones, and others that resonate.
    peaks : tuple of ResponsePeak
    lowest, highest : float
        Frequencies between which peaks were sought, rad/s.
    encounters : tuple of Encounter
        The nearest resonance of each excitation that has an amplitude.
    """

    modes: tuple[DampedMode, ...]
    peaks: tuple[ResponsePeak, ...]
    lowest: float
    highest: float
    encounters: tuple[Encounter, ...]

    def frequencies(self, lobes: float) -> tuple[float, ...]:
        """Of all resonances that a runout of so many lobes, or the thrust, may meet, rad/s, low ones first."""
        peaks = (peak.frequency for peak in self.peaks if peak.lobes == lobes)
        return tuple(sorted((*peaks, *(mode.frequency for mode in self.modes if mode.resonates))))


def lobes_of(harmonic: object) -> float:
    """Which response a harmonic belongs to: that of a runout of so many lobes, or of the thrust."""
    return harmonic.order if isinstance(harmonic, RunoutHarmonic) else THRUST


def resonances_of(state: LineState, undamped: Sequence[Mode]) -> Resonances:
    """Resonances of a line at its speed.

    Parameters
    ----------
    state : LineState
    undamped : sequence of Mode
        Whose damped counterparts are given, too.
    """
    line, pads = state.duty.line, state.pads
    exciting = [part for part in state.forced.parts if part.harmonic.amplitude > 0.0]
    frequencies = [part.response.frequency for part in exciting]
    highest = ABOVE * max(frequencies, default=0.0)
    modes = damped_modes(line, pads, undamped, highest)
    if not exciting:
        return Resonances(modes, (), 0.0, 0.0, ())
    first = min((mode.frequency for mode in modes), default=0.0)
    lowest, highest = min(frequencies) / BELOW, max(highest, ABOVE * first)
    peaks: list[ResponsePeak] = []
    for lobes in sorted({lobes_of(part.harmonic) for part in exciting}):
        about = [(mode.frequency, mode.damping_ratio) for mode in modes]
        peaks += response_peaks(line, pads, lobes, lowest, highest, about)
    return Resonances(modes, tuple(peaks), lowest, highest, _encounters(state, modes, peaks))


def resonances_about(state: LineState, shown: float = 0.0) -> Resonances:
    """The same about each excitation only, with coarser steps: for every speed of a map.

    Parameters
    ----------
    state : LineState
    shown : float
        Frequency up to which damped modes are given at least, rad/s.
    """
    line, pads = state.duty.line, state.pads
    exciting = [part for part in state.forced.parts if part.harmonic.amplitude > 0.0]
    if not exciting:
        return Resonances((), (), 0.0, 0.0, ())
    frequencies = [part.response.frequency for part in exciting]
    lowest, highest = min(frequencies) / ABOUT, max(frequencies) * ABOUT
    modes = damped_modes(line, pads, (), max(highest, shown))
    about = [(mode.frequency, mode.damping_ratio) for mode in modes]
    peaks: list[ResponsePeak] = []
    for part in exciting:
        nu = part.response.frequency
        peaks += response_peaks(line, pads, lobes_of(part.harmonic), nu / ABOUT, nu * ABOUT, about, COARSE)
    return Resonances(modes, tuple(peaks), lowest, highest, _encounters(state, modes, peaks))


def _encounters(
    state: LineState, modes: Sequence[DampedMode], peaks: Sequence[ResponsePeak]
) -> tuple[Encounter, ...]:
    found = []
    for part in state.forced.parts:
        if not part.harmonic.amplitude > 0.0:
            continue
        nu, order = part.response.frequency, part.harmonic.order
        met = [
            Encounter(nu, order, peak.frequency, peak.amplification)
            for peak in peaks
            if peak.lobes == lobes_of(part.harmonic)
        ]
        met += [Encounter(nu, order, mode.frequency, None, mode.damping_ratio) for mode in modes if mode.resonates]
        if met:
            found.append(min(met, key=lambda one: one.separation))
    return tuple(found)
