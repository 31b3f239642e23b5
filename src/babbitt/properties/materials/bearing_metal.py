"""What a bearing metal bears: limits by the character of the load, temperatures, expansion, hardness."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from babbitt.properties.materials.sourced import SourcedText, SourcedValue


class AlloyFamily(StrEnum):
    """Families of bearing metals that share experience values; nothing is known of `OTHER`."""

    TIN = "tin-based"
    LEAD = "lead-based"
    COPPER_LEAD = "copper-lead"
    COPPER_TIN = "copper-tin"
    COPPER_ALUMINIUM = "copper-aluminium"
    COPPER_ZINC = "copper-zinc"
    ALUMINIUM_TIN = "aluminium-tin"
    ALUMINIUM_ZINC = "aluminium-zinc"
    ALUMINIUM_SILICON = "aluminium-silicon"
    OTHER = "other"


class LoadCharacter(StrEnum):
    """How steady the load is."""

    CALM = "calm"
    SHOCK = "shock"


@dataclass(frozen=True)
class LoadLimits:
    """What a metal bears under one character of load; None where nothing public is known.

    Attributes
    ----------
    specific_load : SourcedValue or None
        Largest specific load p = F/(B D), in Pa.
    sliding_speed : SourcedValue or None
        Largest surface speed of the journal, in m/s.
    pv : SourcedValue or None
        Largest product of both, in Pa m/s.
    """

    specific_load: SourcedValue | None = None
    sliding_speed: SourcedValue | None = None
    pv: SourcedValue | None = None


@dataclass(frozen=True)
class BearingMetal:
    """A bearing metal and its limits; None where nothing public is known.

    Attributes
    ----------
    name : str
        Designation, such as ``"SnSb8Cu4"`` or ``"B83"``.
    family : AlloyFamily
        Selects the experience values (`babbitt.properties.materials.specific_load_limit`,
        `metal_temperature_limit`).
    standard : str
        Where the alloy is specified.
    composition : SourcedText
        Mass fractions.
    calm, shock : LoadLimits
        Limits of the metal itself by character of load.
    recommended_temperature : SourcedValue or None
        Advice for operation, in K.
    limiting_temperature : SourcedValue or None
        Limit, in K.
    published_outlet_limit : SourcedValue or None
        Limit of the oil outlet temperature that a published calculation with this metal took, in K. Given, not
        held: the limits by experience are lower.
    thermal_expansion : SourcedValue or None
        Coefficient of linear expansion of the metal in 1/K. A lining follows its back: for the clearance of a
        lined bearing take the expansion of the shell.
    brinell_hardness : SourcedValue or None
        HBW at 20 °C; the lower end where a range is published.
    aliases : tuple of str
        Other names it is found by.
    origin : str
        File of the user's own catalogue that it stands in; empty for all others.
    stands_for : BearingMetal or None
        Of a metal to which a case gives limits: the one of the catalogue, or of the family, without them.
    """

    name: str
    family: AlloyFamily
    standard: str
    composition: SourcedText
    calm: LoadLimits = LoadLimits()
    shock: LoadLimits = LoadLimits()
    recommended_temperature: SourcedValue | None = None
    limiting_temperature: SourcedValue | None = None
    published_outlet_limit: SourcedValue | None = None
    thermal_expansion: SourcedValue | None = None
    brinell_hardness: SourcedValue | None = None
    aliases: tuple[str, ...] = ()
    origin: str = ""
    stands_for: BearingMetal | None = None

    @property
    def without_own_limits(self) -> BearingMetal:
        """The metal that this one stands for; itself where a case gives it no limits."""
        return self if self.stands_for is None else self.stands_for

    def limits(self, character: LoadCharacter) -> LoadLimits:
        """Limits under a character of load.

        Parameters
        ----------
        character : LoadCharacter
            ``"calm"`` or ``"shock"``.

        Returns
        -------
        LoadLimits
            Each limit with its source.
        """
        return {LoadCharacter.CALM: self.calm, LoadCharacter.SHOCK: self.shock}[LoadCharacter(character)]
