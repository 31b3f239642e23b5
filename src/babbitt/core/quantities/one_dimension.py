"""Films of one dimension."""

from __future__ import annotations

from babbitt.core.quantities.quantity import Quantity, quantity

ONE_DIMENSION: tuple[Quantity, ...] = (
    quantity("supply_angle", "φ₁", "rad", "deg", 4, "Angle of supply from the narrowest gap with the rotation"),
    quantity("rupture_angle", "θ_r", "rad", "deg", 4, "Angle of rupture from the widest gap"),
    quantity("narrow_zone", "Δθ", "rad", "deg", 3, "Angle over which the film is within 1.1 h_min"),
    quantity("load_along_eccentricity", "F_c", "N", "kN", 4, "Load along the line of centres"),
    quantity("load_across_eccentricity", "F_s", "N", "kN", 4, "Load normal to the line of centres"),
    quantity("relative_load", "W_pr", "1", "", 4, "Load along the line of centres over B D times 101 325 Pa"),
    quantity("film_flow", "Q_f", "m3/s", "L/min", 4, "Oil flow around the film"),
    quantity(
        "flow_inconsistency", "δ_Q", "1", "", 3, "Variation of the local flow over its mean in the full film"
    ),
    quantity("rupture_temperature", "T_r", "K", "degC", 4, "Film temperature at rupture"),
    quantity("friction_heat", "P_q", "W", "kW", 4, "Heat generated in the film: friction power less flow work"),
    quantity("heat_to_shaft", "P_sh", "W", "kW", 4, "Heat led away along the shaft"),
    quantity("mean_temperature_load_ratio", "F/F_m", "1", "", 3, "Load over that of one mean temperature"),
    quantity(
        "mean_temperature_relative_load_ratio",
        "W/W_m",
        "1",
        "",
        3,
        "Load along the line of centres over that of one mean temperature",
    ),
    quantity("mean_temperature_outlet", "T_ex,m", "K", "degC", 4, "Outlet temperature by one mean temperature"),
    quantity("film_angle", "θ", "rad", "deg", 4, "Angle from the widest gap in the direction of rotation"),
    quantity("film_direction", "φ", "rad", "deg", 4, "Direction of the same place, counter-clockwise from +x"),
    quantity("film_thickness", "h", "m", "um", 4, "Film thickness over the angle"),
    quantity("film_pressure", "p", "Pa", "MPa", 4, "Film pressure over the angle"),
    quantity("film_temperature", "T", "K", "degC", 4, "Film temperature over the angle"),
    quantity("bush_temperature", "T_B(θ)", "K", "degC", 4, "Temperature of the bush over the angle"),
    *(
        one
        for n, sub, where in ((1, "₁", "before"), (2, "₂", "behind"))
        for one in (
            quantity(f"segment_{n}_flow", f"Q_seg,{n}", "m3/s", "L/min", 4, f"Flow {where} the groove"),
            quantity(f"segment_{n}_power", f"A{sub}", "W", "kW", 4, f"Friction power {where} the groove"),
            quantity(f"segment_{n}_heat", f"q{sub}", "W", "kW", 4, f"Heat given to the oil {where} the groove"),
            quantity(
                f"segment_{n}_inlet_temperature",
                f"T_in{sub}",
                "K",
                "degC",
                4,
                f"Inlet temperature {where} groove",
            ),
            quantity(
                f"segment_{n}_mean_temperature",
                f"T_m{sub}",
                "K",
                "degC",
                4,
                f"Mean temperature {where} groove",
            ),
            quantity(
                f"segment_{n}_outlet_temperature",
                f"T_out{sub}",
                "K",
                "degC",
                4,
                f"Outlet temperature {where} groove",
            ),
            quantity(f"segment_{n}_viscosity", f"η{sub}", "Pa s", "mPas", 4, f"Viscosity {where} the groove"),
            quantity(
                f"segment_{n}_constant", f"C{sub}", "1", "", 4, f"Constant of integration {where} the groove"
            ),
        )
    ),
    quantity("groove_angle_from_load", "θ_gF", "rad", "deg", 4, "Groove from the load line with the rotation"),
    quantity("groove_angle_from_gap", "θ_g", "rad", "deg", 4, "Groove from the widest gap with the rotation"),
    quantity("groove_pressure", "p_g", "Pa", "MPa", 4, "Gauge pressure in the groove"),
    quantity("groove_side_flow", "Q_g", "m3/s", "L/min", 4, "Flow out of the ends of the groove"),
    quantity("groove_warm_flow", "Q_gw", "m3/s", "L/min", 4, "Warm oil that fresh oil replaces in the groove"),
    quantity("groove_heat", "q_g", "W", "kW", 4, "Heat of that oil, part of P_oil, which leaves by the groove"),
    quantity("groove_load_ratio", "F/F_0", "1", "", 3, "Load over that of the ungrooved film at the same gap"),
    quantity("ungrooved_specific_load", "p̄_0", "Pa", "MPa", 3, "Specific load without groove at the same gap"),
    quantity("ungrooved_outlet_temperature", "T_ex,0", "K", "degC", 4, "Outlet without groove at the same gap"),
    quantity("cut_specific_load", "p̄_cut", "Pa", "MPa", 3, "Specific load of the cut film at the same gap"),
    quantity("cut_outlet_temperature", "T_ex,cut", "K", "degC", 4, "Outlet of the cut film at the same gap"),
    quantity(
        "ungrooved_eccentricity_at_load", "ε_0", "1", "", 3, "Eccentricity without groove under the same load"
    ),
    quantity("ungrooved_film_at_load", "h_0", "m", "um", 3, "Least film without groove under the same load"),
    quantity("ungrooved_outlet_at_load", "T_ex,0F", "K", "degC", 4, "Outlet without groove under the same load"),
    quantity("cut_outlet_at_load", "T_ex,cF", "K", "degC", 4, "Outlet of the cut film under the same load"),
)
