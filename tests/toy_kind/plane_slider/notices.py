"""Codes of a plane slider, for `babbitt explain` and the verdict."""

from babbitt.core.notices import Explanation

NOTICES = {
    "X101": Explanation(
        "Steep wedge",
        "The film at the inlet is more than five times that at the outlet: it carries less than two thirds of "
        "what it could.",
        "Make the slider less steep; at a ratio of 2.2 it carries most.",
    ),
}
