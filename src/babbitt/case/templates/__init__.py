"""Case files to begin with, one per kind; each runs as it stands."""

from __future__ import annotations

from collections.abc import Mapping
from importlib.resources import files

from babbitt.case.error_messages import nearest, shown
from babbitt.core.notices import InputError

_KINDS = {
    "journal": "one journal bearing, by ISO 7902 or its film",
    "machine": "several journal bearings that share oil and supply",
    "overhung_coupling": "load share of two bearings with an overhung coupling",
    "screw_heel": "footstep of a pump's screw, smooth or grooved heel",
    "hydrostatic_pad": "hydrostatic pad with one recess: round, annular, rectangular",
    "hydrostatic_thrust_ring": "hydrostatic thrust ring with several recesses and tilt",
    "hydrostatic_journal": "recessed journal bearing, hydrostatic or hybrid",
    "jacking_pocket": "jacking pockets that lift a shaft before it turns",
    "thrust": "one thrust bearing of tilting or fixed pads",
    "thrust_line": "axial vibration of a shaft line on its thrust bearing",
}


def kinds() -> Mapping[str, str]:
    """Give the kinds of case and what each describes.

    >>> list(kinds())
    ['journal', 'machine', 'overhung_coupling', 'screw_heel', 'hydrostatic_pad',
    'hydrostatic_thrust_ring', 'hydrostatic_journal', 'jacking_pocket', 'thrust', 'thrust_line']
    """
    return dict(_KINDS)


def template(kind: str) -> str:
    """Give the commented case file of a kind.

    Parameters
    ----------
    kind : str
        One of `kinds`.

    Raises
    ------
    InputError
        E005 for another kind.
    """
    if kind not in _KINDS:
        hint = nearest(kind, _KINDS)
        says = f"{shown(kind)} is not a kind of case; allowed: {', '.join(_KINDS)}"
        raise InputError("E005", f"{says}; {hint}" if hint else says)
    return files("babbitt.case.templates").joinpath(f"{kind}.yaml").read_text(encoding="utf-8")
