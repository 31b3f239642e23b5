"""How far one temperature flatters: ISO 7902 set against films with temperatures, walls and housing of their own.

    python benchmarks/one_temperature.py [number [seed [set]]]

Random bearings of a set, `ordinary` (0.8 to 5 MPa, 2 to 35 m/s, spans of 360 to 120 deg), `fast` (1.5 to 5 MPa, 15
to 60 m/s), `short` (as ordinary, spans of 120 and 90 deg) or `pressed` (1 to 5 MPa, 5 to 35 m/s, with grooves
around the bore or pockets of 0.5 to 0.89 of the width under 0.1 to 1 MPa whose Q_p is 0.5 to 10 times Q_3; its
films on draft grids) or `thick` (ISO VG 22 to 460, 0.8 to 5 MPa, 2 to 60 m/s, any supply element, outlets up to
115 degC; draft grids) or `hot` (ISO VG 150 to 460 that enters at 65 to 80 degC, 10 to 30 m/s, 1.5 to 6.5 MPa, B/D
0.25 to 0.4, grooves around the bore or half of it; outlets up to 115 degC; draft grids) or `heavy` (2.5 to 7 MPa,
1.5 to 20 m/s, 40 to 450 mm, B/D 0.5 to 1.05, 0.8 to 3 permille, ISO VG 22 to 460; draft grids): diameters 60 to
300 mm, B/D 0.5 to 1, clearances 1 to 1.5 times those of Vogelpohl's rule, pockets at both sides of 0.5 to 0.7 of
the width, oils ISO VG 22 to 68 at 40 to 50 degC and 1 to 3 bar, tin and copper alloys. The film is `thermal:
full`. Held against each other are the thinnest film, the hottest bush against the outlet, and outlet against
outlet, with the flow that the supply delivers where that is less; the rise of the hottest bush above the inlet in
K over the root of specific load times speed in MPa m/s; and the Reynolds number. One line a bearing; quartiles,
ends and twentieths; verdicts by both.
"""

import math
import sys
from collections import Counter

import numpy as np

from babbitt import parse_case
from babbitt.case import CaseFile
from babbitt.core.result import Result
from babbitt.solving import solve

Random = np.random.Generator


SETS = {
    "ordinary": ((2.0, 35.0), (0.8, 5.0), (360, 180, 150, 120)),
    "fast": ((15.0, 60.0), (1.5, 5.0), (360, 180, 150, 120)),
    "short": ((2.0, 35.0), (0.8, 5.0), (120, 90)),
}
"""Ranges of speed (m/s) and specific load (MPa), and the spans (deg)."""


def bearing(rng: Random, number: int, chosen: str = "ordinary") -> str:
    speeds, loads, spans = SETS[chosen]
    diameter = float(rng.choice([60, 80, 100, 120, 150, 200, 300]))
    width = rng.uniform(0.5, 1.0) * diameter
    speed = math.exp(rng.uniform(*(math.log(one) for one in speeds)))
    clearance = rng.uniform(1.0, 1.5) * 0.8 * speed**0.25
    return f"""
kind: journal
name: bearing {number}
diameter: {diameter:g} mm
width: {width:.1f} mm
clearance: {{kind: relative, mean: {clearance:.3f} permille}}
span: {rng.choice(spans)} deg
supply_element: {{kind: pocket, width: {rng.uniform(0.5, 0.7) * width:.1f} mm, place: both_sides}}
lubricant: ISO VG {rng.choice([22, 32, 46, 68])}
supply: {{temperature: {rng.choice([40, 45, 50])} degC, pressure: {rng.choice([0.1, 0.2, 0.3])} MPa}}
materials: {{bearing_metal: {rng.choice(["SnSb8Cu4", "CuSn8P", "B83"])}, bearing: C10, journal: C45}}
specific_load: {rng.uniform(*loads):.3f} MPa
surface_speed: {speed:.2f} m/s
"""


def pressed_bearing(rng: Random, number: int) -> str:
    """A bearing much of whose oil the supply presses through the unloaded gap."""
    diameter = float(rng.choice([80, 100, 150, 200, 250, 300]))
    speed = math.exp(rng.uniform(math.log(5.0), math.log(35.0)))
    clearance = rng.uniform(1.0, 1.5) * 0.8 * speed**0.25
    grooved = rng.uniform() < 0.6
    width = rng.uniform(0.4 if grooved else 0.3, 1.0 if grooved else 0.8) * diameter
    if grooved:
        element, span = f"{{kind: groove_360, width: {rng.uniform(0.05, 0.3) * width:.1f} mm}}", 360
    else:
        place = rng.choice(["opposite", "both_sides"])
        element = f"{{kind: pocket, width: {rng.uniform(0.5, 0.89) * width:.1f} mm, place: {place}}}"
        span = rng.choice([360, 180])
    return f"""
kind: journal
name: bearing {number}
diameter: {diameter:g} mm
width: {width:.1f} mm
clearance: {{kind: relative, mean: {clearance:.3f} permille}}
span: {span} deg
supply_element: {element}
lubricant: ISO VG {rng.choice([22, 32, 46, 68])}
supply: {{temperature: {rng.choice([40, 45, 50])} degC, pressure: {rng.choice([0.1, 0.2, 0.5, 1.0])} MPa}}
materials: {{bearing_metal: {rng.choice(["SnSb8Cu4", "CuSn8P", "AlSn20Cu"])}, bearing: C10, journal: C45}}
specific_load: {rng.uniform(1.0, 5.0):.3f} MPa
surface_speed: {speed:.2f} m/s
"""


