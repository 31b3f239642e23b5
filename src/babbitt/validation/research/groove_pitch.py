"""Reynolds' equation in two dimensions on one pitch of a screw groove: the referee of narrow-groove theory.

The unrolled clearance is seen from the groove. With x around, z along the heel and the groove at the angle phi
from x, the coordinate ``s = x - z cot(phi)`` is constant along the groove: the film jumps at lines of constant s,
and one pitch in s is periodic. The kernels of the journal film know metrics without cross terms only, so that
this skewed film has its own finite volumes. Per volume, k = h³/(12 mu) and V the speed of the plain wall against
the groove,

    F_s = V h/2 + k cot(phi) p_z - k p_s/sin(phi)²,      F_z = -k (p_z - cot(phi) p_s).

F_s and the pressure are continuous at a jump of h: the flux between two volumes is that of both halves in series
(harmonic mean of k). Eliminating p_s, ``F_z = -k sin(phi)² p_z + sin(phi) cos(phi) (V h/2 - F_s)``. What leaves
one volume enters the next, to round-off.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError

__all__ = ["GroovePitch", "PitchFilm", "pitch_film"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class GroovePitch:
    """One pitch of a screw groove of equal width; SI.

    Attributes
    ----------
    radius, length : float
        Of the cylinder, m.
    starts : int
        Grooves around it.
    groove_share : float
        Of the surface.
    angle : float
        Of the groove, from the circumferential direction, rad.
    clearance, depth : float
        Film over the lands and depth of the grooves, m.
    viscosity : float
        Pa s.
    speed : float
        Of the surface, m/s: drags oil towards the end z = L.
    """

    radius: float
    length: float
    starts: int
    groove_share: float
    angle: float
    clearance: float
    depth: float
    viscosity: float
    speed: float

    def __post_init__(self) -> None:
        for name in ("radius", "length", "starts", "clearance", "viscosity"):
            if not (math.isfinite(getattr(self, name)) and getattr(self, name) > 0.0):
                raise InputError("E101", f"{name} is {getattr(self, name)}; it must be a positive number.")
        if not (0.0 < self.groove_share < 1.0 and 0.0 < self.angle < 0.5 * math.pi and self.depth >= 0.0):
            raise InputError("E101", "a groove takes a share between 0 and 1, runs at an angle between 0 and 90 "
                             "degrees, and is not raised.")  # fmt: skip


@dataclass(frozen=True, eq=False)
class PitchFilm:
    """Film of one pitch.

    Attributes
    ----------
    s, z : ndarray
        Middles of the volumes, m; s from the middle of a land, z from the end at ambient pressure.
    thickness : ndarray, shape (s,)
        m.
    pressure : ndarray, shape (s, z)
        Above ambient, Pa.
    flow : float
        Of all grooves, towards z = L, m³/s.
    wall_power : float
        That turns the whole cylinder, W.
    imbalance : float
        Flow at z = L less that at z = 0, over the flow or the dragged one, whichever is larger.
    """

    s: Array
    z: Array
    thickness: Array
    pressure: Array
    flow: float
    wall_power: float
    imbalance: float


def _widths(pitch: GroovePitch, across: int) -> tuple[Array, Array]:
    """Widths of the volumes across land, groove and land, and the film there; finer towards the jumps."""
    whole = 2.0 * math.pi * pitch.radius / pitch.starts
    groove, land = pitch.groove_share * whole, (1.0 - pitch.groove_share) * whole
    half = 0.5 * (1.0 - np.cos(np.linspace(0.0, math.pi, across + 1)))
    inner = np.diff(half)
    outer = np.diff(np.sin(np.linspace(0.0, 0.5 * math.pi, across // 2 + 1)))
    widths = np.concatenate((0.5 * land * outer, groove * inner, 0.5 * land * outer[::-1]))
    films = np.repeat((pitch.clearance, pitch.clearance + pitch.depth, pitch.clearance),
                      (outer.size, inner.size, outer.size))  # fmt: skip
    return widths, films


def pitch_film(pitch: GroovePitch, rise: float, across: int = 24, along: int = 96) -> PitchFilm:
    """Solve the film of one pitch between ambient pressure at z = 0 and a pressure at z = L.

    Parameters
    ----------
    pitch : GroovePitch
    rise : float
        Pressure at z = L above that at z = 0, Pa.
    across, along : int
        Volumes across a groove (and across a land), and along the cylinder, finer towards its ends.

    Returns
    -------
    PitchFilm
    """
    from scipy.sparse.linalg import spsolve

    ds, film = _widths(pitch, across)
    dz = pitch.length * np.diff(0.5 * (1.0 - np.cos(np.linspace(0.0, math.pi, along + 1))))
    fluxes = _Fluxes(pitch, ds, film, dz, rise)
    pressure = spsolve(fluxes.matrix, -fluxes.constant).reshape(ds.size, dz.size)
    through = fluxes.along(pressure.ravel()).reshape(ds.size, dz.size + 1)
    out, into = (pitch.starts * float(ds @ through[:, end]) for end in (-1, 0))
    dragged = 0.5 * pitch.speed * (pitch.clearance + pitch.depth) * 2.0 * math.pi * pitch.radius
    return PitchFilm(
        s=np.cumsum(ds) - 0.5 * ds,
        z=np.cumsum(dz) - 0.5 * dz,
        thickness=film,
        pressure=pressure,
        flow=out,
        wall_power=fluxes.wall_power(pressure.ravel()),
        imbalance=(out - into) / max(abs(out), math.sin(pitch.angle) * dragged, 1e-300),
    )


class _Fluxes:
    """Fluxes of the volumes as matrices on their pressures plus constants; volumes run along z first."""

    def __init__(self, pitch: GroovePitch, ds: Array, film: Array, dz: Array, rise: float) -> None:
        from scipy import sparse

        n, m = ds.size, dz.size
        sine, cosine = math.sin(pitch.angle), math.cos(pitch.angle)
        k = film**3 / (12.0 * pitch.viscosity)
        drag = 0.5 * pitch.speed * film
        eye_n, eye_m = sparse.identity(n), sparse.identity(m)
        # p_z at the faces across z, (m + 1) for each strip
        distance = np.concatenate(([0.5 * dz[0]], 0.5 * (dz[1:] + dz[:-1]), [0.5 * dz[-1]]))
        gradient = sparse.diags_array(
            (1.0 / distance[:-1], -1.0 / distance[1:]), offsets=(0, -1), shape=(m + 1, m)
        )
        self.slope = sparse.kron(eye_n, gradient).tocsr()
        self.slope_constant = np.zeros((n, m + 1))
        self.slope_constant[:, -1] = rise / distance[-1]
        mean_m = sparse.diags_array((np.full(m, 0.5), np.full(m, 0.5)), offsets=(0, 1), shape=(m, m + 1))
        after = sparse.csr_array((np.ones(n), (np.arange(n), (np.arange(n) + 1) % n)), shape=(n, n))
        # F_s at the faces behind each volume
        half = 0.5 * ds * sine**2 / k
        series = half + np.roll(half, -1)
        dragged = (half * drag + np.roll(half * drag, -1)) / series
        skewed = sine * cosine * 0.5 * (ds + np.roll(ds, -1)) / series
        to_face = sparse.kron(0.5 * (eye_n + after), mean_m)
        weight = sparse.kron(sparse.diags_array(skewed), eye_m)
        across = (
            sparse.kron(sparse.diags_array(1.0 / series) @ (eye_n - after), eye_m) + weight @ to_face @ self.slope
        )
        across_constant = np.repeat(dragged, m) + weight @ (to_face @ self.slope_constant.ravel())
        # F_z at the faces across z
        self.centre = sparse.kron(0.5 * (eye_n + after.T), eye_m).tocsr()  # F_s in the middle of a volume
        near = sparse.lil_array((m + 1, m))
        near[0, 0] = near[m, m - 1] = 1.0
        for j in range(1, m):
            near[j, j - 1] = near[j, j] = 0.5
        spread = sparse.kron(eye_n, near.tocsr()) @ self.centre
        gain = sparse.kron(sparse.diags_array(k * sine**2), sparse.identity(m + 1))
        self.along_matrix = (-(gain @ self.slope) - sine * cosine * (spread @ across)).tocsr()
        self.along_constant = sine * cosine * (np.repeat(drag, m + 1) - spread @ across_constant)
        self.along_constant -= gain @ self.slope_constant.ravel()
        balance = sparse.kron(
            sparse.diags_array(ds), sparse.diags_array((-np.ones(m), np.ones(m)), offsets=(0, 1), shape=(m, m + 1))
        )
        leaving = sparse.kron(eye_n - after.T, sparse.diags_array(dz))
        self.matrix = (balance @ self.along_matrix + leaving @ across).tocsc()
        self.constant = balance @ self.along_constant + leaving @ across_constant
        self._across, self._across_constant = across.tocsr(), across_constant
        self._wall = (pitch, ds, film, dz, k, drag, sine, cosine, mean_m)

    def along(self, pressure: Array) -> Array:
        """F_z at all faces across z."""
        return np.asarray(self.along_matrix @ pressure + self.along_constant)

    def wall_power(self, pressure: Array) -> float:
        """Power of the wall, ``Int V (mu V/h + h/2 dp/dx)`` over all grooves, W."""
        from scipy import sparse

        pitch, ds, film, dz, k, drag, sine, cosine, mean_m = self._wall
        n, m = ds.size, dz.size
        across = self.centre @ (self._across @ pressure + self._across_constant)
        slope = sparse.kron(sparse.identity(n), mean_m) @ (self.slope @ pressure + self.slope_constant.ravel())
        around = (np.repeat(drag, m) - across) * sine**2 / np.repeat(k, m) + sine * cosine * slope
        thickness = np.repeat(film, m)
        shear = pitch.viscosity * pitch.speed / thickness + 0.5 * thickness * around
        return pitch.starts * pitch.speed * float((shear.reshape(n, m) @ dz) @ ds)
