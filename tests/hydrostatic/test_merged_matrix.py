"""Film and recesses as one sparse system, without superposition: the same pressures, forces and coefficients.

Every recess is one unknown of the film's own matrix (its rows and columns added up), with its restrictor and the
oil that gives way on the diagonal; one complex solve for every direction of motion. The product never builds this
matrix: it solves by blocks of lines, superposes unit pressures and contracts adjoints.
"""

import math

import numpy as np
import pytest
import scipy.sparse as sparse
from hydrostatic_bearings import (
    CAPILLARY,
    CLEARANCE,
    RING,
    RING_FEEDING,
    SPEED,
    feeding,
    journal,
    journal_film,
    ring_film,
)
from scipy.sparse.linalg import spsolve

from babbitt.kinds.hydrostatic.impedance import Compressibility, impedance
from babbitt.kinds.hydrostatic.lines import DRAFT
from babbitt.kinds.hydrostatic.restrictors import CheckValve
from babbitt.kinds.hydrostatic.state import state_at
from babbitt.kinds.hydrostatic.supply import FixedPressure, Pump

OIL = Compressibility(3.6651914e-6, 1e9)


class Merged:
    """The film of a state in the kernels' units, its recesses one unknown each behind the wet nodes."""

    def __init__(self, state):
        self.state, self.of, self.film = state, state.film.of, state.film.film
        self.surface, self.wet, self.pressure = self.of.surface, state.film.work.wet, state.film.work.pressure
        self.scales, recess = self.of.scales, self.of.recess
        free = (recess == -1) & self.wet
        unknown = np.full(recess.shape, -1)
        unknown[free] = np.arange(free.sum())
        unknown[recess >= 0] = free.sum() + recess[recess >= 0]
        self.free, self.size = int(free.sum()), int(free.sum()) + self.of.count
        known = unknown.ravel() >= 0
        self.merge = sparse.csr_matrix(
            (np.ones(known.sum()), (np.flatnonzero(known), unknown.ravel()[known])), (recess.size, self.size)
        )

    @property
    def operator(self):
        """Rows of all nodes over all nodes: what the pressures push off."""
        lines, nodes = self.wet.shape
        slope = self.surface.slope
        along = self.film.conductance
        blocks = [
            slope.T @ ((self.surface.kappa * self.surface.share * self.film.cubed[i])[:, None] * slope)
            for i in range(lines)
        ]
        matrix = sparse.lil_matrix(sparse.block_diag(blocks))
        for i in range(self.surface.step.size):
            for a in range(nodes):
                here, after = i * nodes + a, (i + 1) % lines * nodes + a
                matrix[here, here] += along[i, a]
                matrix[after, after] += along[i, a]
                matrix[here, after] -= along[i, a]
                matrix[after, here] -= along[i, a]
        return sparse.csr_matrix(matrix)

    def divergence(self, flux):
        """Rows of a flux along every interval."""
        rows = np.zeros(self.wet.shape)
        for i in range(self.surface.step.size):
            rows[i] += flux[i]
            rows[(i + 1) % rows.shape[0]] -= flux[i]
        return rows

    def opening(self, d):
        """Rows that a motion adds at standing pressures."""
        lines = self.wet.shape[0]
        after = (np.arange(self.surface.step.size) + 1) % lines
        drop = self.pressure[: after.size] - self.pressure[after]
        rows = self.divergence(self.film.couette_d[d] + drop * self.film.conductance_d[d])
        gradient = self.pressure @ self.surface.slope.T
        across = self.surface.kappa * self.surface.share * self.film.cubed_d[d] * gradient
        return rows + across @ self.surface.slope

    def restrictors(self, capacity):
        """-dQ/dp of the recesses with the oil that gives way, in the kernels' units."""
        network, unit = self.state.network, self.scales.pressure / self.scales.flow
        matrix = np.zeros((self.size, self.size), dtype=complex)
        own = np.diag(network.slope) + capacity * np.eye(self.of.count)
        if np.isfinite(network.manifold_slope):
            own = own - np.outer(network.supply_slope, network.slope) / network.manifold_slope
        matrix[self.free :, self.free :] = unit * own
        return sparse.csr_matrix(matrix)

    def impedance(self, frequency):
        """Stiffness + i frequency damping, SI."""
        motions = self.surface.lever.shape[0]
        whole = self.merge.T @ self.operator @ self.merge + self.restrictors(1j * frequency * OIL.recess)
        loads = np.array([self.film.load[d].ravel() for d in range(motions)])
        nu = 1j * frequency / self.scales.rate
        found = np.empty((motions, motions), dtype=complex)
        for e in range(motions):
            right = self.merge.T @ (self.opening(e).ravel() - nu * loads[e])
            found[:, e] = loads @ (self.merge @ spsolve(sparse.csc_matrix(whole), -right))
        sense = self.scales.area * self.scales.gap / self.scales.motion
        return found * (sense * self.scales.pressure)[:, None] / self.scales.motion


