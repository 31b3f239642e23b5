"""Five angular spans of one bearing, from Python: the input pinion of a marine reverse gear.

A published study (2023, vol. 15, no. 5, p. 825 ff., table 2) computed this bearing with loaded arcs of 360 to
90 degrees. Its inputs are not printed; those of ``marine_reverse_gear.yaml`` were inferred. With the friction
number of the full bearing times 1.256, one set of inputs reproduces the whole table.

Run it in this folder::

    python input_pinion_spans.py
"""

from dataclasses import replace
from pathlib import Path

from babbitt import load_case
from babbitt.kinds.journal.iso7902 import DesignCase, check

HERE = Path(__file__).parent
FRICTION_FACTOR = 1.256

PUBLISHED = {  # span in degrees: T_ex in °C, P_f in kW, ε, h_min in µm
    360: (74.8, 34.61, 0.50, 92),
    180: (76.5, 31.66, 0.52, 88),  # the power is printed as 61.66, a misprint
    150: (80.9, 29.58, 0.54, 84),
    120: (83.0, 26.58, 0.57, 79),
    90: (84.0, 22.22, 0.61, 71),
}


def input_pinion() -> DesignCase:
    """The bearing as the case file describes it."""
    machine = load_case(HERE / "marine_reverse_gear.yaml")
    return replace(machine.problems()[0], friction_factor=FRICTION_FACTOR)


def with_span(case: DesignCase, span: int) -> DesignCase:
    """The same bearing with another loaded arc."""
    return replace(case, bearing=replace(case.bearing, span=span))


def main() -> None:
    """Print computed and published values side by side."""
    case = input_pinion()
    print("span   T_ex in °C      P_f in kW       ε             h_min in µm")
    for span, (temperature, power, eccentricity, film) in PUBLISHED.items():
        result = check(with_span(case, span))
        print(
            f"{span:3}°   {result.outlet_temperature - 273.15:4.1f} ({temperature:4.1f})   "
            f"{result.friction_power / 1e3:5.2f} ({power:5.2f})   "
            f"{result.eccentricity_ratio:.3f} ({eccentricity:.2f})  "
            f"{result.minimum_film_thickness * 1e6:4.1f} ({film})"
        )
    print("\ncomputed (published)")


if __name__ == "__main__":
    main()