def thick_bearing(rng: Random, number: int) -> str:
    """A bearing with any oil and any supply element of a standard metal, slow to fast."""
    diameter = float(rng.choice([60, 80, 100, 160, 200, 250, 315, 400]))
    speed = math.exp(rng.uniform(math.log(2.0), math.log(60.0)))
    clearance = rng.uniform(1.0, 2.0) * 0.8 * speed**0.25
    width = rng.uniform(0.3, 1.0) * diameter
    share = rng.uniform(0.1, 0.8)
    pocket = f"{{kind: pocket, width: {share * width:.1f} mm, place: "
    elements = (
        (f"{{kind: groove_360, width: {min(share, 0.4) * width:.1f} mm}}", 360),
        (f"{{kind: groove_180, width: {share * width:.1f} mm}}", 180),
        (f"{pocket}opposite}}", 360),
        (f"{pocket}side}}", 150),
        (f"{pocket}both_sides}}", rng.choice([360, 180, 150, 120])),
        (f"{{kind: hole, diameter: {min(share * width, 0.2 * diameter):.1f} mm, place: both_sides}}", 360),
    )
    element, span = elements[int(rng.integers(len(elements)))]
    return f"""
kind: journal
name: bearing {number}
diameter: {diameter:g} mm
width: {width:.1f} mm
clearance: {{kind: relative, mean: {clearance:.3f} permille}}
span: {span} deg
supply_element: {element}
lubricant: ISO VG {rng.choice([22, 46, 68, 100, 150, 220, 320, 460])}
supply: {{temperature: {rng.uniform(30, 55):.0f} degC, pressure: {rng.choice([0.1, 0.2, 0.4, 0.6])} MPa}}
materials: {{bearing_metal: {rng.choice(["SnSb8Cu4", "CuPb10Sn10", "PbSb15SnAs"])}, bearing: C10, journal: C45}}
specific_load: {math.exp(rng.uniform(math.log(0.8), math.log(5.0))):.3f} MPa
surface_speed: {speed:.2f} m/s
"""


def hot_bearing(rng: Random, number: int) -> str:
    """A narrow bearing with hot thick oil, much of which leaves beside the loaded film."""
    diameter, speed = math.exp(rng.uniform(math.log(150.0), math.log(700.0))), math.exp(rng.uniform(2.3, 3.4))
    width = float(rng.choice([0.25, 0.3, 0.35, 0.4])) * diameter
    half = rng.uniform() < 0.5
    element, share = ("groove_180", 0.5) if half else ("groove_360", 0.2)
    return f"""
kind: journal
name: bearing {number}
diameter: {diameter:.0f} mm
width: {width:.1f} mm
clearance: {{kind: relative, mean: {math.exp(rng.uniform(-0.22, 0.95)):.2f} permille}}
span: {rng.choice([180, 360]) if half else 360} deg
supply_element: {{kind: {element}, width: {rng.uniform(0.05, share) * width:.1f} mm}}
lubricant: ISO VG {rng.choice([150, 220, 320, 460])}
supply: {{temperature: {rng.choice([65, 70, 75, 80])} degC, pressure: {rng.choice([0.1, 0.2, 0.3, 0.5])} MPa}}
materials: {{bearing_metal: {rng.choice(["CuPb10Sn10", "AlSn20Cu", "SnSb8Cu4"])}, bearing: C45, journal: C45}}
specific_load: {math.exp(rng.uniform(math.log(1.5), math.log(6.5))):.2f} MPa
surface_speed: {speed:.1f} m/s
"""


def heavy_bearing(rng: Random, number: int) -> str:
    """A heavily loaded bearing, short of oil or with much of it pressed through the unloaded gap."""
    diameter, speed = math.exp(rng.uniform(math.log(40.0), math.log(450.0))), math.exp(rng.uniform(0.41, 3.0))
    width, share = rng.uniform(0.5, 1.05) * diameter, rng.uniform(0.15, 0.75)
    pocket = f"{{kind: pocket, width: {share * width:.1f} mm, place: "
    elements = (
        f"{{kind: hole, diameter: {min(0.12 * diameter, 0.3 * width):.1f} mm, place: opposite}}",
        f"{pocket}both_sides, extent: {rng.uniform(8, 30):.0f} deg}}",
        f"{pocket}opposite}}",
        f"{{kind: groove_180, width: {0.3 * share * width:.1f} mm}}",
    )
    return f"""
kind: journal
name: bearing {number}
diameter: {diameter:.1f} mm
width: {width:.1f} mm
clearance: {{kind: relative, mean: {rng.uniform(0.8, 3.0):.3f} permille}}
clearance_cases: mean
span: 360 deg
supply_element: {elements[int(rng.integers(len(elements)))]}
lubricant: ISO VG {rng.choice([22, 32, 46, 68, 100, 150, 220, 320, 460])}
supply: {{temperature: {rng.uniform(30, 55):.0f} degC, pressure: {math.exp(rng.uniform(-3.5, 0.0)):.3f} MPa}}
materials: {{bearing_metal: CuSn8P, bearing: C45, journal: C45}}
specific_load: {rng.uniform(2.5, 7.0):.3f} MPa
surface_speed: {speed:.2f} m/s
"""


