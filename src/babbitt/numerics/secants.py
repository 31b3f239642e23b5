"""Fixed points x = G(x) of maps that differ little, one after the other: what a search learns serves the next one.

The residual f = G(x) - x answers to a move; a matrix P tells what to move by to be rid of it, x' = x + P f. It
starts as the damping b, P = b I, and takes up every move s and the change y of the residual that it brought,

    P' = P - (P y + s) q^T / (q^T y),

with q the part of y that is normal to the earlier changes of the same search: all secants of a search hold, those
of searches before as far as they do not contradict them.
Source: H. Fang, Y. Saad, Two classes of multisecant methods for nonlinear acceleration, Numer. Linear Algebra
Appl. 16 (2009) 197-221 (Broyden's second method for several secants).
"""

from __future__ import annotations

import math

import numpy as np

from babbitt.numerics.scalar_or_array import Array

__all__ = ["RecycledSecants"]

KNOWN = 0.02
"""Share of a move that P misses, below which its secant tells nothing new."""
ALIKE = 1e-3
"""Sine between a change of the residual and the earlier ones of a search, below which it tells nothing new."""
PATIENCE = 6
"""States in a row no better than the best one, after which what is known counts as misleading."""


class RecycledSecants:
    """The next state of a search from all that earlier searches have learnt, vectors of one length.

    Parameters
    ----------
    damping : float
        Share b of the residual that a state takes of which nothing is known.
    astray : float
        Residual over the least one from which a search forgets all, as after `PATIENCE` states in vain, and goes
        on from its best state with half the damping.
    most : int
        Secants that are kept; a search that begins with half of them begins from none.
    """

    def __init__(self, damping: float, astray: float = math.inf, most: int = 120) -> None:
        self._usual, self._astray, self._most = damping, astray, most
        self._moves, self._normals = np.zeros((0, 0)), np.zeros((0, 0))
        self._count = self._known = self._first = self._idle = 0
        self._last: tuple[Array, Array] | None = None
        self._best: tuple[Array, Array] | None = None
        self.begin()

    def begin(self) -> None:
        """A new search: its states have nothing to do with those before."""
        if self._count > self._most // 2:
            self._count = 0
        self._known, self._first, self._damping = 0, self._count, self._usual
        self._leave()

    def undo(self) -> None:
        """Forget what the last search has learnt."""
        self._count = min(self._first, self._count)

    def step(self, state: Array, residual: Array) -> tuple[Array, Array]:
        """State to go on from, and the move from there."""
        size = _size(residual)
        self._idle += 1
        if self._best is not None and (size > self._astray * _size(self._best[1]) or self._idle > PATIENCE):
            state, residual = self._best
            self.fail()
        elif self._last is not None:
            self._learn(state - self._last[0], residual - self._last[1])
        if self._best is None or _size(residual) < _size(self._best[1]):
            self._best, self._idle = (state, residual), 0
        self._last = state, residual
        return state, self._remedy(residual)

    def fail(self) -> None:
        """Forget all, for the last step led nowhere, and take shorter ones."""
        self._known = self._count
        self._damping *= 0.5
        self._leave()

    def _leave(self) -> None:
        self._idle, self._last, self._best = 0, None, None

    def _remedy(self, residual: Array) -> Array:
        """P f."""
        rows = slice(self._known, self._count)
        if self._known == self._count:
            return self._damping * residual
        # a few long vectors: threads of a BLAS would wait for each other longer than they work, einsum has none
        shares = np.einsum("ik,k->i", self._normals[rows], residual)
        return np.asarray(self._damping * residual - np.einsum("i,ik->k", shares, self._moves[rows]))

    def _learn(self, move: Array, gain: Array) -> None:
        """Take up what a move has brought."""
        missed = self._remedy(gain) + move
        if self._count == self._most or not _size(missed) > KNOWN * _size(move):
            return
        if self._moves.shape[1] != move.size:
            self._moves, self._normals = np.empty((self._most, move.size)), np.empty((self._most, move.size))
        normal, own = gain, self._normals[max(self._first, self._known) : self._count]
        for _ in range(2):  # the second time for what round-off left
            normal = normal - np.einsum("i,ik->k", np.einsum("ik,k->i", own, normal), own)
        size = _size(normal)
        if size > ALIKE * _size(gain):
            self._normals[self._count], self._moves[self._count] = normal / size, missed / size
            self._count += 1


def _size(vector: Array) -> float:
    return math.sqrt(float(np.einsum("k,k->", vector, vector)))
