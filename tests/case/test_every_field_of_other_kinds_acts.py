"""Every optional field of the other kinds changes the answer, is refused, or is told not to be read.

What only the report shows (notes, source, ranges of figures) changes the report.
"""

import copy
import json
import re
import typing

import pytest
import yaml

from babbitt.case import CaseError, case_from_dict, template
from babbitt.case.part import Part
from babbitt.core.notices import InputError
from babbitt.kinds.footstep.case.footstep import FootstepCase
from babbitt.kinds.hydrostatic.case.hydrostatic_journal import HydrostaticJournalCase
from babbitt.kinds.hydrostatic.case.hydrostatic_pad import HydrostaticPadCase
from babbitt.kinds.hydrostatic.case.hydrostatic_thrust_ring import HydrostaticThrustRingCase
from babbitt.kinds.hydrostatic.case.jacking import JackingPocketCase
from babbitt.kinds.shaft.case.overhung_coupling import OverhungCouplingCase
from babbitt.kinds.shaft_line.case.shaft_line import ThrustLineCase
from babbitt.kinds.thrust.case.thrust import ThrustCase
from babbitt.kinds.tilting_pad_journal.case.bearing import TiltingPadJournalCase
from babbitt.report import content as report_content
from babbitt.solving import solve

pytestmark = pytest.mark.slow

KINDS = {
    "thrust": ThrustCase,
    "thrust_line": ThrustLineCase,
    "hydrostatic_pad": HydrostaticPadCase,
    "hydrostatic_journal": HydrostaticJournalCase,
    "hydrostatic_thrust_ring": HydrostaticThrustRingCase,
    "jacking_pocket": JackingPocketCase,
    "screw_heel": FootstepCase,
    "overhung_coupling": OverhungCouplingCase,
    "tilting_pad_journal": TiltingPadJournalCase,
}
VISCOUS = {"kind": "viscosity", "viscosity": "45 mPa s"}
LUBRICANT = {"lubricant": "ISO VG 46", "supply": {"pressure": "5 MPa", "temperature": "40 degC"}}


def given(kind, *left_out, **fields):
    """A template, with some fields changed and some left out."""
    whole = yaml.safe_load(template(kind)) | fields
    return {name: value for name, value in whole.items() if name not in left_out}


def changed(base, path, value):
    """A copy with one field changed; numbers in the path count entries of a list."""
    made = copy.deepcopy(base)
    *way, last = (int(one) if one.isdigit() else one for one in path.split("."))
    at = made
    for step in way:
        at = at.setdefault(step, {}) if isinstance(at, dict) else at[step]
    at[last] = value
    return made


def tolerated(base):
    """A case with limits of its clearance."""
    return changed(changed(base, "clearance.minimum", "20 um"), "clearance.maximum", "210 um")


