"""Stiffness and damping of a bearing over rotor speed: the table that other programs exchange."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from babbitt.core.notices import InputError
from babbitt.core.quantities import QUANTITIES
from babbitt.export.frame import Frame
from babbitt.export.whirl import OverFrequency, SystemMatrices

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class CoefficientTable:
    """Dynamic coefficients of one bearing at several rotor speeds, with the frame they are written in.

    The film force on the journal answers a small motion with ``dF = -(K dx + C dx' + M dx'')``; K, C and M are
    ordered [[xx, xy], [yx, yy]], first index the force, second the motion. The coefficients belong to the rotor
    speed of their row. Those of a film without motions of its own hold at any frequency; of a bearing whose pads
    follow (`over_frequency` is given) they are synchronous, at the frequency of the rotation.

    Attributes
    ----------
    name : str
        The bearing; one line.
    speeds : ndarray, shape (n,)
        Angular speed of the journal, rad/s, not negative, strictly increasing.
    stiffness : ndarray, shape (n, 2, 2)
        N/m.
    damping : ndarray, shape (n, 2, 2)
        N s/m.
    mass : ndarray, shape (n, 2, 2), or None
        Added mass of the film, kg; None where it was not computed.
    frame : Frame
        Axes, load direction and rotation sense.
    static : Mapping[str, ndarray of shape (n,)]
        The equilibria the coefficients belong to: any of `babbitt.core.quantities.QUANTITIES`, such as ``load``
        and ``eccentricity_ratio``, in SI.
    method : str
        How the numbers were obtained, or where they come from; one line.
    temperatures : str
        Whether the temperatures of the film are ``frozen`` while the journal moves or follow it, as in ``stiffness
        following, damping frozen``; one line, empty where it is not known.
    over_frequency : OverFrequency or None
        Coefficients at every speed and at frequencies apart from it, of a bearing with motions of its own.
    systems : tuple of SystemMatrices
        M, C and K of journal and pads at every speed; empty where the bearing has no motions of its own.
    warnings : tuple of tuple of str
        At every speed the codes of the warnings that question its equilibrium or leave it without a verdict, such
        as ``W407``; empty where no speed has one, or where it is not known.
    unsolved_speeds : tuple of float
        Speeds that were asked for and are not in the table, rad/s: no equilibrium, or not the stiffness that
        the case asks for.

    Raises
    ------
    InputError
        E003 for a value that cannot be used, E004 for arrays that do not fit each other.

    Notes
    -----
    Arrays are copied and made read-only.
    """

    name: str
    speeds: Array
    stiffness: Array
    damping: Array
    mass: Array | None = None
    frame: Frame = field(default_factory=Frame)
    static: Mapping[str, Array] = field(default_factory=dict)
    method: str = ""
    temperatures: str = ""
    over_frequency: OverFrequency | None = None
    systems: tuple[SystemMatrices, ...] = ()
    warnings: tuple[tuple[str, ...], ...] = ()
    unsolved_speeds: tuple[float, ...] = ()

    def __post_init__(self) -> None:
        for attribute in ("name", "method", "temperatures"):
            if any(ord(letter) < 32 for letter in getattr(self, attribute)):
                raise InputError("E003", f"coefficients: {attribute} must be one line of text")
        if not self.name.strip():
            raise InputError("E003", "coefficients: name is empty; name the bearing")
        speeds = self._frozen("speeds", self.speeds)
        if speeds.ndim != 1 or speeds.size == 0:
            raise InputError(
                "E003", f"{self.name}: speeds has shape {speeds.shape}; give one speed or more in a row"
            )
        if speeds[0] < 0.0 or np.any(np.diff(speeds) <= 0.0):
            raise InputError(
                "E003", f"{self.name}: speeds must increase from row to row and not be negative; sort the table"
            )
        object.__setattr__(self, "speeds", speeds)
        for attribute in ("stiffness", "damping", "mass"):
            given = getattr(self, attribute)
            if given is not None:
                object.__setattr__(self, attribute, self._frozen(attribute, given, (speeds.size, 2, 2)))
        over = self.over_frequency
        if over is not None and over.stiffness.shape[0] != speeds.size:
            have = f"over_frequency has {over.stiffness.shape[0]} speeds"
            raise InputError("E004", f"{self.name}: {have}, the table {speeds.size}")
        if self.systems and len(self.systems) != speeds.size:
            raise InputError(
                "E004", f"{self.name}: {len(self.systems)} systems are given for {speeds.size} speeds"
            )
        if self.warnings and len(self.warnings) != speeds.size:
            raise InputError(
                "E004", f"{self.name}: warnings are given for {len(self.warnings)} speeds of {speeds.size}"
            )
        codes = tuple(tuple(one) for one in self.warnings)
        if wrong := [code for one in codes for code in one if not (isinstance(code, str) and code.isalnum())]:
            raise InputError("E003", f"{self.name}: warnings must be codes such as W407, not {wrong[0]!r}")
        object.__setattr__(self, "warnings", codes if any(codes) else ())
        unsolved = self._frozen("unsolved_speeds", np.asarray(self.unsolved_speeds))
        object.__setattr__(self, "unsolved_speeds", tuple(unsolved.tolist()))
        static = {}
        for name, values in self.static.items():
            if name not in QUANTITIES:
                raise InputError(
                    "E003",
                    f"{self.name}: '{name}' is no quantity of Babbitt; see babbitt.core.quantities.QUANTITIES",
                )
            static[name] = self._frozen(name, values, speeds.shape)
        object.__setattr__(self, "static", MappingProxyType(static))

    def _frozen(self, what: str, given: Array, shape: tuple[int, ...] | None = None) -> Array:
        """A read-only copy of an array of finite numbers of the shape that is due."""
        try:
            values = np.array(given, dtype=np.float64)
        except (TypeError, ValueError):
            raise InputError("E003", f"{self.name}: {what} is not an array of numbers") from None
        if shape is not None and values.shape != shape:
            raise InputError(
                "E004",
                f"{self.name}: {what} has shape {values.shape}; with {shape[0]} speeds it must be {shape}",
            )
        if not np.all(np.isfinite(values)):
            raise InputError("E003", f"{self.name}: {what} contains NaN or infinity; leave out what is not known")
        values.setflags(write=False)
        return values
