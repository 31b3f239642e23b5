"""What the bearings of a machine share, and how a bearing's own inputs take precedence."""

from __future__ import annotations

from collections.abc import Collection
from typing import TypeVar

from pydantic import Field

from babbitt.case.part import Part
from babbitt.case.parts.cooling import Cooling
from babbitt.case.parts.lubricant import LUBRICANT, LubricantInput
from babbitt.case.parts.materials import Materials
from babbitt.case.parts.supply import Supply

SharedPart = TypeVar("SharedPart", Supply, Cooling, Materials)


class SharedInputs(Part):
    """Lubricant, supply, cooling and materials: of a bearing, or of all bearings of a machine."""

    lubricant: LubricantInput | None = Field(None, description=LUBRICANT)
    supply: Supply | None = Field(None, description="Oil fed under pressure. Without it the housing cools.")
    cooling: Cooling | None = Field(None, description="Heat given to the surroundings through the housing.")
    materials: Materials | None = Field(None, description="Materials of bearing and journal.")


def merged(own: SharedPart | None, shared: SharedPart | None) -> SharedPart | None:
    """Take each field from the bearing where it gives one, else from the machine.

    Parameters
    ----------
    own, shared : Part or None
        Of the bearing and of its machine.
    """
    if own is None or shared is None:
        return own or shared
    given = {name: getattr(own, name) for name in own.model_fields_set}
    return shared.model_copy(update=dict.fromkeys(replaced_by(type(own), given)) | given)


def replaced_by(part: type[Part], given: Collection[str]) -> set[str]:
    """Fields of a shared part that those given by a bearing replace: themselves, and their alternatives.

    An air speed of the bearing replaces a heat transfer coefficient of the machine, not only its air speed.
    """
    chosen = (group for group in part.alternatives if set(group) & set(given))
    return set(given).union(*chosen)