OF_THRUST = {
    "pads.face": {"kind": "taper", "depth": "30 um", "fraction": 0.5},
    "pads.crown": "8 um",
    "pads.mass": "36 kg",
    "pads.inertia_radial": "0.12 kg m2",
    "pads.inertia_along": "0.1 kg m2",
    "pads.heights": ["5 um", *["0 um"] * 7],
    "thermal": "global",
    "radial_temperature": "resolved",
    "ring_stiffness": "5 GN/m",
    "tilt": {"offset": "10 um"},
    "tilt.direction": "20 deg",
    "turbulence": "ng_pan",
    "materials": {},
    "materials.bearing_metal": "SnSb12Cu6Pb",
    "limits": {"minimum_film_thickness": "15 um"},
    "limits.temperature": "95 degC",
    "limits.minimum_film_thickness": "12 um",
    "supply.temperature": "50 degC",
    "runout": "8 um",
    "runout.0.lobes": 2,
    "runout.0.phase": "20 deg",
    "oil.density": "950 kg/m3",
    "assumptions": ["The collar is plane."],
}
OF_ALL_RECESSES = {
    "accuracy": "engineering",
    "recess_oil.line_volume": "5 mL",
    "recess_oil.bulk_modulus": "1 GPa",
    "recess_oil.friction_factor": 2.0,
    "restrictor.tubes": 2,
    "restrictor.entry_loss": 2.24,
    "restrictor.viscosity": "25 mPa s",
    "oil": {"viscosity": "40 mPa s"},
    "oil.viscosity": "25 mPa s",
    "oil.density": "900 kg/m3",
    "oil.heat_capacity": "1800 J/(kg K)",
    "supply.temperature": "50 degC",
    "film_temperature": "55 degC",
    "supply.pressure": "4 MPa",
    "supply.leakage": "0.01 L/(min MPa)",
    "supply.relief_pressure": "8 MPa",
    "supply.highest_pressure": "9 MPa",
    "supply.pump_efficiency": 0.7,
    "supply.manifold_volume": "10 mL",
    "frequencies": ["50 Hz"],
    "limits": {"minimum_film_thickness": "30 um"},
    "limits.minimum_film_thickness": "12 um",
    "speed": "700 rpm",
    "load": "9 kN",
    "gap": "45 um",
    "assumptions": ["The runner is rigid."],
}
LIMITED = {"clearance.minimum": "21 um", "clearance.maximum": "200 um"}
OF_ROWS = {
    "recesses.first": "10 deg",
    "recesses.angles": ["-90 deg", "0 deg", "90 deg", "170 deg"],
    "recesses.drain_groove": "6 deg",
}
OF_THE_RING = {"moments": ["100 N m", "50 N m"], "tilt": [1e-4, 0]}
OF_THE_JOURNAL = {
    "load_angle": "-60 deg",
    "eccentricity_ratio": 0.4,
    "attitude_angle": "20 deg",
    "cavitation_pressure": "-50 kPa",
    "rotor_mass": "500 kg",
    "shaft_stiffness": "50 MN/m",
}
OF_POCKETS = {
    "accuracy": "engineering",
    "pockets.first": "-100 deg",
    "pockets.angles": ["-80 deg"],
    "pockets.drain_groove": "5 deg",
    "lift_gap": "60 um",
    "pump_flow": "0.2 L/min",
    "relief_pressure": "25 MPa",
    "pump_efficiency": 0.6,
    "roughness": "2 um",
    "own_restrictors": False,
    "assumptions": ["The oil is cold."],
}
OF_HEELS = {
    "variants": "grooved",
    "groove.depth": "0.4 mm",
    "oil.volumetric_heat_capacity": "1.8 MJ/(m3 K)",
    "oil.density": "900 kg/m3",
    "wall": {"temperature": "30 degC", "conductance": "5 W/K"},
    "ambient_pressure": "0.11 MPa",
    "pressures": "gauge",
    "load_reference": "gauge",
    "eccentricity_ratio": 0.3,
    "tilt": "0.01 deg",
    "options.friction_viscosity": "mixed",
    "options.face_outlet": "printed",
    "options.backflow_viscosity": "groove",
    "options.local_loss_coefficient": 1,
    "options.speed_reduction": 0.1,
    "assumptions": ["The pump runs steadily."],
}
OF_PADS = {
    "pads.first_pivot": "20 deg",
    "pads.pivot_angles": ["45 deg", "135 deg", "225 deg", "310 deg"],
    "pads.extent": "70 deg",
    "pads.width": "60 mm",
    "pads.thickness": "30 mm",
    "pads.clearance": {"kind": "radial", "mean": "160 um"},
    "pads.preload": 0.3,
    "pads.assembled_clearance": {"kind": "radial", "mean": "70 um"},
    "pads.pivot": {"kind": "rocker"},
    "pads.pivot.fraction": 0.55,
    "pads.mass": "2 kg",
    "pads.inertia": "0.01 kg m2",
    "pads.mass_offset": "5 mm",
    "pads.mass_inset": "5 mm",
    "pads.each": [{"preload": 0.3}, {}, {}, {}],
    "clearance_cases": "all",
    "groove_pressure": "0.2 MPa",
    "supply.temperature": "50 degC",
    "supply.flow": "20 L/min",
    "supply.circulation_time": "10 min",
    "feed": "spray_bar",
    "carry_over": 0.5,
    "thermal": "isothermal",
    "effective_temperature": "70 degC",
    "materials": {},
    "materials.bearing_metal": "B83",
    "supply": {"temperature": "50 degC"},
    "surfaces": {"kind": "direct", "roughness_bearing": "4 um", "roughness_journal": "2 um"},
    "load": "9 kN",
    "position": {"x": "3 um", "y": "-30 um"},
    "load_angle": "-60 deg",
    "speed": "5000 rpm",
    "operating_points": [{"name": "half", "load": "5 kN"}],
    "whirl_ratios": [0.3, 0.5, 1.0],
    "rotor_mass": "3 t",
    "shaft_stiffness": "100 MN/m",
    "anticipated_cross_coupling": "9 MN/m",
    "pedestal": {"stiffness_x": "1 GN/m", "stiffness_y": "2 GN/m"},
    "accuracy": "engineering",
    "limits": {"minimum_film_thickness": "35 um"},
    "limits.minimum_film_thickness": "35 um",
    "limits.specific_load": "1 MPa",
    "limits.temperature": "60 degC",
    "limits.transition_film_thickness": "35 um",
    "limits.log_decrement": 5.0,
    "assumptions": ["The pads are new."],
}
OF_PEDESTALS = {
    "pedestal.stiffness_x": "3 GN/m",
    "pedestal.stiffness_y": "3 GN/m",
    "pedestal.damping_x": "200 kN s/m",
    "pedestal.damping_y": "200 kN s/m",
    "pedestal.mass": "300 kg",
    "anticipated_cross_coupling": "9 MN/m",
    "pads.mass": "3 kg",
}
OF_HEATED_PADS = {
    "walls.pads": {},
    "walls.pads.conductivity": "20 W/(m K)",
    "walls.pads.heat_transfer_coefficient": "500 W/(m2 K)",
    "walls.pads.edge_coefficient": "500 W/(m2 K)",
    "walls.pads.temperature": "55 degC",
    "walls.housing": {},
    "walls.housing.temperature": "55 degC",
    "walls.journal": {"temperature": "50 degC"},
    "walls.journal.temperature": "50 degC",
    "walls.journal.shaft_conductance": "5 W/K",
    "walls.journal.ambient_temperature": "20 degC",
    "walls": {"pads": {}},
    "deformation": ["growth"],
    "assumption_sensitivity": True,
    "reference_temperature": "30 degC",
    "materials.pads": "C45",
    "materials.pads.name": "42CrMo4",
    "materials.pads.elastic_modulus": "100 GPa",
    "materials.pads.thermal_expansion": "16e-6 1/K",
    "materials.journal": {"thermal_expansion": "16e-6 1/K"},
    "materials.journal.thermal_expansion": "15e-6 1/K",
    "materials.housing": {"thermal_expansion": "16e-6 1/K"},
    "materials.housing.thermal_expansion": "15e-6 1/K",
    "thermal": "adiabatic",
    "accuracy": "engineering",
    "carry_over": 0.5,
    "supply.temperature": "45 degC",
    "limits.probe_alarm": "60 degC",
    "limits.probe_trip": "100 degC",
}
OF_RIGID_PADS = {
    "walls.pads.conductivity": "20 W/(m K)",
    "walls.pads.heat_transfer_coefficient": "500 W/(m2 K)",
    "walls.pads.edge_coefficient": "500 W/(m2 K)",
    "walls.pads.temperature": "20 degC",
    "walls.housing.temperature": "42 degC",
    "walls.journal.temperature": "50 degC",
    "reference_temperature": "30 degC",
    "pad_bending": "plate",
    "materials.pads.elastic_modulus": "150 GPa",
    "materials.pads.thermal_expansion": "13e-6 1/K",
    "materials.pads.conductivity": "20 W/(m K)",
    "materials.pads.poisson_ratio": 0.4,
    "materials.journal.thermal_expansion": "13e-6 1/K",
    "materials.housing.thermal_expansion": "13e-6 1/K",
    "pads.each.0.material": {"elastic_modulus": "100 GPa", "thermal_expansion": "13e-6 1/K"},
    "pads.each.2.material": {"poisson_ratio": 0.45},
}
"""Of pads whose films leave deformation out: what the fuller model misses is told."""
NAMED_METALS = {
    "materials.pads.name": "42CrMo4",
    "materials.journal.name": "X5CrNi18-10",
    "materials.housing.name": "X5CrNi18-10",
}
OF_PLATES = {
    "pad_bending": "beam",
    "pads.probe_fraction": 0.5,
    "pads.each.0.probe_fraction": 0.5,
    "materials.pads.conductivity": "20 W/(m K)",
    "materials.pads.poisson_ratio": 0.45,
    "pads.each.0.material": {"elastic_modulus": "100 GPa"},
    "pads.each.0.material.name": "X5CrNi18-10",
    "pads.each.0.material.elastic_modulus": "100 GPa",
    "pads.each.0.material.thermal_expansion": "16e-6 1/K",
    "pads.each.0.material.conductivity": "20 W/(m K)",
    "pads.each.0.material.poisson_ratio": 0.45,
}
OF_EACH = {
    "extent": "70 deg",
    "width": "60 mm",
    "thickness": "25 mm",
    "clearance": {"kind": "radial", "mean": "155 um"},
    "preload": 0.4,
    "pivot": {"kind": "spring", "stiffness": "500 MN/m"},
    "mass": "3 kg",
    "inertia": "0.02 kg m2",
    "mass_offset": "4 mm",
    "mass_inset": "4 mm",
}
ELASTIC = {"fraction": 0.55, "damping": "50 kN s/m", "housing_stiffness": "300 MN/m"}
HERTZ = {
    "pivot_radius": "101 mm",
    "housing_radius": "110 mm",
    "elastic_modulus": "100 GPa",
    "poisson_ratio": 0.2,
    "housing_elastic_modulus": "100 GPa",
    "housing_poisson_ratio": 0.2,
    "yield_strength": "50 MPa",
}
PIVOTS = {
    "spring": ({"stiffness": "500 MN/m"}, ELASTIC | {"stiffness": "400 MN/m"}),
    "point": ({"pivot_radius": "100 mm", "housing_radius": "102 mm"}, ELASTIC | HERTZ),
    "line": (
        {"pivot_radius": "100 mm", "housing_radius": "150 mm", "depth": "20 mm", "housing_depth": "30 mm"},
        ELASTIC | HERTZ | {"length": "40 mm", "depth": "25 mm", "housing_depth": "40 mm"},
    ),
    "rocker": ({}, ELASTIC | {"length": "40 mm"}),
    "table": (
        {"points": [{"load": "5 kN", "displacement": "6 um"}]},
        {"fraction": 0.55, "damping": "50 kN s/m", "points": [{"load": "5 kN", "displacement": "8 um"}]},
    ),
    "flexure": (
        {"rotational_stiffness": "10 kN m/rad", "stiffness": "500 MN/m", "tangential_stiffness": "900 MN/m"},
        {
            "fraction": 0.55,
            "rotational_stiffness": "20 kN m/rad",
            "rotational_damping": "200 N m s/rad",
            "stiffness": "400 MN/m",
            "damping": "50 kN s/m",
            "tangential_stiffness": "500 MN/m",
            "tangential_damping": "50 kN s/m",
            "rest_tilt": "0.02 deg",
        },
    ),
}
POINTS = {"load": "7 kN", "load_angle": "-70 deg", "speed": "3000 rpm", "supply_temperature": "45 degC"}
LINE = given("thrust_line", oil=VISCOUS, seating={"stiffness": "2 GN/m", "housing_mass": "12 t"})
PAD, RING, JOURNAL = (
    given(f"hydrostatic_{one}", accuracy="draft", frequencies=["20 Hz"])
    for one in ("pad", "thrust_ring", "journal")
)
JACKING = given("jacking_pocket", accuracy="draft")
ALIKE = given("tilting_pad_journal", accuracy="draft")
PADS = changed(ALIKE, "pads.each", [{}, {}, {}, {}])
HEATED = ALIKE | {
    "thermal": "full",
    "walls": {"pads": {"temperature": "42 degC"}, "housing": {"temperature": "45 degC"},
              "journal": {"shaft_conductance": "2 W/K", "ambient_temperature": "40 degC"}},
    "deformation": ["growth", "bending"],
    "reference_temperature": "20 degC",
    "limits": {"probe_alarm": "95 degC", "probe_trip": "110 degC"},
    "materials": {"pads": {"elastic_modulus": "210 GPa", "thermal_expansion": "12e-6 1/K"},
                  "journal": {"thermal_expansion": "11e-6 1/K"}, "housing": {"thermal_expansion": "12e-6 1/K"}},
}  # fmt: skip
RIGID = PADS | {
    "thermal": "global",
    "walls": {"pads": {"temperature": "42 degC"}, "housing": {"temperature": "45 degC"}},
    "materials": {"pads": {"elastic_modulus": "210 GPa"}, "journal": {"thermal_expansion": "12e-6 1/K"},
                  "housing": {"thermal_expansion": "11e-6 1/K"}},
    "limits": {"minimum_film_thickness": "29 um"},
}  # fmt: skip
CLEARANCES = ("clearance", "assembled_clearance")
LIMITS_OF_PADS = {"minimum": "71 um", "maximum": "160 um"}
LIMITED_PAD = {
    "clearance": {"kind": "radial", "mean": "148 um", "minimum": "140 um", "maximum": "155 um"},
    "assembled_clearance": {"kind": "radial", "mean": "78 um", "minimum": "75 um", "maximum": "90 um"},
}
BY_CLEARANCES = {name: value for name, value in PADS["pads"].items() if name not in ("preload", "clearance")} | (
    LIMITED_PAD | {"each": [LIMITED_PAD, {}, {}, {}]}
)
PUMPED = given("jacking_pocket", "lift_gap", accuracy="draft", pump_flow="0.1 L/min")
HEEL = given("screw_heel", "wall", method="superposition")
STARVED = given("hydrostatic_journal", "load", method="quick", eccentricity_ratio=0.5, speed="20000 rpm",
                supply={"pressure": "0.1 MPa"})  # fmt: skip