STATES = {
    "full film": (0.5, feeding(), False),
    "ruptured film": (0.8, feeding(), True),
    "check valves": (0.8, feeding(CheckValve(CAPILLARY)), True),
    "common pump": (0.75, feeding(supply=Pump(5e-5, 1e-12)), True),
}


@pytest.mark.parametrize("name", STATES)
@pytest.mark.parametrize("hertz", [0.01, 200.0])
def test_coefficients_of_the_hybrid_journal_are_those_of_the_merged_matrix(name, hertz):
    eps, fed, ruptured = STATES[name]
    at = eps * CLEARANCE * np.array([math.sin(0.7), -math.cos(0.7)])
    state = state_at(journal_film(journal(), SPEED), fed, at, DRAFT)
    assert state.solved
    assert (state.dry_share > 0.0) == ruptured
    nu = 2.0 * math.pi * hertz
    merged = Merged(state).impedance(nu)
    stiffness, damping = impedance(state.response, state.network, OIL, nu)
    assert stiffness == pytest.approx(merged.real, rel=1e-11, abs=1e-12 * np.abs(merged).max())
    assert nu * damping == pytest.approx(merged.imag, rel=1e-11, abs=1e-12 * np.abs(merged).max())


def test_coefficients_of_a_tilted_ring_are_those_of_the_merged_matrix():
    state = state_at(ring_film(RING, speed=100.0), RING_FEEDING, np.array([0.0, 2e-4, 5e-5]), DRAFT)
    nu = 400.0 * math.pi
    merged = Merged(state).impedance(nu)
    stiffness, damping = impedance(state.response, state.network, OIL, nu)
    arm = np.array([1.0, 0.1, 0.1])
    scale = 1e-12 * np.abs(merged / np.outer(arm, arm)).max() * np.outer(arm, arm)
    assert (np.abs(stiffness - merged.real) < scale).all()
    assert (np.abs(nu * damping - merged.imag) < scale).all()


@pytest.mark.parametrize("eps", [0.0, 0.5, 0.8])
def test_pressures_of_the_network_are_those_of_the_merged_matrix(eps):
    """Capillaries are linear: one solve gives all pressures of film and recesses, and the forces."""
    at = eps * CLEARANCE * np.array([math.sin(0.7), -math.cos(0.7)])
    fed = feeding(supply=FixedPressure(5e6))
    state = state_at(journal_film(journal(), SPEED), fed, at, DRAFT)
    merged = Merged(state)
    whole = merged.merge.T @ merged.operator @ merged.merge + merged.restrictors(0.0)
    right = merged.merge.T @ merged.divergence(merged.film.couette).ravel()
    right[merged.free :] -= CAPILLARY.conductance * 5e6 / merged.scales.flow
    pressure = merged.merge @ spsolve(sparse.csc_matrix(whole), -right).real
    found = pressure.reshape(merged.wet.shape)
    assert found == pytest.approx(merged.pressure, rel=1e-11, abs=1e-12)
    recesses = [found[merged.of.recess == k][0] * merged.scales.pressure for k in range(4)]
    assert recesses == pytest.approx(state.network.pressures, rel=1e-12)
    loads = np.array([merged.film.load[d].ravel() for d in range(2)])
    force = -loads @ pressure * merged.scales.area * merged.scales.pressure
    assert state.force == pytest.approx(force, rel=1e-11, abs=1e-8)
    symmetric = merged.operator - merged.operator.T
    assert abs(symmetric).max() < 1e-14 * abs(merged.operator).max()
