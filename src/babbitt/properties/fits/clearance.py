"""Diametral clearance of a bearing at 20 °C: from values, sizes, deviations or tolerance classes."""

from __future__ import annotations

from dataclasses import dataclass

from babbitt.core.notices import InputError
from babbitt.numerics.scalar_or_array import functions_for
from babbitt.properties.fits.iso286 import letter_and_grade, tolerance_limits
from babbitt.properties.fits.sizes import Deviations, SizeLimits

LARGEST_RELATIVE_CLEARANCE = 0.05
"""Assumption: a larger clearance is a slip of unit. Bearings in use have 0.0005 to 0.005 of the diameter."""


@dataclass(frozen=True)
class RelativeClearance:
    """Smallest, mean and largest clearance over the diameter, psi = C/D (dimensionless)."""

    minimum: float
    mean: float
    maximum: float


@dataclass(frozen=True)
class Clearance:
    """Smallest, mean and largest diametral clearance C at the reference temperature 20 °C, in m.

    Raises
    ------
    InputError
        E003 if a value is not finite, E004 if the smallest is negative (the bore is smaller than the
        journal), the largest is not positive, or the three are out of order.
    """

    minimum: float
    mean: float
    maximum: float

    def __post_init__(self) -> None:
        for value in (self.minimum, self.mean, self.maximum):
            if not functions_for(value).isfinite(value):
                raise InputError("E003", f"a clearance must be a finite number, given {value!r}")
        if self.minimum < 0.0:
            raise InputError(
                "E004",
                f"the smallest clearance is {self.minimum * 1e6:.4g} um: the bore would be smaller than the "
                "journal; enlarge the bore or reduce the journal",
            )
        if not self.minimum <= self.mean <= self.maximum or self.maximum == 0.0:
            raise InputError(
                "E004",
                "clearances must satisfy 0 <= minimum <= mean <= maximum with a maximum above 0, given "
                f"{self.minimum * 1e6:.4g}, {self.mean * 1e6:.4g}, {self.maximum * 1e6:.4g} um",
            )

    @classmethod
    def from_diametral(cls, value: float, diameter: float) -> Clearance:
        """One known diametral clearance, without tolerances.

        Parameters
        ----------
        value : float
            Diametral clearance in m.
        diameter : float
            Nominal bearing diameter in m.
        """
        return cls.from_diametral_limits(value, value, diameter)

    @classmethod
    def from_diametral_limits(cls, minimum: float, maximum: float, diameter: float) -> Clearance:
        """Smallest and largest diametral clearance; the mean lies halfway.

        Parameters
        ----------
        minimum, maximum : float
            Diametral clearances in m.
        diameter : float
            Nominal bearing diameter in m, for plausibility.
        """
        if maximum < minimum:
            raise InputError(
                "E004",
                f"the maximum clearance {maximum * 1e6:.4g} um is below the minimum {minimum * 1e6:.4g} um; "
                "exchange the two values",
            )
        clearance = cls(minimum, minimum + (maximum - minimum) / 2.0, maximum)
        _require_sensible(clearance.maximum, diameter)
        return clearance

    @classmethod
    def from_sizes(cls, bore: SizeLimits, journal: SizeLimits) -> Clearance:
        """From the limits of size of bore and journal.

        ``C_max = D_max - D_J,min`` and ``C_min = D_min - D_J,max``, the mean halfway (ISO 7902-1).

        Parameters
        ----------
        bore, journal : SizeLimits
            Diameters at 20 °C in m.

        Raises
        ------
        InputError
            E004 if the smallest bore is smaller than the largest journal, or the clearance is not sensible.
        """
        if bore.minimum < journal.maximum:
            raise InputError(
                "E004",
                f"the smallest bore {bore.minimum * 1e3:.6g} mm is smaller than the largest journal "
                f"{journal.maximum * 1e3:.6g} mm; enlarge the bore or reduce the journal",
            )
        return cls.from_diametral_limits(
            bore.minimum - journal.maximum, bore.maximum - journal.minimum, journal.minimum
        )

    @classmethod
    def from_deviations(cls, nominal: float, bore: Deviations, journal: Deviations) -> Clearance:
        """From deviations of bore and journal about a common nominal size.

        Parameters
        ----------
        nominal : float
            Nominal size in m.
        bore, journal : Deviations
            In m.

        Examples
        --------
        >>> c = Clearance.from_deviations(0.05, Deviations(0.0, 25e-6), Deviations(-89e-6, -50e-6))
        >>> [round(1e6 * value) for value in (c.minimum, c.mean, c.maximum)]
        [50, 82, 114]
        """
        return cls.from_sizes(bore.limits(nominal), journal.limits(nominal))

    @classmethod
    def from_tolerance_classes(cls, nominal: float, bore: str, journal: str) -> Clearance:
        """From ISO 286 tolerance classes of bore and journal.

        Parameters
        ----------
        nominal : float
            Nominal size in m.
        bore, journal : str
            Such as ``"H7"`` and ``"e8"``.

        Raises
        ------
        InputError
            E005 for an unknown class or a hole class on the journal and the reverse, E006 for a size outside
            the tables, E004 for a fit that is not a clearance fit.
        """
        require_hole(bore)
        require_shaft(journal)
        return cls.from_deviations(nominal, tolerance_limits(bore, nominal), tolerance_limits(journal, nominal))

    @classmethod
    def from_fit(cls, nominal: float, fit: str) -> Clearance:
        """From an ISO 286 fit such as ``"H7/e8"``, bore first.

        Parameters
        ----------
        nominal : float
            Nominal size in m.
        fit : str
            Hole and shaft tolerance class with a stroke between.

        Examples
        --------
        >>> c = Clearance.from_fit(0.100, "H7/e8")
        >>> round(c.minimum * 1e6), round(c.maximum * 1e6)
        (72, 161)
        """
        bore, stroke, journal = fit.partition("/")
        if not stroke:
            raise InputError("E005", f"{fit!r} is not a fit; write bore and journal class as in H7/e8")
        return cls.from_tolerance_classes(nominal, bore, journal)

    def relative(self, diameter: float) -> RelativeClearance:
        """Relative clearances psi = C/D.

        Parameters
        ----------
        diameter : float
            Nominal bearing diameter in m.

        Returns
        -------
        RelativeClearance
            Dimensionless, at 20 °C; its mean is psi_m = (C_max + C_min)/(2 D).
        """
        _require_sensible(self.maximum, diameter)
        return RelativeClearance(self.minimum / diameter, self.mean / diameter, self.maximum / diameter)