LUBRICATED = {name: value for name, value in (PAD | LUBRICANT).items() if name != "oil"}
QUICK = {"method": "quick"}
TESTED = {
    "point pivots": (
        given("thrust", "ring_stiffness", oil=VISCOUS, runout=[{"amplitude": "5 um"}]),
        OF_THRUST | {"load": "400 kN", "film": "50 um"},
    ),
    "heat balance": (
        changed(given("thrust", load="250 kN"), "pads.number", 4),  # half the bearing takes half the time
        {"thermal": "isothermal", "oil.carry_over": 0.5, "limits.temperature": "95 degC", "pads.mass": "36 kg",
         "supply": {"temperature": "48 degC"},
 "oil": {"kind": "temperature", "temperature": "53 degC"}, "supply.temperature": "50 degC"},
    ),
    "given temperature": (
        given("thrust", oil={"kind": "temperature", "temperature": "53 degC"}),
        {"limits.temperature": "50 degC"},
    ),
    "line": (
        LINE,
        {
            "pads.mass": "36 kg",
            "limits.temperature": "95 degC",
            "propeller": {"mass": "20 t", "blades": 4},
            "propeller.damping": "40 kN s/m",
            "shaft.0.inner_diameter": "100 mm",
            "shaft.0.modulus": "200 GPa",
            "shaft.0.density": "7700 kg/m3",
            "shaft.0.end_mass": "300 kg",
            "seating": {"stiffness": "1 GN/m"},
            "seating.damping": "100 kN s/m",
            "seating.housing_mass": "20 t",
            "ripple": [],
            "ripple.0.amplitude": "40 kN",
            "ripple.0.share": "12 %",
            "ripple.0.blade_multiple": 2,
            "ripple.0.order": 3.0,
            "ripple.0.phase": "30 deg",
            "loss_limit": 0.4,
            "limits.axial_amplitude": "150 um",
            "speeds": {"lowest": "100 rpm", "highest": "140 rpm", "number": 2},
            "nonlinear": True,
        },
    ),
    "map": (LINE | {"speeds": {"lowest": "100 rpm", "highest": "140 rpm", "number": 2}}, {"speeds.number": 3}),
    "pad": (PAD, OF_ALL_RECESSES | {"sliding_speed": "0.7 m/s"}),
    "quick pad": (PAD | QUICK, OF_ALL_RECESSES | {"sliding_speed": "0.7 m/s"}),
    "lubricated pad": (LUBRICATED, OF_ALL_RECESSES),
    "quick lubricated pad": (LUBRICATED | QUICK, OF_ALL_RECESSES),
    "pumped pad": (
        PAD | {"supply": {"pump_flow": "0.4 L/min"}},
        OF_ALL_RECESSES | {"supply.pump_flow": "0.5 L/min"},
    ),
    "orifice": (PAD | {"restrictor": {"kind": "orifice", "diameter": "0.4 mm"}}, {"restrictor.discharge": 0.7}),
    "pump of its own": (
        PAD | {"restrictor": {"kind": "constant_flow", "flow": "0.25 L/min"}},
        {"restrictor.leakage": "0.01 L/(min MPa)"},
    ),
    "unlike restrictors": (
        {name: value for name, value in PAD.items() if name != "restrictor"}
        | {"restrictors": [{"kind": "orifice", "diameter": "0.4 mm"}]},
        {
            "restrictors": [{"kind": "orifice", "diameter": "0.5 mm"}],
            "restrictor": {"kind": "orifice", "diameter": "1 mm"},
        },
    ),
    "sliding pad": (
        given("hydrostatic_pad", "speed", accuracy="draft", sliding_speed="0.5 m/s", load="20 kN",
              pad={"kind": "rectangular", "length": "200 mm", "width": "100 mm", "recess_length": "160 mm",
                   "recess_width": "60 mm"}),
        {"sliding_speed": "0.7 m/s", "speed": "700 rpm"},
    ),
    "ring": (RING, OF_ALL_RECESSES | OF_ROWS | OF_THE_RING),
    "quick ring": (RING | QUICK, OF_ALL_RECESSES | OF_ROWS | OF_THE_RING),
    "placed ring": (given("hydrostatic_thrust_ring", "load", "moments", gap="50 um", method="quick"), OF_THE_RING),
    "journal": (JOURNAL, OF_ALL_RECESSES | OF_ROWS | OF_THE_JOURNAL),
    "quick journal": (JOURNAL | QUICK, OF_ALL_RECESSES | OF_ROWS | OF_THE_JOURNAL),
    "placed journal": (
        given("hydrostatic_journal", "load", eccentricity_ratio=0.3, method="quick"), OF_THE_JOURNAL,
    ),
    "recess above its supply": (STARVED, {"restrictor.check_valve": True}),
    "lifted": (JACKING, OF_POCKETS),
    "lifted in tolerances": (tolerated(JACKING), LIMITED),
    "journal in tolerances": (tolerated(JOURNAL | QUICK), LIMITED),
    "heel in tolerances": (tolerated(HEEL), LIMITED),
    "quickly lifted": (JACKING | QUICK, OF_POCKETS),
    "pumped up": (PUMPED, OF_POCKETS),
    "two pockets": (
        JACKING | {"pockets": {"number": 2, "extent": "12 deg", "angles": ["-110 deg", "-70 deg"]}},
        {"own_restrictors": False},
    ),
    "heel": (given("screw_heel"), OF_HEELS | {"method": "superposition"}),
    "heel by superposition": (HEEL, OF_HEELS | {"method": "narrow_groove"}),
    "smooth heel": (HEEL | {"variants": "smooth"}, OF_HEELS),
    "smooth heel in metal": (given("screw_heel", variants="smooth"), OF_HEELS),
    "odd grooves": (changed(HEEL, "groove", HEEL["groove"] | {"land_width": "4 mm", "accept_misfit": True}),
                    {"groove.accept_misfit": False}),
    "tilting pads": (PADS, OF_PADS | {f"pads.each.0.{name}": value for name, value in OF_EACH.items()}),
    "pads on a pedestal": (
        ALIKE | {"pedestal": {"stiffness_x": "1 GN/m", "stiffness_y": "2 GN/m"}}, OF_PEDESTALS,
    ),
    "heated pads": (HEATED, OF_HEATED_PADS),
    "pads that stay rigid": (RIGID, OF_RIGID_PADS),
    "plates that stay rigid": (RIGID | {"pad_bending": "plate"}, {
        "materials.pads.poisson_ratio": 0.4, "pads.each.2.material": {"poisson_ratio": 0.1},
    }),
    "heated pads of the catalogue": (
        HEATED | {"materials": {one: {"name": "C45"} for one in ("pads", "journal", "housing")}}, NAMED_METALS,
    ),
    "plates": (
        changed(HEATED | {"pad_bending": "plate"}, "pads.each",
                [{"material": {"elastic_modulus": "150 GPa"}}, {}, {}, {}]), OF_PLATES,
    ),
    "pads of one temperature": (ALIKE, {"turbulence": "ng_pan"}),
    "pads alike": (ALIKE | {"materials": {"bearing_metal": "B83"}},
                   {"pads.number": 3, "materials.load_character": "shock"}),
    "pads by their clearances": (
        ALIKE | {"pads": BY_CLEARANCES, "clearance_cases": "mean"},
        {f"pads.{one}.{limit}": value for one in CLEARANCES for limit, value in LIMITS_OF_PADS.items()}
        | {f"pads.each.0.{one}.{limit}": value for one in CLEARANCES for limit, value in LIMITS_OF_PADS.items()}
        | {"pads.each.0.assembled_clearance": {"kind": "radial", "mean": "70 um"}},
    ),
    "pads in all their clearances": (
        ALIKE | {"pads": BY_CLEARANCES, "clearance_cases": "all"},
        {f"pads.{one}.{limit}": value for one in CLEARANCES for limit, value in LIMITS_OF_PADS.items()},
    ),
    "rough pads": (
        ALIKE | {"surfaces": {"kind": "direct", "roughness_bearing": "4 um", "roughness_journal": "2 um",
                              "waviness": "1 um"}},
        {"surfaces.mean_deflection": "1 um", "surfaces.tilt_offset": "1 um", "surfaces.wave_factor": 2.0,
         "surfaces.waviness": "3 um"},
    ),
    "placed pads": (
        given("tilting_pad_journal", "load", accuracy="draft", position={"x": "3 um", "y": "-30 um"}),
        {"position": {"x": "9 um", "y": "-30 um"}, "load_angle": "-60 deg"},
    ),
    "pads at a point": (
        PADS | {"operating_points": [{"name": "A", "load": "8 kN"}]},
        {f"operating_points.0.{name}": value for name, value in POINTS.items()}
        | {"operating_points.0.position": {"x": "0 um", "y": "-40 um"}},
    ),
    "isothermal pads": (PADS | {"thermal": "isothermal", "effective_temperature": "60 degC"},
                        {"supply.circulation_time": "10 min", "effective_temperature": "65 degC"}),
    **{
        f"pads on {kind}": (
            changed(changed(PADS, "pads.pivot", {"kind": kind} | own), "pads.each.2.pivot", {"kind": kind} | own),
            {f"pads.{where}pivot.{name}": value for where in ("", "each.2.") for name, value in fields.items()},
        )
        for kind, (own, fields) in PIVOTS.items()
    },
    "coupling": (given("overhung_coupling"), {"assumptions": ["The bearings are rigid."]}),
}  # fmt: skip
"""Cases, each with fields and other valid values of them."""