OF_ITS_OWN = {"pressed": pressed_bearing, "thick": thick_bearing, "hot": hot_bearing, "heavy": heavy_bearing}
"""Sets whose bearings differ in more than speed, load and span."""

HOTTEST_OUTLET = 388.15
"""Outlet in K above which no metal keeps its limit, whatever the film."""


def worse(result: Result, name: str, better: float) -> float:
    """A value, or that with the flow which the supply delivers; `better` is 1 where more is better, else -1."""
    known = [result.values[one] for one in (name, f"starved_{name}") if one in result.values]
    return better * min(better * value for value in known)


def hotter_by(case: CaseFile, temperature: float, thinner: float) -> float:
    """By how much hotter an oil has a share of its viscosity, K; at most 100."""
    oil, warmer = case.problems()[0].lubricant, np.linspace(0.0, 100.0, 401)
    share = oil.dynamic_viscosity(temperature + warmer) / oil.dynamic_viscosity(temperature)
    return float(np.interp(-thinner, -share, warmer))


def main(wanted: int = 48, seed: int = 3, chosen: str = "ordinary") -> None:
    pressed, thick = chosen == "pressed", chosen in ("thick", "hot", "heavy")
    accuracy = "draft" if pressed or thick else "engineering"
    rng, number, rows, verdicts = np.random.default_rng(seed), 0, [], Counter()
    while len(rows) < wanted and number < 10 * wanted:
        number += 1
        text = OF_ITS_OWN[chosen](rng, number) if chosen in OF_ITS_OWN else bearing(rng, number, chosen)
        case = parse_case(text)
        (iso,) = solve(case).results
        if pressed and not (iso.outcome.solved and 0.5 <= iso.supply_flow / iso.side_flow <= 10.0):
            continue
        if thick and not (iso.outcome.solved and iso.outlet_temperature <= HOTTEST_OUTLET):
            continue
        own = f"method: {{kind: film, thermal: full, accuracy: {accuracy}}}"
        (film, *_) = solve(parse_case(f"{text}{own}\n")).results
        if not (iso.outcome.solved and film.outcome.solved):
            print(f"{number}: {iso.outcome.value}; {film.outcome.value}")
            continue
        thin = film.minimum_film_thickness / worse(iso, "minimum_film_thickness", 1.0)
        hot = film.maximum_bush_temperature - worse(iso, "outlet_temperature", -1.0)
        outlet = film.outlet_temperature - worse(iso, "outlet_temperature", -1.0)
        fast = math.sqrt(iso.specific_load * iso.surface_speed * 1e-6)
        rise = (film.maximum_bush_temperature - iso.supply_temperature) / fast
        shear = iso.surface_speed * math.sqrt(iso.effective_viscosity)
        turbulent = film.film_reynolds_number / iso.film_reynolds_number
        loaded = hotter_by(case, worse(iso, "effective_temperature", -1.0), thin) / (1e-6 * iso.specific_load)
        rows.append((thin, hot, outlet, rise, turbulent, hot / shear, loaded))
        near = "W191" in {notice.code for notice in iso.warnings}
        verdicts[(iso.verdict.value, "near" if near else "", film.verdict.value)] += 1
        print(
            f"{number:4d} h_film/h_iso {thin:.2f}, bush less outlet {hot:+.1f} K: "
            f"{iso.verdict.value}{' (W191)' if near else ''}, film {film.verdict.value}",
            flush=True,
        )
    names = (
        "h_film/h_iso",
        "bush less outlet in K",
        "outlet less outlet in K",
        "rise over sqrt(pU)",
        "Re_film/Re_iso",
        "bush less outlet over U sqrt(eta)",
        "loaded film less T_eff over p in K/MPa, the film as its viscosity",
    )
    for said, column in zip(names, np.array(rows).T, strict=True):
        print(said, *(f"{value:.2f}" for value in np.percentile(column, (0, 5, 25, 50, 75, 95, 100))))
    for (iso_says, near, film_says), count in sorted(verdicts.items()):
        print(f"{count:3d}: ISO 7902 {iso_says} {near}, film {film_says}")


if __name__ == "__main__":
    main(*(int(one) for one in sys.argv[1:3]), *sys.argv[3:4])
