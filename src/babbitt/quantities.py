"""The vocabulary: each named quantity with its symbol, SI unit, the engineer's unit and one line of meaning.

Tables, reports, plots and the documentation take names and units from here, so that a quantity is called the
same everywhere. Terms follow ISO 4378; symbols follow ISO 7902 where it has one.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from babbitt.units import ZERO_CELSIUS


@dataclass(frozen=True)
class DisplayUnit:
    """How an SI value is shown: ``shown = si * scale + offset``, in tables with a fixed number of decimals.

    What is not larger than `nothing`, in the unit shown, is the round-off of a balance and shown as 0.
    """

    label: str
    scale: float = 1.0
    offset: float = 0.0
    decimals: int = 3
    nothing: float = 0.0


SI = {
    "": DisplayUnit(""),
    "count": DisplayUnit("", decimals=0),
    "percent": DisplayUnit("%", 1e2, decimals=2),
    "permille": DisplayUnit("‰", 1e3),
    "mm": DisplayUnit("mm", 1e3, decimals=2),
    "um": DisplayUnit("µm", 1e6, decimals=1),
    "MPa": DisplayUnit("MPa", 1e-6, decimals=2),
    "degC": DisplayUnit("°C", 1.0, -ZERO_CELSIUS, decimals=1),
    "rpm": DisplayUnit("rpm", 9.549296585513721, decimals=0),
    "deg": DisplayUnit("°", 57.29577951308232, decimals=1),
    "kN": DisplayUnit("kN", 1e-3, decimals=2),
    "Nm": DisplayUnit("N m", decimals=2),
    "kW": DisplayUnit("kW", 1e-3, decimals=2, nothing=1e-7),
    "L/min": DisplayUnit("L/min", 6e4, decimals=1, nothing=1e-9),
    "mPas": DisplayUnit("mPa s", 1e3, decimals=2),
    "mm2/s": DisplayUnit("mm²/s", 1e6, decimals=2),
    "m/s": DisplayUnit("m/s", decimals=2),
    "kg/m3": DisplayUnit("kg/m³", decimals=1),
    "MJ/m3K": DisplayUnit("MJ/(m³ K)", 1e-6),
    "pv": DisplayUnit("MPa m/s", 1e-6, decimals=1),
    "kPa": DisplayUnit("kPa", 1e-3, decimals=1),
    "1e-6/K": DisplayUnit("1e-6/K", 1e6, decimals=1),
    "s": DisplayUnit("s"),
    "t": DisplayUnit("t", 1e-3),
    "N": DisplayUnit("N", decimals=2),
    "MPa3": DisplayUnit("MPa", 1e-6, decimals=4),
    "mm3/s": DisplayUnit("mm³/s", 1e9, decimals=2),
    "kNm": DisplayUnit("kN m", 1e-3, decimals=2),
    "N/um": DisplayUnit("N/µm", 1e-6, decimals=2),
    "um2": DisplayUnit("µm", 1e6, decimals=2),
    "MN/m": DisplayUnit("MN/m", 1e-6),
    "kNs/m": DisplayUnit("kN s/m", 1e-3),
    "kNm/rad": DisplayUnit("kN m/rad", 1e-3),
    "Nms/rad": DisplayUnit("N m s/rad"),
    "W": DisplayUnit("W", decimals=1),
    "K": DisplayUnit("K", decimals=1),
    "cm2": DisplayUnit("cm²", 1e4, decimals=2),
    "mrad": DisplayUnit("mm/m", 1e3, decimals=4),
    "kNm/mrad": DisplayUnit("kN m/mrad", 1e-6),
    "GN/m": DisplayUnit("GN/m", 1e-9),
    "MNs/m": DisplayUnit("MN s/m", 1e-6),
    "Hz": DisplayUnit("Hz", 0.15915494309189535),
    "%": DisplayUnit("%", 1e2, decimals=1),
    "urad": DisplayUnit("µrad", 1e6, decimals=1),
}


@dataclass(frozen=True)
class Quantity:
    """A named quantity.

    Attributes
    ----------
    name : str
        Key in results and JSON.
    symbol : str
        As printed in equations, in plain Unicode.
    unit : str
        SI unit of the value in results and JSON.
    display : DisplayUnit
        The engineer's unit.
    digits : int
        Significant digits worth showing.
    meaning : str
        One line.
    """

    name: str
    symbol: str
    unit: str
    display: DisplayUnit
    digits: int
    meaning: str

    def shown(self, value: float) -> float:
        """Convert an SI value to the engineer's unit."""
        return value * self.display.scale + self.display.offset

    def format(self, value: float) -> str:
        """Write an SI value in the engineer's unit, without the unit, as every table and check shows it.

        The decimals are those of the unit, whatever the size of the number, so that equal quantities look equal;
        a number below one keeps three significant digits.

        >>> film, power = QUANTITIES["minimum_film_thickness"], QUANTITIES["friction_power"]
        >>> film.format(52.34e-6), power.format(28503.0), power.format(141.8)
        ('52.3', '28.50', '0.142')
        >>> power.format(-9.6e-7)
        '0'
        """
        shown, decimals = self.shown(value), self.display.decimals
        if abs(shown) <= self.display.nothing and not self.display.offset:
            return "0"
        size = abs(shown)
        if not self.display.offset and round(size, LEAST_DIGITS) < 1.0:
            decimals = max(decimals, LEAST_DIGITS - 1 - math.floor(math.log10(size)))
        return f"{shown:.{decimals}f}" if decimals <= LONGEST and size < 1e7 else f"{shown:.{LEAST_DIGITS - 1}e}"