def told(fields):
    """What a reader of the table or of JSON sees: of each result values, checks and words; or the refusal."""
    try:
        results = solve(case_from_dict(fields)).results
    except (CaseError, InputError) as refusal:
        return str(refusal)
    numbers = [
        (
            result.outcome,
            result.message,
            repr({name: value for name, value in result.values.items() if name != "wall_time"}),
            repr(dict(result.arrays)),
            [(one.code, one.value, one.limit) for one in result.checks],
            dict(result.missing),
        )
        for result in results
    ]
    notices = [one for result in results for one in (*result.warnings, *result.not_checked)]
    return numbers, [f"{one.code} {one.message} {one.values!r}" for one in notices] + [
        one for result in results for one in result.assumptions
    ]


BEFORE = {}


def answer_of(name):
    """What the case says before a change; solved once."""
    if name not in BEFORE:
        BEFORE[name] = told(TESTED[name][0])
    return BEFORE[name]


def is_told_unread(path, words):
    """Whether a warning says that the field is not read."""
    shown = re.sub(r"each\.(\d)", lambda found: f"each (pad {int(found[1]) + 1})", path)
    return any(re.match(rf"W(?:183|174) ([\w., ()]+, )?{re.escape(shown)}(\.\w+)?[,:]", one) for one in words)