def require_hole(tolerance_class: str) -> None:
    """Refuse, with E005, a tolerance class that is not included or no class of a hole."""
    letter, _ = letter_and_grade(tolerance_class)
    if letter.islower():
        raise InputError(
            "E005", f"the bore has the shaft tolerance class {tolerance_class!r}; use capital letters: H7"
        )


def require_shaft(tolerance_class: str) -> None:
    """Refuse, with E005, a tolerance class that is not included or no class of a shaft."""
    letter, _ = letter_and_grade(tolerance_class)
    if letter.isupper():
        raise InputError(
            "E005", f"the journal has the hole tolerance class {tolerance_class!r}; use small letters: e8"
        )


def _require_sensible(clearance: float, diameter: float) -> None:
    """Refuse a clearance that can only be a slip of unit."""
    if not (functions_for(diameter).isfinite(diameter) and diameter > 0.0):
        raise InputError("E003", f"the diameter is {diameter!r} m; it must be a positive number")
    if clearance >= diameter:
        raise InputError(
            "E004",
            f"the diametral clearance {clearance * 1e3:.6g} mm is larger than the journal of "
            f"{diameter * 1e3:.6g} mm; check the unit (sizes without a unit are in m)",
        )
    if clearance > LARGEST_RELATIVE_CLEARANCE * diameter:
        raise InputError(
            "E004",
            f"the diametral clearance {clearance * 1e3:.6g} mm is {clearance / diameter:.3g} of the diameter "
            f"{diameter * 1e3:.6g} mm; at most {LARGEST_RELATIVE_CLEARANCE:g} makes sense (usual 0.0005 to "
            "0.005); check the unit (1.5 permil is 0.0015)",
        )
