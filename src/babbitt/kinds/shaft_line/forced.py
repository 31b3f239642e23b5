"""All harmonics of one shaft speed, and their sum over a revolution."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.kinds.shaft_line.excitation import RunoutHarmonic, ThrustHarmonic
from babbitt.kinds.shaft_line.impedance import Response, respond
from babbitt.kinds.shaft_line.line import ShaftLine
from babbitt.kinds.shaft_line.natural import undamped_frequencies
from babbitt.kinds.shaft_line.pads import DynamicPads

__all__ = ["Forced", "Part", "crests", "forced"]

Array = NDArray[np.float64]
ComplexArray = NDArray[np.complex128]

SAMPLES = 1440
"""Per revolution at least, and per period of the fastest harmonic a twelfth of that."""
TURNS = 72
"""Angles between propeller and collar that are tried for the worst one."""
UNBOUNDED = 0.02
"""Relative distance from a natural frequency within which an undamped line has no bounded answer."""


@dataclass(frozen=True, eq=False)
class Part:
    """The answer to one harmonic; ``runout`` is what the face does under each pivot, m, complex, shape (z,)."""

    harmonic: ThrustHarmonic | RunoutHarmonic
    response: Response
    runout: ComplexArray

    @property
    def leans(self) -> bool:
        """Whether the face leans under the pads."""
        return isinstance(self.harmonic, RunoutHarmonic) and self.harmonic.leans

    @property
    def is_runout(self) -> bool:
        """Whether the collar, not the propeller, causes it."""
        return isinstance(self.harmonic, RunoutHarmonic)


@dataclass(frozen=True, eq=False)
class Forced:
    """Forces of the pads under all harmonics.

    Attributes
    ----------
    parts : tuple of Part
        In the order of the harmonics.
    """

    parts: tuple[Part, ...]

    @property
    def commensurate(self) -> bool:
        """Whether every harmonic repeats after one revolution."""
        return all(part.harmonic.order == round(part.harmonic.order) for part in self.parts)

    @property
    def angles(self) -> Array:
        """Samples of the angle of the shaft over one revolution, rad."""
        fastest = max((part.harmonic.order for part in self.parts), default=1.0)
        count = SAMPLES * max(1, math.ceil(fastest / 12.0))
        return 2.0 * math.pi * np.arange(count) / count

    def history(self, amplitudes: Sequence[ComplexArray], turned: float = 0.0) -> Array:
        """Sum over the harmonics at the angles of the shaft, shape (..., angles).

        Parameters
        ----------
        amplitudes : sequence of ndarray
            One complex array per part, such as the forces of the pads.
        turned : float
            Angle by which the propeller is turned on the shaft, rad.
        """
        angles = self.angles
        total = np.zeros((*np.shape(amplitudes[0]), angles.size))
        for part, amplitude in zip(self.parts, amplitudes, strict=True):
            order = part.harmonic.order
            shift = 0.0 if part.is_runout else order * turned
            total += (np.asarray(amplitude)[..., None] * np.exp(1j * (order * angles + shift))).real
        return total

    def forces(self) -> list[ComplexArray]:
        """Complex amplitudes N of each part, phases of the harmonics included."""
        return [part.response.forces for part in self.parts]

    def force_history(self, turned: float = 0.0) -> Array:
        """N_i over a revolution, N, shape (z, angles)."""
        return self.history(self.forces(), turned)

    def bounds(self) -> Array:
        """Sum of the amplitudes of all harmonics for each pad, N, shape (z,)."""
        return np.asarray(sum(np.abs(force) for force in self.forces()))

    def bounds_of(self, runout: bool) -> Array:
        """The same of the runout alone, or of the thrust alone."""
        z = self.parts[0].response.forces.size
        chosen = [np.abs(part.response.forces) for part in self.parts if part.is_runout is runout]
        return np.asarray(sum(chosen, np.zeros(z)))

    def peaks(self, turned: float = 0.0) -> Array:
        """Largest ``|N_i|`` over a revolution, N, shape (z,); the bound where harmonics do not repeat together."""
        if not self.commensurate:
            return self.bounds()
        history = self.force_history(turned)
        return np.maximum(crests(history), crests(-history))

    def worst_turn(self) -> tuple[float, float]:
        """Angle of the propeller on the shaft, rad, at which the largest pad force is largest, and that force,
        N.
        """
        thrusts = [part.harmonic.order for part in self.parts if not part.is_runout]
        if not thrusts or not self.commensurate:
            return 0.0, float(self.peaks().max())
        period = 2.0 * math.pi / math.gcd(*(round(order) for order in thrusts))
        turns = [k * period / TURNS for k in range(TURNS)]
        largest = [float(self.peaks(turned).max()) for turned in turns]
        place = int(np.argmax(largest))
        return turns[place], largest[place]


def crests(history: Array) -> Array:
    """Highest values over a revolution, shape (...), of even samples of it, shape (..., angles).

    The top of the parabola through the highest sample and its neighbours: 1440 samples alone would miss up to 4e-5
    of a blade frequency of order 4, and 3e-4 of order 12.
    """
    top = history.argmax(axis=-1)[..., None]
    before, at, after = (
        np.take_along_axis(history, (top + shift) % history.shape[-1], axis=-1)[..., 0] for shift in (-1, 0, 1)
    )
    bend = 2.0 * at - before - after
    return np.asarray(
        at + np.where(bend > 0.0, (after - before) ** 2 / (8.0 * np.where(bend > 0.0, bend, 1.0)), 0.0)
    )


def forced(
    line: ShaftLine,
    pads: DynamicPads,
    speed: float,
    thrusts: Sequence[ThrustHarmonic],
    runouts: Sequence[RunoutHarmonic],
) -> Forced:
    """Answer to all harmonics at a shaft speed.

    Parameters
    ----------
    line : ShaftLine
    pads : DynamicPads
    speed : float
        rad/s, positive.
    thrusts, runouts : sequence
        Harmonics at the propeller and at the collar.

    Raises
    ------
    InputError
        E203 for a speed that is not positive; E204 for a harmonic within 2 % of a natural frequency of a line
        without any damping.
    """
    if not (math.isfinite(speed) and speed > 0.0):
        raise InputError("E203", f"speed is {speed:g} rad/s; it must be positive.")
    parts: list[Part] = []
    still = np.zeros(pads.phases.size, dtype=complex)
    for thrust in thrusts:
        frequency = thrust.order * speed
        _require_bounded(line, pads, frequency)
        amplitude = thrust.amplitude * np.exp(1j * thrust.phase)
        parts.append(Part(thrust, respond(line, pads, frequency, amplitude, still), still))
    for runout in runouts:
        frequency = runout.order * speed
        _require_bounded(line, pads, frequency)
        under = runout.amplitude * np.exp(1j * (runout.phase - runout.order * pads.phases))
        felt = under * (1.0 + pads.wobble(frequency)) if runout.leans else under
        found = respond(line, pads, frequency, 0j, felt)
        parts.append(Part(runout, replace(found, gaps=found.gaps + felt - under), under))
    return Forced(tuple(parts))


def _require_bounded(line: ShaftLine, pads: DynamicPads, frequency: float) -> None:
    if line.propeller_damping > 0.0 or (line.seating is not None and line.seating.damping > 0.0):
        return
    if np.any(pads.film(frequency).imag > 0.0):
        return
    for natural in undamped_frequencies(line, pads, highest=1.1 * frequency):
        if abs(frequency / natural - 1.0) < UNBOUNDED:
            raise InputError(
                "E204",
                f"an excitation of {frequency / math.tau:.4g} Hz meets a natural frequency of "
                f"{natural / math.tau:.4g} Hz and nothing damps the line: the motion has no bound. Give the "
                f"damping "
                "of the propeller or of the films, or change the speed.",
            )