@pytest.mark.parametrize(
    ("name", "path"), [(name, path) for name, (_, fields) in TESTED.items() for path in fields]
)
def test_a_changed_field_changes_something(name, path):
    base, fields = TESTED[name]
    before, after = answer_of(name), told(changed(base, path, fields[path]))
    assert not isinstance(before, str)
    if isinstance(after, str):
        assert path.split(".")[-1] in after
    elif is_told_unread(path.split(".")[0] if path.startswith("groove.") else path, after[1]):
        assert after[0] == before[0]
    else:
        assert after != before


SHOWN = {"notes": "Seen aboard.", "source": "Drawing 7."}
RANGES = {"face_gap_from": "8 um", "face_gap_to": "50 um", "clearance_from": "8 um", "clearance_to": "50 um",
          "map_points": 4}  # fmt: skip
"""Of the figures of a heel."""
CHEAP = {
    "tilting_pad_journal": given("tilting_pad_journal", accuracy="draft"),
    "thrust": given("thrust", oil=VISCOUS),
    "thrust_line": LINE,
    "hydrostatic_pad": PAD | QUICK,
    "hydrostatic_journal": JOURNAL | QUICK,
    "hydrostatic_thrust_ring": RING | QUICK,
    "jacking_pocket": JACKING | QUICK,
    "screw_heel": given("screw_heel"),
    "overhung_coupling": given("overhung_coupling"),
    "shaft": given("shaft"),
}