LEAST_DIGITS, LONGEST = 3, 6
"""Significant digits of a number below one; decimals beyond which an exponent reads better."""


def _q(name: str, symbol: str, unit: str, display: str, digits: int, meaning: str) -> Quantity:
    return Quantity(name, symbol, unit, SI[display], digits, meaning)


QUANTITIES: dict[str, Quantity] = {
    q.name: q
    for q in (
        # geometry
        _q("diameter", "D", "m", "mm", 4, "Nominal bearing inside diameter"),
        _q("width", "B", "m", "mm", 4, "Bearing width"),
        _q("width_ratio", "B/D", "1", "", 3, "Relative bearing width"),
        _q("angular_span", "Ω", "rad", "deg", 3, "Angular span of the bearing arc"),
        _q("relative_clearance", "ψ₂₀", "1", "permille", 4, "Relative clearance 2c/D at 20 °C"),
        _q("operating_relative_clearance", "ψ_eff", "1", "permille", 4, "Relative clearance at T_eff"),
        _q("expansion_bearing", "α_B", "1/K", "1e-6/K", 3, "Thermal expansion of the bearing"),
        _q("expansion_journal", "α_J", "1/K", "1e-6/K", 3, "Thermal expansion of the journal"),
        # operation
        _q("load", "F", "N", "kN", 4, "Bearing load"),
        _q("specific_load", "p̄", "Pa", "MPa", 3, "Load per projected area F/(B D)"),
        _q(
            "angular_speed",
            "ω_J",
            "rad/s",
            "rpm",
            4,
            "Rotational speed of the journal",
        ),
        _q("hydrodynamic_speed", "ω_h", "rad/s", "rpm", 4, "Effective hydrodynamic speed ω_J + ω_B"),
        _q("surface_speed", "U", "m/s", "m/s", 3, "Surface speed of the journal"),
        _q("pressure_speed_product", "p̄U", "Pa m/s", "pv", 3, "Specific load times surface speed"),
        # film
        _q("eccentricity_ratio", "ε", "1", "", 3, "Relative eccentricity e/c"),
        _q("attitude_angle", "β", "rad", "deg", 3, "Angle from the load line to the line of centres"),
        _q(
            "narrowest_gap_angle",
            "φ_h",
            "rad",
            "deg",
            3,
            "Direction of the narrowest gap, counter-clockwise from +x",
        ),
        _q("load_angle", "φ_F", "rad", "deg", 3, "Direction of the load, counter-clockwise from +x"),
        _q("minimum_film_thickness", "h_min", "m", "um", 3, "Minimum film thickness"),
        _q("sommerfeld_number", "So", "1", "", 4, "Sommerfeld number F ψ²/(B D η ω) of ISO 7902"),
        _q("american_sommerfeld_number", "S", "1", "", 4, "American Sommerfeld number η N L D (R/c)²/F"),
        _q("maximum_pressure", "p_max", "Pa", "MPa", 3, "Maximum film pressure"),
        _q("maximum_displacement", "u_max", "m", "um", 3, "Largest displacement of the bore by the film pressure"),
        _q("friction_number", "f/ψ", "1", "", 4, "Friction coefficient over relative clearance"),
        _q("friction_coefficient", "f", "1", "", 3, "Friction coefficient"),
        _q("friction_torque", "M_f", "N m", "Nm", 4, "Friction torque on the journal"),
        _q("friction_power", "P_f", "W", "kW", 4, "Friction power, equal to the heat flow"),
        _q("side_flow_number", "Q₃*", "1", "", 4, "Side flow Q3/(D³ ψ ω)"),
        _q("side_flow", "Q₃", "m3/s", "L/min", 3, "Oil flow due to the film pressure"),
        _q("supply_flow_number", "Q_p*", "1", "", 4, "Supply flow Qp η/(D³ ψ³ p_en)"),
        _q("supply_flow", "Q_p", "m3/s", "L/min", 3, "Oil flow due to the supply pressure"),
        _q("given_flow", "Q_given", "m3/s", "L/min", 3, "Oil flow that the supplies are given"),
        _q("surplus_flow", "Q_over", "m3/s", "L/min", 3, "Given flow that returns without passing the film"),
        _q("least_fill", "θ_min", "1", "", 3, "Least share of the gap that a supply fills"),
        _q("full_film_share", "A_f", "1", "", 3, "Share of the bearing surface that carries a full film"),
        _q("turbulent_share", "A_t", "1", "", 3, "Share of the bearing surface where the film is not laminar"),
        _q("total_flow", "Q", "m3/s", "L/min", 3, "Total oil flow Q3 + Qp"),
        _q("film_reynolds_number", "Re", "1", "count", 3, "Reynolds number of the film ρ U c/η"),
        _q("critical_reynolds_number", "Re_cr", "1", "count", 4, "Reynolds number where laminar flow ends"),
        # oil and heat
        _q("supply_temperature", "T_en", "K", "degC", 3, "Oil temperature at the inlet"),
        _q("outlet_temperature", "T_ex", "K", "degC", 3, "Oil temperature at the outlet"),
        _q("effective_temperature", "T_eff", "K", "degC", 3, "Effective temperature of the film"),
        _q("bearing_temperature", "T_B", "K", "degC", 3, "Bearing temperature"),
        _q("ambient_temperature", "T_amb", "K", "degC", 3, "Ambient temperature"),
        _q("maximum_temperature", "T_max", "K", "degC", 3, "Maximum film temperature"),
        _q("hot_spot_angle", "φ_T", "rad", "deg", 3, "Direction of the hottest place of the film, from +x"),
        _q("hot_spot_position", "z_T", "m", "mm", 3, "Axial place of the hottest place of the film"),
        _q(
            "groove_temperature",
            "T_gr",
            "K",
            "degC",
            3,
            "Highest mixing temperature of grooves, pockets and holes",
        ),
        _q("groove_temperatures", "T_gr", "K", "degC", 3, "Mixing temperature of every groove, pocket and hole"),
        _q("groove_angles", "φ_gr", "rad", "deg", 3, "Direction of every groove, pocket and hole, from +x"),
        _q("groove_fresh_flows", "Q_gr", "m3/s", "L/min", 3, "Fresh oil that every groove, pocket and hole gives"),
        _q("groove_returned_flows", "Q_b,gr", "m3/s", "L/min", 3, "Warm oil that goes back into every one"),
        _q("returned_flow", "Q_b", "m3/s", "L/min", 3, "Warm oil that goes back into supplies"),
        _q("heat_returned", "P_b", "W", "kW", 4, "Heat that goes back into supplies, part of P_oil"),
        _q("mean_bush_temperature", "T_B,m", "K", "degC", 3, "Mean temperature of the bore"),
        _q("maximum_bush_temperature", "T_B,max", "K", "degC", 4, "Maximum temperature of the bush"),
        _q(
            "mean_wall_temperature",
            "T_w,m",
            "K",
            "degC",
            3,
            "Mean temperature of the film at the wall of the bore",
        ),
        _q(
            "maximum_wall_temperature",
            "T_w,max",
            "K",
            "degC",
            4,
            "Highest film temperature at the wall of the bore",
        ),
        _q("journal_temperature", "T_J", "K", "degC", 4, "Journal temperature"),
        _q("film_dissipation", "P_d", "W", "kW", 4, "Heat born in the film: friction power and pumping power"),
        _q("heat_film_to_bush", "P_fB", "W", "kW", 4, "Heat from film to bush"),
        _q("heat_film_to_journal", "P_fJ", "W", "kW", 4, "Heat from film to journal"),
        _q("effective_viscosity", "η_eff", "Pa s", "mPas", 4, "Dynamic viscosity at T_eff"),
        _q("effective_kinematic_viscosity", "ν_eff", "m2/s", "mm2/s", 4, "Kinematic viscosity at T_eff"),
        _q("density", "ρ", "kg/m3", "kg/m3", 4, "Density of the oil at T_eff"),
        _q("volumetric_heat_capacity", "ρc", "J/(m3 K)", "MJ/m3K", 4, "Volumetric heat capacity of the oil"),
        _q("heat_to_oil", "P_oil", "W", "kW", 4, "Heat carried away by the oil"),
        _q("heat_to_surroundings", "P_amb", "W", "kW", 4, "Heat given off by the housing"),
        _q("supply_pressure", "p_s", "Pa", "kPa", 4, "Gauge pressure of the supply system"),
        _q("element_pressure", "p_en", "Pa", "kPa", 4, "Gauge pressure at the supply element"),
        _q("tube_loss", "Δp_t", "Pa", "kPa", 3, "Pressure loss in the supply tube"),
        _q("hole_loss", "Δp_h", "Pa", "kPa", 3, "Pressure loss in the supply hole"),
        # limits and screening
        _q("empirical_film_limit", "h_lim,1", "m", "um", 3, "Permissible film thickness by experience"),
        _q("geometric_film_limit", "h_lim,2", "m", "um", 3, "Permissible film thickness by surface geometry"),
        _q(
            "transition_film_thickness",
            "h_tr",
            "m",
            "um",
            3,
            "Film thickness at transition to mixed friction",
        ),
        _q("transition_speed", "N_tr", "rad/s", "rpm", 3, "Hydrodynamic speed of transition to mixed friction"),
        _q(
            "stability_relative_clearance",
            "ψ_min",
            "1",
            "permille",
            3,
            "Least clearance against whirl (Orlov)",
        ),
        _q(
            "recommended_relative_clearance",
            "ψ_rec",
            "1",
            "permille",
            3,
            "Recommended mean relative clearance",
        ),
        # dynamics of the film
        _q("stiffness", "K", "N/m", "MN/m", 4, "Film stiffness, dF = -K dx, [[xx, xy], [yx, yy]]"),
        *(
            _q(
                f"stiffness_{axes}",
                f"k_{axes}",
                "N/m",
                "MN/m",
                4,
                f"Film stiffness, force in {row} over move in {column}",
            )
            for axes, row, column in (("xx", "x", "x"), ("xy", "x", "y"), ("yx", "y", "x"), ("yy", "y", "y"))
        ),
        _q("damping", "C", "N s/m", "kNs/m", 4, "Film damping, dF = -C dx', [[xx, xy], [yx, yy]]"),
        *(
            _q(
                f"damping_{axes}",
                f"c_{axes}",
                "N s/m",
                "kNs/m",
                4,
                f"Film damping, force in {row} over speed in {column}",
            )
            for axes, row, column in (("xx", "x", "x"), ("xy", "x", "y"), ("yx", "y", "x"), ("yy", "y", "y"))
        ),
        *(
            _q(
                f"{name}_{axes}",
                f"{symbol}_{axes}",
                unit,
                shown,
                4,
                f"{title} against tilt, moment int z dF_{axes[0]} over {motion} d{axes[1]}/dz",
            )
            for name, symbol, unit, shown, title, motion in (
                ("tilt_stiffness", "k_φ", "N m/rad", "kNm/rad", "Film stiffness", "slope"),
                ("tilt_damping", "c_φ", "N m s/rad", "Nms/rad", "Film damping", "rate of the slope"),
            )
            for axes in ("xx", "xy", "yx", "yy")
        ),
        _q(
            "tilt_stiffness",
            "K_φ",
            "SI",
            "",
            4,
            "Film stiffness, d(F_x, F_y, M_x, M_y) = -K d(x, y, dx/dz, dy/dz), M = int z dF; N/m, N, N m/rad",
        ),
        _q(
            "tilt_damping",
            "C_φ",
            "SI",
            "",
            4,
            "Film damping in the motions of tilt_stiffness, those units times s",
        ),
        *(
            _q(f"film_moment_{axis}", f"M_{axis}", "N m", "Nm", 4, f"Moment of the film, int z dF_{axis}")
            for axis in "xy"
        ),
        _q("rotor_mass", "m", "kg", "t", 4, "Mass of the rigid rotor carried by the bearing"),
        _q("critical_mass", "m_cr", "kg", "t", 4, "Mass above which a rigid rotor whirls"),
        _q(
            "whirl_frequency_ratio",
            "ν_w",
            "1",
            "",
            3,
            "Whirl frequency over rotational frequency; 0: cannot whirl",
        ),
        _q("threshold_speed", "N_w", "rad/s", "rpm", 4, "Speed above which the rotor whirls"),
        _q("shaft_stiffness", "k_s", "N/m", "MN/m", 4, "Stiffness of the shaft between rotor mass and journal"),
        _q(
            "critical_mass_elastic", "m_cr,e", "kg", "t", 4, "Mass above which a rotor on the elastic shaft whirls"
        ),
        _q(
            "threshold_speed_elastic",
            "N_w,e",
            "rad/s",
            "rpm",
            4,
            "Speed above which the rotor on the elastic shaft whirls",
        ),
        _q("preload", "m_l", "1", "", 3, "Preload of the lobes, 1 - c/c_l"),
        _q("lobe_clearance", "c_l", "m", "um", 4, "Radial clearance of the lobes"),
        _q("equilibria", "n_eq", "1", "count", 1, "Places found where the journal can rest under its load"),
        # orbit under a changing load
        _q("orbit", "r(t)", "SI", "", 4, "Rows of angle turned, x, y, F_x, F_y, least film, largest pressure"),
        _q("orbit_largest_eccentricity_ratio", "ε_max", "1", "", 3, "Largest relative eccentricity on the orbit"),
        _q("orbit_minimum_film_thickness", "h_min,o", "m", "um", 3, "Least film thickness on the orbit"),
        _q("orbit_minimum_film_direction", "φ_min", "rad", "deg", 3, "Direction of the journal there, from +x"),
        _q("orbit_minimum_film_turned", "τ_min", "rad", "deg", 3, "Angle that the journal has turned by then"),
        _q("orbit_maximum_pressure", "p_max,o", "Pa", "MPa", 3, "Maximum film pressure on the orbit"),
        _q("orbit_friction_power", "P_f,o", "W", "kW", 4, "Mean friction power on the orbit, torque times speed"),
        _q("orbit_load_power", "P_F,o", "W", "kW", 3, "Mean power that the moving load does on the film"),
        _q(
            "orbit_load_error",
            "δ_F",
            "1",
            "",
            2,
            "Grid error of the force at the thinnest film, over the load",
        ),
        _q("orbit_cycles", "n_o", "1", "count", 2, "Cycles until the orbit closed"),
        _q("mass_balance_error", "δ_m", "1", "", 2, "Oil lost in the film over the oil supplied"),
        _q("energy_balance_error", "δ_E", "1", "", 2, "Heat balance defect over friction power"),
        _q("minimum_film_thickness_error", "δ_h", "1", "percent", 2, "Error of h_min by the grid, estimated"),
        _q("position_error", "δ_e", "1", "percent", 2, "Error of the position by the grid over c, estimated"),
        _q("load_error", "δ_F", "1", "percent", 2, "Error of the load found by the grid, estimated"),
        _q("stiffness_error", "δ_K", "1", "percent", 2, "Error of the stiffness matrix by the grid, estimated"),
        _q("damping_error", "δ_C", "1", "percent", 2, "Error of the damping matrix by the grid, estimated"),
        _q("iterations", "n", "1", "count", 3, "Evaluations of the temperature iteration"),
        _q("wall_time", "t", "s", "s", 3, "Time taken"),
        # films of one dimension
        _q("rupture_angle", "θ_r", "rad", "deg", 4, "Angle of rupture from the widest gap"),
        _q("narrow_zone", "Δθ", "rad", "deg", 3, "Angle over which the film is within 1.1 h_min"),
        _q("load_along_eccentricity", "F_c", "N", "kN", 4, "Load along the line of centres"),
        _q("load_across_eccentricity", "F_s", "N", "kN", 4, "Load normal to the line of centres"),
        _q("relative_load", "W_pr", "1", "", 4, "Load along the line of centres over B D times 101 325 Pa"),
        _q("film_flow", "Q_f", "m3/s", "L/min", 4, "Oil flow around the film"),
        _q("flow_inconsistency", "δ_Q", "1", "", 3, "Variation of the local flow over its mean in the full film"),
        _q("rupture_temperature", "T_r", "K", "degC", 4, "Film temperature at rupture"),
        _q("heat_to_shaft", "P_sh", "W", "kW", 4, "Heat led away along the shaft"),
        _q("mean_temperature_load_ratio", "F/F_m", "1", "", 3, "Load over that of one mean temperature"),
        _q("mean_temperature_outlet", "T_ex,m", "K", "degC", 4, "Outlet temperature by one mean temperature"),
        _q("film_angle", "θ", "rad", "deg", 4, "Angle from the widest gap in the direction of rotation"),
        _q("film_direction", "φ", "rad", "deg", 4, "Direction of the same place, counter-clockwise from +x"),
        _q("film_thickness", "h", "m", "um", 4, "Film thickness over the angle"),
        _q("film_pressure", "p", "Pa", "MPa", 4, "Film pressure over the angle"),
        _q("film_temperature", "T", "K", "degC", 4, "Film temperature over the angle"),
        _q("bush_temperature", "T_B(θ)", "K", "degC", 4, "Temperature of the bush over the angle"),
        *(
            one
            for n, sub, where in ((1, "₁", "before"), (2, "₂", "behind"))
            for one in (
                _q(f"segment_{n}_flow", f"Q{sub}", "m3/s", "L/min", 4, f"Flow {where} the groove"),
                _q(f"segment_{n}_power", f"A{sub}", "W", "kW", 4, f"Friction power {where} the groove"),
                _q(f"segment_{n}_heat", f"q{sub}", "W", "kW", 4, f"Heat given to the oil {where} the groove"),
                _q(
                    f"segment_{n}_inlet_temperature",
                    f"T_in{sub}",
                    "K",
                    "degC",
                    4,
                    f"Inlet temperature {where} groove",
                ),
                _q(
                    f"segment_{n}_mean_temperature",
                    f"T_m{sub}",
                    "K",
                    "degC",
                    4,
                    f"Mean temperature {where} groove",
                ),
                _q(
                    f"segment_{n}_outlet_temperature",
                    f"T_out{sub}",
                    "K",
                    "degC",
                    4,
                    f"Outlet temperature {where} groove",
                ),
                _q(f"segment_{n}_viscosity", f"η{sub}", "Pa s", "mPas", 4, f"Viscosity {where} the groove"),
                _q(f"segment_{n}_constant", f"C{sub}", "1", "", 4, f"Constant of integration {where} the groove"),
            )
        ),
        _q("groove_pressure", "p_g", "Pa", "MPa", 4, "Gauge pressure in the groove"),
        _q("groove_side_flow", "Q_g", "m3/s", "L/min", 4, "Flow out of the ends of the groove"),
        _q("groove_load_ratio", "F/F_0", "1", "", 3, "Load over that of the ungrooved film at the same gap"),
        _q("ungrooved_specific_load", "p̄_0", "Pa", "MPa", 3, "Specific load without groove at the same gap"),
        _q("ungrooved_outlet_temperature", "T_ex,0", "K", "degC", 4, "Outlet without groove at the same gap"),
        _q("cut_specific_load", "p̄_cut", "Pa", "MPa", 3, "Specific load of the cut film at the same gap"),
        _q("cut_outlet_temperature", "T_ex,cut", "K", "degC", 4, "Outlet of the cut film at the same gap"),
        _q("ungrooved_eccentricity_at_load", "ε_0", "1", "", 3, "Eccentricity without groove under the same load"),
        _q("ungrooved_film_at_load", "h_0", "m", "um", 3, "Least film without groove under the same load"),
        _q("ungrooved_outlet_at_load", "T_ex,0F", "K", "degC", 4, "Outlet without groove under the same load"),
        _q("cut_outlet_at_load", "T_ex,cF", "K", "degC", 4, "Outlet of the cut film under the same load"),
        # hydrostatic footstep with a smooth or screw-grooved heel
        _q("face_gap", "h", "m", "um2", 4, "Face gap of the footstep"),
        _q("heel_clearance", "δ", "m", "um2", 4, "Radial clearance of the heel"),
        _q("rim_pressure", "p₁", "Pa", "MPa3", 4, "Pressure at the rim of the heel, absolute"),
        _q("face_flow", "Q₂", "m3/s", "mm3/s", 4, "Flow from recess to rim; negative: the rim feeds the recess"),
        _q("heel_groove_flow", "Q_k", "m3/s", "mm3/s", 4, "Flow of the groove towards the rim"),
        _q(
            "heel_leakage",
            "Q_l",
            "m3/s",
            "mm3/s",
            4,
            "Leakage through the clearance to ambient, beside the groove",
        ),
        _q(
            "heel_net_flow",
            "Q_n",
            "m3/s",
            "mm3/s",
            4,
            "Net flow of clearance and groove to ambient; negative: oil is drawn in",
        ),
        _q("rim_excess_flow", "ΔQ", "m3/s", "mm3/s", 4, "Oil that the rim receives and cannot give away"),
        _q("groove_outlet_temperature", "θ₁′", "K", "degC", 4, "Temperature of the oil at the end of the groove"),
        _q("face_outlet_temperature", "θ₁″", "K", "degC", 4, "Temperature of the oil that leaves the face gap"),
        _q("rim_temperature", "θ", "K", "degC", 4, "Temperature of the mixed oil at the rim"),
        _q("face_film_temperature", "θ_f", "K", "degC", 4, "Temperature of the film in face gap and recess"),
        _q("clearance_film_temperature", "θ_c", "K", "degC", 4, "Temperature of the film in the clearance"),
        _q("face_gap_stiffness", "K_a", "N/m", "N/um", 3, "Axial stiffness, -dF over the face gap"),
        _q("face_gap_damping", "D_a", "N s/m", "kNs/m", 3, "Axial damping, -dF over the speed of the face gap"),
        _q("load_over_clearance", "dF/dδ", "N/m", "N/um", 3, "Change of the load with the clearance"),
        _q("rim_drain_number", "n_r", "1", "", 3, "Slope of outflow less inflow of the rim; positive: stable"),
        _q("load_ratio_to_smooth", "F/F_s", "1", "", 4, "Load over that of the smooth heel"),
        _q("friction_ratio_to_smooth", "P_s/P_f", "1", "", 4, "Friction power of the smooth heel over this one"),
        _q("critical_clearance", "δ_cr", "m", "um2", 4, "Clearance at which the face gap passes no oil"),
        _q("critical_temperature", "θ_cr", "K", "degC", 4, "Temperature of the groove at critical clearance"),
        _q("fold_clearance", "δ_f", "m", "um2", 4, "Smallest clearance with a steady state at this face gap"),
        _q("groove_reynolds_number", "Re_k", "1", "", 3, "Reynolds number of the groove, oil as it enters"),
        _q("clearance_reynolds_number", "Re_δ", "1", "", 3, "Reynolds number of the clearance"),
        _q("centrifugal_pressure", "Δp_c", "Pa", "kPa", 3, "Pressure that rotation adds from recess to rim"),
        _q("leak_factor", "k_ε", "1", "", 4, "Leakage of the eccentric clearance over the concentric one"),
        _q("leakage_side_force", "F_ε", "N", "N", 4, "Side force of the leakage; positive: away from the centre"),
        _q("heel_force_along", "F_x", "N", "N", 4, "Force of the turning film along the eccentricity"),
        _q("heel_force_across", "F_y", "N", "N", 4, "Force of the turning film across the eccentricity"),
        _q("balance_error", "δ_R", "1", "", 2, "Relative error of the balance at the rim"),
        # hydrostatics
        _q("gap", "h", "m", "um", 4, "Gap of the pad"),
        _q("recess_pressure", "p_r", "Pa", "MPa", 4, "Gauge pressures of the recesses"),
        _q("pressure_ratio", "β_r", "1", "", 4, "Recess over supply pressure, of every recess"),
        _q("mean_pressure_ratio", "β_m", "1", "", 4, "Recess over supply pressure, mean of the recesses"),
        _q("restrictor_flow", "Q_r", "m3/s", "L/min", 4, "Oil flow through every restrictor"),
        _q("pumping_power", "P_p", "W", "kW", 4, "Supply pressure times flow"),
        _q("pump_power", "P_pu", "W", "kW", 4, "Power at the shaft of the pump"),
        _q("power_ratio", "P_f/P_p", "1", "", 3, "Friction power over pumping power"),
        _q("temperature_rise", "ΔT", "K", "K", 3, "Rise of the oil between manifold and drain"),
        _q("effective_area", "A_e", "m2", "cm2", 4, "Load over recess pressure"),
        _q("gap_stiffness", "K_z", "N/m", "MN/m", 4, "Stiffness of the pad along its axis, slow motion"),
        _q("gap_damping", "C_z", "N s/m", "kNs/m", 4, "Damping of the pad along its axis, slow motion"),
        _q("least_tilt_stiffness", "K_φ", "N m/rad", "kNm/mrad", 4, "Least stiffness against tilting"),
        _q("tilt_stiffness", "K_φφ", "N m/rad", "kNm/mrad", 4, "Stiffness against the tilts about x and y"),
        _q("runner_stiffness", "K", "N/m", "MN/m", 4, "Stiffness of the runner in z and the tilts about x and y"),
        _q("runner_damping", "C", "N s/m", "kNs/m", 4, "Damping of the runner in z and the tilts about x and y"),
        _q("dynamic_frequency", "f_d", "rad/s", "Hz", 4, "Frequencies of the dynamic coefficients"),
        _q("dynamic_stiffness", "K_ν", "N/m", "MN/m", 4, "Stiffness at every frequency, row by row"),
        _q("dynamic_damping", "C_ν", "N s/m", "kNs/m", 4, "Damping at every frequency, row by row"),
        _q(
            "compressibility_damping_loss",
            "δ_C",
            "1",
            "percent",
            3,
            "Damping lost to compressible oil",
        ),
        _q("network_stability", "λ_min", "1", "", 3, "Least eigenvalue of the recess network over the largest"),
        _q("stiffest_pressure_ratio", "β_opt", "1", "", 3, "Pressure ratio of greatest stiffness, gap given"),
        _q("least_power_gap", "h_P", "m", "um", 3, "Gap or clearance of least total power at these pressures"),
        _q("least_power_viscosity", "η_P", "Pa s", "mPas", 4, "Viscosity of least total power at this gap"),
        _q("load_capacity", "W_max", "N", "kN", 4, "Load at the least gap allowed"),
        _q("tilt_x", "φ_x", "rad", "mrad", 4, "Tilt of the runner about x"),
        _q("tilt_y", "φ_y", "rad", "mrad", 4, "Tilt of the runner about y"),
        _q("moment_x", "M_x", "N m", "Nm", 4, "Moment of the film about x"),
        _q("moment_y", "M_y", "N m", "Nm", 4, "Moment of the film about y"),
        _q("recess_reynolds_number", "Re_r", "1", "count", 3, "Reynolds number in the recess"),
        _q(
            "restrictor_reynolds_number",
            "Re_c",
            "1",
            "count",
            3,
            "Greatest Reynolds number in the capillaries",
        ),
        _q("edge_inertia", "Π_e", "1", "", 3, "ρ U²/2 at the recess edge over the lowest recess pressure"),
        _q("cavitated_share", "s_c", "1", "percent", 2, "Share of the lands without film"),
        _q("grid_error", "δ_g", "1", "percent", 2, "Estimated error of the force by the grid"),
        _q("breakaway_pressure", "p_b", "Pa", "MPa", 4, "Breakaway pressure without seepage, upper bound"),
        _q("lying_pressure", "p_l", "Pa", "MPa", 4, "Breakaway pressure with seepage on roughness, lower bound"),
        _q("pocket_pressure", "p_j", "Pa", "MPa", 4, "Pocket pressure after lift"),
        _q("lift", "Δh", "m", "um", 3, "Lift of the shaft"),
        # statics of the shaft
        _q("reaction_1", "R₁", "N", "kN", 5, "Load on the bearing far from the coupling"),
        _q("reaction_2", "R₂", "N", "kN", 5, "Load on the bearing beside the coupling"),
        _q("reaction_without_coupling", "R₀", "N", "kN", 5, "Load on either bearing without the coupling"),
        _q("reaction_angle_1", "θ₁", "rad", "deg", 4, "Direction of R1 from the vertical"),
        _q("reaction_angle_2", "θ₂", "rad", "deg", 4, "Direction of R2 from the vertical"),
        _q("coupling_arm", "a", "m", "mm", 5, "Arm of the coupling weight beyond bearing 2"),
        # thrust bearings
        _q("pad_number", "z", "1", "count", 3, "Number of pads"),
        _q("pivot_film_thickness", "h_p", "m", "um", 3, "Film at the pivot of the pad that carries most"),
        _q("largest_pad_load", "W_max", "N", "kN", 4, "Load of the pad that carries most"),
        _q("smallest_pad_load", "W_least", "N", "kN", 4, "Load of the pad that carries least"),
        _q("pad_load_ratio", "W_max*", "1", "", 3, "Largest over mean pad load"),
        _q("collar_moment", "M_c", "N m", "kNm", 4, "Static moment of uneven pad loads on the collar"),
        _q("collar_moment_amplitude", "M_dyn", "N m", "kNm", 4, "Dynamic moment on the collar, any phases"),
        _q(
            "quasi_static_load_ratio",
            "W_turn*",
            "1",
            "",
            3,
            "Largest over mean pad load while the collar turns slowly",
        ),
        _q("pad_inlet_temperature", "T_in", "K", "degC", 4, "Oil temperature at the leading edges, after mixing"),
        _q("trailing_temperature", "T_tr", "K", "degC", 4, "Oil temperature at the trailing edges"),
        _q("axial_stiffness", "K_ax", "N/m", "GN/m", 4, "Stiffness of all films at rest, tilts free"),
        _q("axial_damping", "C_ax", "N s/m", "MNs/m", 4, "Damping of all films at the frequency of the shaft"),
        _q("ring_stiffness", "c", "N/m", "GN/m", 4, "Stiffness of the backing ring per pad"),
        _q("pad_load", "W_i", "N", "kN", 4, "Static load of each pad"),
        _q("pad_film_thickness", "h_i", "m", "um", 3, "Static film at the pivot of each pad"),
        _q("pad_minimum_film_thickness", "h_min,i", "m", "um", 3, "Thinnest static film of each pad"),
        _q("pad_maximum_pressure", "p_max,i", "Pa", "MPa", 3, "Largest pressure of each pad"),
        _q("passing_flow", "Q_z", "m3/s", "L/min", 3, "Oil through the films of all pads"),
        _q("pad_leading_flow", "Q_l,i", "m3/s", "L/min", 3, "Oil in over the leading edge of each pad"),
        _q("pad_trailing_flow", "Q_t,i", "m3/s", "L/min", 3, "Oil out over the trailing edge of each pad"),
        _q("pad_inner_flow", "Q_i,i", "m3/s", "L/min", 3, "Oil out over the inner edge of each pad"),
        _q("pad_outer_flow", "Q_o,i", "m3/s", "L/min", 3, "Oil out over the outer edge of each pad"),
        _q("pad_friction_power", "P_f,i", "W", "kW", 4, "Friction power under each pad"),
        _q("pad_mixed_temperature", "T_in,i", "K", "degC", 4, "Oil temperature at the leading edge of each pad"),
        _q(
            "pad_trailing_temperature", "T_tr,i", "K", "degC", 4, "Oil temperature at the trailing edges, each pad"
        ),
        _q("pad_maximum_temperature", "T_max,i", "K", "degC", 4, "Highest temperature in the film of each pad"),
        _q("pad_stiffness", "k_i", "N/m", "GN/m", 4, "Stiffness of each film at rest, tilts free"),
        _q("pad_damping", "d_i", "N s/m", "MNs/m", 4, "Damping of each film at the frequency of the shaft"),
        _q("pad_slope_radial", "α_x", "rad", "urad", 4, "Slope of each pad along the radius"),
        _q("pad_slope_along", "α_y", "rad", "urad", 4, "Slope of each pad along the motion"),
        _q(
            "full_stiffness",
            "K_p",
            "N/m",
            "GN/m",
            4,
            "Stiffness of a pad over (height, radial slope, slope along the motion), 3 x 3, SI",
        ),
        _q("full_damping", "C_p", "N s/m", "MNs/m", 4, "Damping of a pad over the same motions, 3 x 3, SI"),
        # shaft lines
        _q("loss_mean_bound", "L_1", "1", "%", 3, "Dynamic over mean static pad load, any phases"),
        _q("loss_mean_peak", "L_1,peak", "1", "%", 3, "Dynamic over mean static pad load, phases as given"),
        _q("loss_mean_worst_turn", "L_1,turn", "1", "%", 3, "The same at the worst angle of propeller to collar"),
        _q("loss_own_bound", "L_2", "1", "%", 3, "Dynamic over own static load of a pad, any phases"),
        _q("loss_own_peak", "L_2,peak", "1", "%", 3, "Dynamic over own static load of a pad, phases as given"),
        _q("unload_margin_bound", "L_3", "1", "%", 3, "Least load left on a pad over the mean, any phases"),
        _q(
            "unload_margin_peak",
            "L_3,peak",
            "1",
            "%",
            3,
            "Least load left on a pad over the mean, phases as given",
        ),
        _q("dynamic_minimum_film", "h_dyn", "m", "um", 3, "Thinnest dynamic film, any phases"),
        _q("dynamic_minimum_film_peak", "h_dyn,peak", "m", "um", 3, "Thinnest dynamic film, phases as given"),
        _q("relative_film_amplitude", "h_rel", "1", "", 3, "Largest dynamic over static film at a pivot"),
        _q("runout_share", "L_runout", "1", "%", 3, "Dynamic load by runout alone"),
        _q("ripple_share", "L_ripple", "1", "%", 3, "Dynamic load by thrust ripple alone"),
        _q("tilt_share", "L_tilt", "1", "%", 3, "Dynamic load with less without tilt and pad heights"),
        _q("elasticity_share", "L_shaft", "1", "%", 3, "Dynamic load with the elastic less with a rigid shaft"),
        _q("natural_frequency_1", "f_1", "rad/s", "Hz", 4, "First axial natural frequency, undamped"),
        _q("natural_frequency_2", "f_2", "rad/s", "Hz", 4, "Second axial natural frequency, undamped"),
        _q("natural_frequency_3", "f_3", "rad/s", "Hz", 4, "Third axial natural frequency, undamped"),
        _q("natural_frequency_4", "f_4", "rad/s", "Hz", 4, "Fourth axial natural frequency, undamped"),
        _q("damping_ratio_1", "D_1", "1", "%", 3, "Damping ratio of the first mode"),
        _q("frequency_separation", "δ_f", "1", "%", 3, "Least distance of an excitation from a natural frequency"),
        _q("admissible_runout", "A_adm", "m", "um", 3, "Largest runout amplitude within the limit of loss"),
        _q("admissible_tilt", "e_adm", "m", "um", 3, "Largest tilt of the housing within the limit of loss"),
        _q("admissible_ripple", "Q_adm", "N", "kN", 4, "Largest thrust ripple within the limit of loss"),
        _q("half_load_ring_stiffness", "c_half", "N/m", "GN/m", 4, "Stiffest ring that halves the dynamic load"),
        _q("best_ring_stiffness", "c_best", "N/m", "GN/m", 4, "Ring with the least dynamic load of the sweep"),
        _q("best_ring_loss", "L_best", "1", "%", 3, "Dynamic load on that ring"),
        _q("nonlinear_load_peak", "N_load", "N", "kN", 4, "Nonlinear motion: largest load above the static one"),
        _q(
            "nonlinear_unload_peak",
            "N_unload",
            "N",
            "kN",
            4,
            "Nonlinear motion: largest load below the static one",
        ),
        _q("nonlinear_minimum_film", "h_nl", "m", "um", 3, "Nonlinear motion: thinnest film"),
        _q("mean_film_shift", "Δh", "m", "um", 3, "Nonlinear motion: largest mean film less the static one"),
        _q("runout_force", "N_R,i", "N", "kN", 4, "Amplitude of each pad force by runout"),
        _q("ripple_force", "N_Q,i", "N", "kN", 4, "Amplitude of each pad force by thrust ripple"),
        _q("dynamic_peak", "N_peak,i", "N", "kN", 4, "Largest dynamic force of each pad, phases as given"),
        _q("dynamic_bound", "N_bound,i", "N", "kN", 4, "Largest dynamic force of each pad, any phases"),
        _q("pad_dynamic_film", "h_dyn,i", "m", "um", 3, "Thinnest dynamic film of each pad, any phases"),
        _q("damped_modes", "D", "1", "", 4, "Frequency (rad/s) and damping ratio of each damped mode"),
        _q(
            "ring_sweep",
            "c_sweep",
            "1",
            "",
            4,
            "Ring: stiffness, runout, ripple, bound, film amplitude, thinnest film, first frequency, static "
            "ratio; SI",
        ),
        _q(
            "campbell",
            "f_n",
            "1",
            "",
            4,
            "Speed (rad/s), loss (bound) and natural frequencies (rad/s) of each point of the sweep",
        ),
        _q("barred_ranges", "n_bar", "1", "", 4, "Barred speeds: from, to (rad/s), order of the excitation"),
    )
}
