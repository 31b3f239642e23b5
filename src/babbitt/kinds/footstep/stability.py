"""Stability of the steady states of a footstep: pressure settles at once, heat is slow.

Oil is nearly incompressible, so that the pressure of the rim settles in about 0.1 ms; the oil of groove,
clearance and face gap is exchanged in 1 to 24 s. Pressure and flows are therefore in balance at every instant
and only heat has a history: it is carried along the groove with the oil and held by the oil of the clearance,
which is of one temperature. Recess and face gap of the study's equations warm their oil by a few tenths of a
kelvin and are in balance too.

With the reciprocal viscosity ``phi = mu0/mu`` the heat of the groove is a linear law of transport, ``dphi/dt + v
dphi/ds = S(q)`` with ``v = |q|/h_k`` and ``S = alpha mu0 M3/(12 rho_c h_k⁴)`` (from G2), whose linearised form
has the closed solution ``phi'(s) = phi'(0) e^{-lambda s/v} + B (1 - e^{-lambda s/v})/lambda``. What remains is
one function F(lambda), the disturbed balance of the rim: zeros with a positive real part are disturbances that
grow. F(0) is dR/dQ_k along the steady balance and F(infinity) that with frozen temperatures, which is negative;
so a state where R rises (hot) always has a growing disturbance. Oscillations are counted by the principle of the
argument. The thermal loop gain is ``1 - F(0)/F(infinity)``.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from babbitt.kinds.footstep.face import number, quadrature
from babbitt.kinds.footstep.model import Footstep
from babbitt.kinds.footstep.superposition import Balance, GrooveChannel, GroovedFootstep, SmoothFootstep
from babbitt.kinds.footstep.thermal_films import ThermalFilms

__all__ = ["RimDisturbance", "Stability", "stability_of_films", "stability_of_grooved", "stability_of_smooth"]

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
POINTS = 120
"""Gauss points along the groove, on the logarithm of the reciprocal viscosity."""
STEP = 1e-6
"""Relative step of central differences."""
HIGHEST = 2000.0
"""Largest frequency of the count of oscillations, over the rate at which the oil of the groove is exchanged."""
BALANCED_AND_FROZEN = np.array([0j, np.inf + 0j])
"""Rates of growth, 1/s, at which temperatures are in balance and at which they do not follow."""
SERIES_BELOW = 1e-4
"""Where (1 - e^{-x})/x is taken from its series: the next term is below 1e-13."""


@dataclass(frozen=True)
class Stability:
    """Whether a steady state lasts.

    Attributes
    ----------
    stable : bool
        No disturbance of the temperatures grows.
    loop_gain : float
        Share of a small lasting disturbance that comes back through temperature, viscosity and flow; at 1 or more
        it runs away in one direction.
    """

    stable: bool
    loop_gain: float


@dataclass(frozen=True)
class RimDisturbance:
    """Linearised balance of the rim of a grooved heel by superposition, per flow of the groove.

    Parameters
    ----------
    model : GroovedFootstep
    at : Balance
        The steady state; its groove flow, m³/s, is positive towards the rim.
    """

    model: GroovedFootstep
    at: Balance

    @property
    def footstep(self) -> Footstep:
        """Of the model."""
        return self.model.footstep

    @property
    def channel(self) -> GrooveChannel:
        """Of the model."""
        return self.model.channel

    @property
    def flow(self) -> float:
        """Q_k, m³/s."""
        return float(self.at.groove_flow)

    @property
    def exchange_rate(self) -> float:
        """v/l, 1/s: how often the oil of the groove is exchanged."""
        return abs(self.flow) / (self.channel.width * self.channel.depth * self.channel.length)

    def _along(self) -> tuple[Array, Array, Array]:
        """Place over length from the inlet, weights, and phi there."""
        oil = self.footstep.oil
        hot = float(self.at.groove_temperature)
        inlet = oil.viscosity / oil.at(float(self.at.rim_temperature)) if self.flow < 0.0 else 1.0
        outlet = oil.viscosity / oil.at(hot)
        growth = outlet / inlet - 1.0
        nodes, weights = quadrature(POINTS)
        if growth < 1e-12:
            return nodes, weights, np.full_like(nodes, inlet)
        stretch = math.log1p(growth)
        place = np.expm1(stretch * nodes) / growth
        return place, weights * stretch * (1.0 + growth * place) / growth, inlet * (1.0 + growth * place)

    def _source(self) -> tuple[float, float]:
        """S, 1/s, and dS/dq, 1/m²: growth of phi by the heat of the groove."""
        channel, oil = self.channel, self.footstep.oil
        q = self.flow / channel.width
        n = 6.0 * (channel.speed * channel.depth - 2.0 * q)
        m3 = n * n + 12.0 * (channel.depth * channel.speed) ** 2
        scale = oil.exponent * oil.viscosity / (12.0 * oil.heat_capacity * channel.depth**4)
        return scale * m3, -24.0 * scale * n

    def slopes(self, growth: Complex) -> tuple[Complex, Complex]:
        """d(pressure of the rim)/dQ_k, Pa s/m³, and d(phi at the groove's outlet)/dQ_k, s/m³, by the groove.

        Parameters
        ----------
        growth : ndarray
            lambda of exp(lambda t), 1/s; infinite: temperatures frozen.

        Returns
        -------
        ndarray, ndarray
            The phi of oil that enters from the rim is that of the steady state: it changes by some hundredths.
        """
        channel, oil, step = self.channel, self.footstep.oil, self.footstep
        depth, length, width = channel.depth, channel.length, channel.width
        q = self.flow / width
        place, weights, phi = self._along()
        source, source_slope = self._source()
        rate = self.exchange_rate
        drive = source_slope - math.copysign(1.0, q) * source / (rate * length * depth)  # B, per q
        bare = oil.viscosity * length * float(weights @ (1.0 / phi)) / depth**3
        pressure = np.full(growth.shape, -12.0 * bare, complex)
        outlet = np.zeros(growth.shape, complex)
        moving = np.isfinite(growth)
        if moving.any():
            x = growth[moving] / rate
            reach = (
                _mean_decay(x[:, None] * place[None, :]) * place[None, :] / rate
            )  # (1 - e^{-lambda s/v})/lambda
            n = 6.0 * (channel.speed * depth - 2.0 * q)
            pressure[moving] -= n * oil.viscosity * length / depth**3 * drive * (reach @ (weights / phi**2))
            outlet[moving] = drive * _mean_decay(x) / rate
        if step.options.entry_loss and q > 0.0:
            pressure -= step.options.entry_loss * oil.density * q / depth**2
        return np.asarray(pressure / width, complex), np.asarray(outlet / width, complex)

    @cached_property
    def _terms(self) -> tuple[float, float, float, float, float]:
        """How R answers with temperatures in balance: by pressure, by theta1' and, through the clearance, by both.

        Returns
        -------
        by_pressure, by_groove : float
            dR/dp1, m³/(s Pa), and dR/dtheta1', m³/(s K), at the temperature of the clearance as it is.
        mixing, mixing_by_pressure, mixing_by_groove : float
            What the temperature of the clearance adds when it has followed: per Q_k, per p1 and per theta1'.
        """
        model, step, oil, at = self.model, self.footstep, self.footstep.oil, self.at
        p1, hot = float(at.rim_pressure), float(at.groove_temperature)
        feeds = self.flow > 0.0
        face, warmth, backflow = _face_slopes(model, p1, hot, feeds)
        groove, out, leakage = max(self.flow, 0.0), max(float(at.face_flow), 0.0), float(at.leakage)
        into = groove + out
        mixed, warm = float(at.rim_temperature), float(at.face_temperature)
        thinned = oil.exponent * leakage / into
        by_face = (warm - mixed) * face if feeds and out > 0.0 else 0.0
        return (
            leakage / (p1 - step.ambient_pressure) - face,
            -backflow,
            thinned * (hot - mixed) if feeds else 0.0,
            thinned * (out * warmth + by_face),
            thinned * groove,
        )

    def _warming(self, outlet: Complex) -> Complex:
        """d(theta1')/dQ_k, K s/m³, of d(phi)/dQ_k at the outlet of the groove."""
        oil = self.footstep.oil
        if not oil.exponent:
            return np.zeros_like(outlet)  # no viscosity answers to it
        return np.asarray(outlet * (oil.at(float(self.at.groove_temperature)) / oil.viscosity / oil.exponent))

    def balance(self, growth: Complex) -> Complex:
        """F, d(outflow - inflow of the rim)/dQ_k, dimensionless, at rates of growth in 1/s."""
        return self._balanced(growth, *self.slopes(growth))

    def _balanced(self, growth: Complex, pressure: Complex, outlet: Complex) -> Complex:
        """`balance` with the slopes of the groove."""
        by_pressure, by_groove, mixing, mixing_by_pressure, mixing_by_groove = self._terms
        hotter = self._warming(outlet)
        moving = np.isfinite(growth)
        lag = _clearance_volume(self.footstep) / self._into * np.where(moving, growth, 0.0)
        mixture = mixing + mixing_by_pressure * pressure + mixing_by_groove * hotter
        held = np.where(moving, mixture / (1.0 + lag), 0.0)
        return np.asarray(by_pressure * pressure + by_groove * hotter - 1.0 + held)

    @cached_property
    def _bounds(self) -> tuple[Complex, Complex]:
        """`slopes` with temperatures in balance and with temperatures frozen."""
        return self.slopes(BALANCED_AND_FROZEN)

    @cached_property
    def settled_and_frozen(self) -> tuple[float, float]:
        """F with temperatures in balance and with temperatures frozen."""
        settled, frozen = self._balanced(BALANCED_AND_FROZEN, *self._bounds).real.tolist()
        return settled, frozen

    @property
    def conductance(self) -> float:
        """-dQ_k/dp1 of the groove at the temperatures of the state, m³/(s Pa)."""
        return -1.0 / float(self._bounds[0][1].real)

    @property
    def _into(self) -> float:
        """What enters the rim, m³/s."""
        return max(self.flow, 0.0) + max(float(self.at.face_flow), 0.0)

    def largest_part_of_heat(self) -> float:
        """Bound of what heat adds to F at any frequency: its parts are largest at rest."""
        by_pressure, by_groove, mixing, mixing_by_pressure, mixing_by_groove = self._terms
        pressure, outlet = self._bounds
        hotter = abs(self._warming(outlet)[0])
        frozen, heat = abs(pressure[1]), abs(pressure[0] - pressure[1])
        clearance = abs(mixing) + abs(mixing_by_pressure) * (frozen + heat) + abs(mixing_by_groove) * hotter
        return float(abs(by_pressure) * heat + abs(by_groove) * hotter + clearance)

    def growing(self) -> int:
        """Number of growing disturbances, by the principle of the argument along the imaginary axis.

        What heat adds to F falls as 1/frequency from its value at rest, so that the count ends where it has
        become small against F with frozen temperatures.
        """
        settled, frozen = self.settled_and_frozen
        highest = min(max(20.0, 4.0 * abs(settled / frozen - 1.0)), HIGHEST)
        x = np.concatenate(([0.0], np.geomspace(1e-3, 0.2, 40), np.arange(0.3, highest, 0.2)))
        value = np.append(self.balance(1j * self.exchange_rate * x), frozen)
        turns = float(np.sum(np.angle(value[1:] / value[:-1])))
        return abs(round(turns / math.pi))

    def growth_rate(self) -> float:
        """Rate of the disturbance that grows without oscillation, 1/s; not a number where there is none."""
        from babbitt.numerics.roots import bracketed_root

        def real(rate: float) -> float:
            return float(self.balance(np.array([complex(rate)]))[0].real)

        if real(0.0) <= 0.0:
            return math.nan
        high = self.exchange_rate
        while real(high) > 0.0:
            high *= 2.0
            if high > 1e6 * self.exchange_rate:
                return math.nan
        return bracketed_root(real, 0.0, high, 1e-12 * high)


def stability_of_grooved(disturbance: RimDisturbance) -> Stability:
    """Stability of a grooved heel by superposition."""
    settled, frozen = disturbance.settled_and_frozen
    gain = 1.0 - settled / frozen
    damped = disturbance.largest_part_of_heat() < abs(frozen)  # whatever its phase
    return Stability(gain < 1.0 and (damped or disturbance.growing() == 0), gain)


def stability_of_smooth(model: SmoothFootstep, at: Balance) -> Stability:
    """Stability of a smooth heel: the oil of the clearance follows that of the face gap with one lag."""
    step, oil = model.footstep, model.footstep.oil
    p1, leakage = float(at.rim_pressure), float(at.leakage)
    face, warmth, _ = _face_slopes(model, p1, oil.temperature, False)
    frozen = leakage / (p1 - step.ambient_pressure) - face
    gain = -oil.exponent * leakage * warmth / frozen
    return Stability(gain < 1.0, gain)


def stability_of_films(model: ThermalFilms, flow: float) -> Stability:
    """Stability of two films of one temperature each, whose oil holds the heat (metal of given temperature)."""
    step = model.footstep
    if step.wall is None:
        return Stability(True, 0.0)  # the temperatures are given
    at = model.state(number(flow))
    warm = np.array([float(at.annulus_temperature), float(at.face_temperature)])
    drain, heating = model.film_slopes(flow, warm)
    # Pressure in balance: g(Q, T) = 0 gives dQ = -(g_T/g_Q) dT.
    follows = -drain[1:] / drain[0]
    matrix = np.diag(heating[:, 1]) + np.outer(heating[:, 0], follows)
    part = step.geometry
    recess = math.pi * (part.recess_radius**2 - part.bore_radius**2) * part.recess_depth
    gap = math.pi * (part.radius**2 - part.recess_radius**2) * step.face_gap
    groove = step.groove
    depth = 0.0 if groove is None else groove.groove_share * groove.depth
    annulus = _clearance_volume(step) + 2.0 * math.pi * part.radius * part.length * depth
    stores = step.oil.heat_capacity * np.array([annulus, gap + recess])
    gain = float(np.sum(-heating[:, 0] / heating[:, 1] * drain[1:]) / -drain[0])
    return Stability(bool((np.linalg.eigvals(matrix / stores[:, None]).real < 0.0).all()), gain)


def _mean_decay(x: Complex) -> Complex:
    """(1 - e^{-x})/x, which is 1 at x = 0."""
    small = np.abs(x) < SERIES_BELOW
    safe = np.where(small, 1.0, x)
    return np.asarray(np.where(small, 1.0 - x / 2.0 + x * x / 6.0, (1.0 - np.exp(-safe)) / safe), complex)


def _clearance_volume(step: Footstep) -> float:
    """Oil between lands and cup, m³."""
    return 2.0 * math.pi * step.geometry.radius * step.geometry.length * step.clearance


def _face_slopes(
    model: GroovedFootstep | SmoothFootstep, p1: float, hot: float, groove_feeds: bool
) -> tuple[float, float, float]:
    """Slopes of the face: dQ2/dp1, m³/(s Pa), dtheta1''/dp1, K/Pa, dQ2/dtheta1', m³/(s K)."""
    step, oil, face = model.footstep, model.footstep.oil, model.face
    small = STEP * (step.supply_pressure - step.ambient_pressure)

    def flow(pressure: float, temperature: float) -> float:
        return float(face.flow(number(pressure), oil.at(temperature)))

    def outlet(pressure: float) -> float:
        return float(face.outlet_temperature(number(flow(pressure, hot)), number(pressure)))

    slope = (flow(p1 + small, hot) - flow(p1 - small, hot)) / (2.0 * small)
    warmth = (outlet(p1 + small) - outlet(p1 - small)) / (2.0 * small)
    backflow = (flow(p1, hot + 1e-3) - flow(p1, hot - 1e-3)) / 2e-3 if groove_feeds else 0.0
    return slope, warmth, backflow