@pytest.mark.parametrize("kind", CHEAP)
@pytest.mark.usefixtures("no_images")
def test_notes_and_source_reach_the_report(kind):
    said = report_of(CHEAP[kind] | SHOWN)
    assert all(words in said for words in SHOWN.values())


def report_of(fields):
    """Report of a case, with its figures."""
    return json.dumps(report_content.content(solve(case_from_dict(fields))), default=str)


def figures(**ranges):
    """Report of a heel with ranges of its figures, without what differs from run to run."""
    return without_time(report_of(HEEL | {"variants": "grooved", "figures": ranges}))


@pytest.fixture(scope="module")
def usual_figures():
    first, again = figures(), figures()
    assert first == again
    return first


@pytest.mark.parametrize("name", RANGES)
def test_a_range_of_figures_changes_a_figure(name, usual_figures):
    assert figures(**{name: RANGES[name]}) != usual_figures


def without_time(said):
    """A report without what differs from run to run."""
    return re.sub(
        r'"(wall_time|case_hash|hash|time|date|created)": [^,}]*', "", re.sub(r"wall_time[^}]*}", "", said)
    )


FIXED = {"pivot": {"kind": "fixed"}, "face": {"kind": "taper", "depth": "40 um", "fraction": 0.7}}
LINES = {"pivot": {"kind": "line", "radius": "290 mm", "fraction": 0.6}}


