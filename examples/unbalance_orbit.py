"""The film in a time integration of one's own: a small unbalance, against its linear response.

A journal with the mass of half a rotor stands in a grooved bearing and turns with an unbalance. LSODA integrates
ten revolutions with the force of the film at every place, ``result.film.force``. While the orbit is small its
amplitude is that of stiffness and damping, ``(K + i w C - w^2 m)^-1 F``.

Run it in this folder::

    python unbalance_orbit.py
"""

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

import babbitt as bb

Array = NDArray[Any]

MASS = 4000.0
"""kg, of the rotor on this bearing; the bearing carries its weight."""
GRAVITY = 9.81
"""m/s2"""
SPEED = 3000.0 * math.pi / 30.0
"""rad/s"""
UNBALANCES = (0.005, 0.05)
"""kg m"""
REVOLUTIONS = 10
"""Of which the last five are looked at."""
WHOLE_TURNS = 5


def rotating_force(unbalance: float) -> Array:
    """N, of an unbalance in kg m; the real part times exp(i w t) turns counter-clockwise, as the journal does."""
    return unbalance * SPEED**2 * np.array([1.0, -1.0j])


def bearing() -> bb.JournalBearing:
    """A round bore with two grooves full of oil, at one temperature."""
    return bb.JournalBearing(
        diameter="200 mm",
        width="120 mm",
        clearance=bb.relative_clearance("1.5 permille"),
        grooves=bb.grooves(["0 deg", "180 deg"], extent="20 deg", pressure="0 Pa"),
        lubricant="ISO VG 46",
        supply=bb.Supply(temperature="45 degC", pressure="0 Pa"),
        materials=bb.Materials(bearing="C45", journal="C45"),
        method="film",
        effective_temperature="55 degC",
        load=MASS * GRAVITY,
        speed=SPEED,
    )


def linear_amplitude(stiffness: Array, damping: Array, unbalance: float) -> Array:
    """Complex amplitudes of x and y, m."""
    dynamic = stiffness + 1j * SPEED * damping - SPEED**2 * MASS * np.eye(2)
    return np.asarray(np.linalg.solve(dynamic, rotating_force(unbalance)))


def orbit(film: Any, unbalance: float, start: Array) -> tuple[Array, Array]:
    """Times in s, and places x, y in m of the journal, begun on the orbit of the linear response."""
    x, y = film.position
    turning = rotating_force(unbalance)

    def rate(time: float, state: Array) -> Array:
        force = film.force(*state) + (turning * np.exp(1j * SPEED * time)).real - [0.0, MASS * GRAVITY]
        return np.concatenate([state[2:], force / MASS])

    moved, moving = start.real, (1j * SPEED * start).real
    end = 2.0 * math.pi * REVOLUTIONS / SPEED
    times = np.linspace(0.0, end, 180 * REVOLUTIONS + 1)
    found = solve_ivp(
        rate,
        (0.0, end),
        [x + moved[0], y + moved[1], *moving],
        method="LSODA",
        t_eval=times,
        rtol=1e-8,
        atol=1e-12,
    )
    return found.t, found.y[:2]


def amplitude_of(times: Array, places: Array) -> Array:
    """Complex amplitudes at the speed over the last whole turns, m."""
    last = times > times[-1] - 2.0 * math.pi * WHOLE_TURNS / SPEED * (1.0 - 1e-9)
    turning = np.exp(-1j * SPEED * times[last])
    return np.asarray(2.0 * (places[:, last] * turning).mean(axis=1))


def main() -> None:
    """Print the amplitudes beside each other."""
    result = bearing().solve()
    print("unbalance, kg m   amplitude   LSODA, um   linear, um   difference")
    for unbalance in UNBALANCES:
        linear = linear_amplitude(result.stiffness, result.damping, unbalance)
        found = amplitude_of(*orbit(result.film, unbalance, linear))
        for axis, one, other in zip("xy", found, linear, strict=True):
            share = abs(one - other) / abs(other)
            sizes = f"{1e6 * abs(one):9.2f}   {1e6 * abs(other):10.2f}   {share:10.1%}"
            print(f"{unbalance:15.3f}   {axis:9}   {sizes}")


if __name__ == "__main__":
    main()
