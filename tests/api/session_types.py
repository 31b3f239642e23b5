"""The lines of a session that a strict type checker reads without issue; `test_types.py` has it do so."""

import numpy as np

import babbitt as bb


def session() -> None:
    """Read by the type checker, never run."""
    lemon = bb.JournalBearing(
        diameter="200 mm",
        width=0.12,
        clearance=bb.relative_clearance(1.5e-3),
        bore=bb.Lobes(preload=0.5),
        grooves=bb.grooves(["0 deg", "180 deg"], extent="20 deg"),
        lubricant="ISO VG 46",
        supply=bb.Supply(temperature="45 degC", pressure="0.15 MPa"),
        materials=bb.Materials(bearing="C10", journal="C45"),
        method=bb.Film(thermal="adiabatic"),
    )
    missing: tuple[str, ...] = lemon.missing
    viscosity: float = bb.lubricant("ISO VG 46").viscosity("60 degC")
    names: tuple[str, ...] = bb.lubricants() + bb.materials() + bb.published_cases()

    point: bb.JournalBearing = lemon.replace(load="10 kN", speed="3000 rpm")
    warmer = lemon.replace({"supply.temperature": "50 degC"})
    diameter: float = point.diameter
    result = point.solve()
    own = point.replace(bore=bb.Gap(lambda angle, z: 5e-6 * np.cos(2 * angle), describe="two waves of 5 um"))
    wavy = bb.JournalBearing(width=0.12, bore=bb.Gap(lambda angle, z: 0.0 * z, describe="round"))
    table = point.solve(speed=np.linspace(100, 500, 9))
    grid = point.sweep({"load": np.array([5e3, 10e3]), "bore.preload": [0.3, 0.5]}, workers=2)
    both = point.compare()
    label: str = both[0].asked.label
    by_standard = both[0]["ISO 7902"].minimum_film_thickness
    slopes = point.gradient(["clearance.mean", "supply.temperature"], of=["minimum_film_thickness", "stiffness"])
    slope = slopes["stiffness"]["clearance.mean"]
    oil = bb.viscosity_law(lambda kelvin: 0.02, coldest="0 degC", warmest=393.15, describe="mine", density=870.0)
    oiled = point.replace(lubricant=oil)
    text: str = point.to_yaml()

    small = bb.JournalBearing(diameter=np.float32(0.2), width=np.float64(0.1), supply={"temperature": "45 degC"})
    clearances = bb.fit("H7/e7"), bb.radial_clearance("65 um"), bb.diametral_clearance("0.13 mm")
    pad = bb.HydrostaticPad(pad=bb.CircularPad(diameter="100 mm", recess_diameter="50 mm"), load="11 kN")
    gear = bb.Machine(bearings=[point, warmer], lubricant="ISO VG 46")
    alone: bb.JournalBearing = gear.bearings[0]
    case = bb.load_case("gear.yaml")
    machine = bb.solve(case)
    verdict: str = machine.verdict.value
    first, needed = machine[0].name, machine.totals["total_flow"]
    agreed = bb.validate("lund_thomsen_1978")
    title: str = bb.explain("W101").title
