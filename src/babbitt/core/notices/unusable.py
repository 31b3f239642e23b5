"""What is said when the input cannot be used."""

from __future__ import annotations

from babbitt.core.notices.explanation import Explanation

UNUSABLE: dict[str, Explanation] = {
    "E001": Explanation(
        "File cannot be read",
        "The file does not exist, is not readable, is empty, too large, or is not text.",
        "Check the path. A case file is a UTF-8 text file of at most 1 MB.",
    ),
    "E002": Explanation(
        "Not valid YAML",
        "The text cannot be parsed as YAML: a bracket, an indentation, a quotation mark, a duplicate key, "
        "or an anchor that refers to itself.",
        "Look at the line named. `babbitt new journal` writes a file that works.",
    ),
    "E003": Explanation(
        "Field not usable",
        "A field is missing, unknown, of the wrong unit or type, or outside the range that makes sense.",
        "The message names the line, the field, what was given and what is allowed.",
    ),
    "E004": Explanation(
        "Fields contradict each other",
        "Two fields that are each allowed cannot both be true, such as a bore smaller than its journal.",
        "Correct one of the fields named.",
    ),
    "E005": Explanation(
        "Not in the catalogue",
        "A lubricant, material, tolerance class or case of that name is not on board.",
        "`babbitt list lubricants`, `babbitt list materials` show the names; own data can be given in the case.",
    ),
    "E006": Explanation(
        "Value outside a law or a table",
        "A quantity lies outside the range for which a law, fit or table is defined.",
        "The message names the range. Give own data where the catalogue ends.",
    ),
    "E007": Explanation(
        "Output cannot be written",
        "The folder does not exist or is not writable, a file of that name is an input of the run or no output of "
        "Babbitt, or an extra needed for this format is not installed.",
        "Check the path, or choose another name; `pip install '.[report]'` in a clone of Babbitt installs what "
        "PDF, HTML and plots need.",
    ),
    "E101": Explanation(
        "Film cannot be laid out",
        "Lands, grooves, pockets, pressures or speeds do not describe a film: they overlap, are empty, "
        "lie outside "
        "the bearing, or nothing drives or feeds the film.",
        "Correct what the message names.",
    ),
    "E130": Explanation(
        "Footstep cannot be laid out",
        "Lengths, oil, pressures or grooves of a hydrostatic footstep do not describe one: a number is not "
        "positive "
        "or not finite, the radii are out of order, the supply pressure is not above ambient (both absolute), "
        "or the "
        "grooves do not close around the heel.",
        "Correct the quantity named. Groove and land widths are normal to the groove: starts (groove + land) = "
        "2 pi radius sin(angle).",
    ),
    "E201": Explanation(
        "Thrust pad cannot be laid out",
        "Radii, extent, pivot, face or number of the pads of a thrust bearing do not describe pads on a ring: "
        "they "
        "overlap, a pivot lies beside its pad, or a length is not positive.",
        "Correct what the message names.",
    ),
    "E202": Explanation(
        "Pad cannot be balanced on its pivot",
        "No tilt makes the moments of the film about the pivot vanish, or the pad carries nothing. A plane "
        "pad in oil "
        "of one viscosity carries only when its pivot lies behind the middle.",
        "Move the pivot towards the trailing edge (0.55 to 0.65 of the extent are usual), give the pad a "
        "crown, or "
        "turn the shaft the other way.",
    ),
    "E203": Explanation(
        "Shaft line cannot be computed",
        "A mass, length, stiffness, damping, speed or excitation of the shaft line is missing or of the wrong "
        "sign, or "
        "an excitation falls on a frequency of a rod between fixed ends.",
        "Correct what the message names.",
    ),
    "E204": Explanation(
        "Resonance without damping",
        "An excitation lies within 2 % of a natural frequency, and neither films nor propeller nor seating "
        "damp the "
        "line: the amplitude has no bound.",
        "Give the damping of propeller, films or seating, or change speed, stiffness or mass.",
    ),
}


def how_to_install(package: str, extra: str) -> str:
    """How to get a package that an extra needs: Babbitt is installed from a clone, no index has it.

    >>> how_to_install("matplotlib", "report")
    "Install it with: pip install '.[report]' in a clone of Babbitt, or pip install matplotlib"
    """
    return f"Install it with: pip install '.[{extra}]' in a clone of Babbitt, or pip install {package}"