@pytest.mark.parametrize("kind", ["thrust", "thrust_line"])
@pytest.mark.parametrize(
    ("pads", "unread"),
    [(FIXED, {"pads.inertia_radial", "pads.inertia_along"}), (LINES, {"pads.inertia_radial"}), ({}, set())],
    ids=["fixed", "line pivots", "point pivots"],
)
def test_inertias_that_no_tilt_feels_are_told(kind, pads, unread):
    base = given(kind)
    inertias = {"inertia_radial": "0.06 kg m2", "inertia_along": "0.05 kg m2"}
    (design,) = case_from_dict(base | {"pads": base["pads"] | pads | inertias}).problems()
    said = [f"{one.code} {one.message}" for one in getattr(design, "thrust", design).warnings]
    assert {one for one in ("pads.inertia_radial", "pads.inertia_along") if is_told_unread(one, said)} == unread


SHARED = {"notes", "source", "babbitt", "description", "lubricant", "bearing_metal"}
"""Asked of elsewhere: of the report, and of oils and metals of their own."""


def parts_in(annotation):
    """Pieces that a field may hold."""
    if isinstance(annotation, type) and issubclass(annotation, Part):
        return {annotation}
    return {piece for one in typing.get_args(annotation) for piece in parts_in(one)}


def optional(piece, path=""):
    """Paths of all optional fields of a piece and of what it holds."""
    for name, field in piece.model_fields.items():
        if name not in SHARED or name == "bearing_metal":
            if not field.is_required():
                yield path + name
            if name not in {"restrictors", "bearing_metal"}:
                for held in parts_in(field.annotation):
                    yield from optional(held, f"{path}{name}.")


@pytest.mark.parametrize("kind", KINDS)
def test_every_optional_field_is_asked(kind):
    asked = {
        re.sub(r"\.\d+", "", path)
        for base, fields in TESTED.values()
        if base["kind"] == kind or {base["kind"], kind} <= {"thrust", "thrust_line"}
        or (base["kind"].startswith("hydrostatic") and kind.startswith("hydrostatic"))
        for path in fields
    }  # fmt: skip
    asked |= {f"figures.{name}" for name in RANGES} | {"figures", "method", "options", "groove"}
    assert set(optional(KINDS[kind])) <= asked
