"""The laws of turbulence that a case may name."""

from __future__ import annotations

from typing import Literal

from babbitt.reynolds.oil.turbulence import CONSTANTINESCU, NG_PAN, TurbulenceLaw

__all__ = ["LAWS_OF_TURBULENCE", "TurbulenceInput"]

TurbulenceInput = Literal["laminar", "ng_pan", "constantinescu"]

LAWS_OF_TURBULENCE: dict[str, TurbulenceLaw | None] = {
    "laminar": None,
    "ng_pan": NG_PAN,
    "constantinescu": CONSTANTINESCU,
}
