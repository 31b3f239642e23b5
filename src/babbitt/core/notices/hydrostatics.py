"""Warnings about hydrostatic bearings and jacking."""

from __future__ import annotations

from babbitt.core.notices.explanation import Effect, Explanation

HYDROSTATICS: dict[str, Explanation] = {
    "W301": Explanation(
        "Oil flows back through a restrictor",
        "The film raises a recess above the supply pressure and pushes oil back into the manifold; the "
        "bearing loses load.",
        "Put a check valve before each recess (`check_valve: true`), or raise the supply pressure.",
        effect=Effect.INFORMATION,
    ),
    "W302": Explanation(
        "Pressure ratio far from its best",
        "Recess over supply pressure at the design point lies outside 0.3 to 0.8; stiffness falls off on "
        "either side.",
        "Change the restrictor: `stiffest_pressure_ratio` in the results says what to aim at.",
        effect=Effect.INFORMATION,
    ),
    "W303": Explanation(
        "Capillary outside its law",
        "The flow in the capillary is not laminar, or the tube is so short that its entry counts.",
        "A longer or narrower tube, several tubes, or give `entry_loss`.",
    ),
    "W304": Explanation(
        "Small orifice",
        "Orifices below 0.3 mm clog.",
        "A larger orifice and a finer filter, or a capillary.",
        effect=Effect.INFORMATION,
    ),
    "W305": Explanation(
        "Film not laminar",
        "The Reynolds number of the film exceeds 1000; the laminar film equation ends there.",
        "Turbulence makes the oil stiffer against shear and flow: the friction is a lower bound, the flow through "
        "the gap told an upper bound, so that the oil may become hotter than told. A more viscous oil, a smaller "
        "gap or less speed.",
        effect=Effect.NO_VERDICT,
    ),
    "W306": Explanation(
        "Recess not laminar",
        "The Reynolds number in the recess exceeds 1000; its laminar friction factor is then too low.",
        "Treat the friction power as a lower bound; a shallower recess helps.",
    ),
    "W307": Explanation(
        "Shallow recess",
        "The recess is less than ten gaps deep; its pressure is not uniform.",
        "A deeper recess.",
    ),
    "W308": Explanation(
        "Inertia at the recess edge",
        "The dynamic pressure of the moving surface is no longer small against the recess pressure; oil "
        "entering the land loses pressure that is not counted.",
        "Treat the load at speed as an upper bound.",
    ),
    "W309": Explanation(
        "Compressible oil costs damping",
        "Oil in recess and line gives way and takes away more than a fifth of the damping.",
        "Shallower recesses, restrictors close to the recess, oil without air.",
        effect=Effect.INFORMATION,
    ),
    "W310": Explanation(
        "Pneumatic-hammer-like",
        "Compressible oil takes away more damping than the film has: a heavy enough mass on the bearing "
        "vibrates by itself.",
        "Shallower recesses, restrictors close to the recess, oil without air, more land.",
        effect=Effect.NO_VERDICT,
    ),
    "W311": Explanation(
        "Friction against pumping power",
        "The sum of both powers is far from its least, which lies at a ratio of 1 (viscosity free) to 3 "
        "(gap free).",
        "`least_power_gap` in the results says what gap to aim at with restrictors made to suit.",
        effect=Effect.INFORMATION,
    ),
    "W312": Explanation(
        "Warm oil",
        "The oil warms by more than 20 K between manifold and drain; one viscosity for the whole film is a "
        "rough guess.",
        "More flow, a thinner oil, less supply pressure or speed.",
    ),
    "W313": Explanation(
        "Pump too weak",
        "The supply pressure exceeds what the pump can hold, or, with `constant_flow` or `metered_flow`, a recess "
        "the pressure of the supply, which its pump is to reach: the recess then gets less oil than "
        "the calculation gives it.",
        "Another pump, or wider restrictors; with given flows more recess area or less load.",
    ),
    "W314": Explanation(
        "Breakaway above the relief valve",
        "Before the shaft lifts, oil reaches the pocket only; lifting may need up to the load over the "
        "projected pocket area.",
        "A higher relief setting or a larger pocket.",
    ),
    "W315": Explanation(
        "Dry film at a recess",
        "The film is ruptured right beside a recess; frozen rupture makes the coefficients less certain there.",
        "Compare with a finer accuracy.",
    ),
    "W316": Explanation(
        "Too few recesses",
        "Fewer than three recesses give no stiffness in some direction.",
        "Three or more recesses, four or more for a spindle.",
    ),
    "W317": Explanation(
        "Unequal lands by strips",
        "Closed forms are for lands of equal width; strips without corners were used.",
        "Choose `method: film`.",
    ),
    "W318": Explanation(
        "Short recess",
        "Closed forms of the rectangle are off by up to 0.5 % where the recess is shorter than two land widths.",
        "Choose `method: film`.",
        effect=Effect.INFORMATION,
    ),
    "W319": Explanation(
        "Lumped lands",
        "The quick method lumps the lands: stiffness of a four-recess journal bearing is some 3 % low, flow "
        "5 % high, damping too low. Of a thrust ring it promises too much: of the rotary table of "
        "`babbitt new` some 12 % more load and film thickness, 15 % more flow, 16 % less damping than the film.",
        "Choose `method: film`.",
    ),
    "W320": Explanation(
        "Pockets feed each other",
        "Several pockets on one pump without restrictors: the first that lifts takes the oil of the others.",
        "A flow divider, or a restrictor for every pocket.",
    ),
    "W321": Explanation(
        "Rough closed form",
        "Jacking pockets by strips: pressure and flow are estimates, good to a factor of two at small gaps.",
        "Choose `method: film`.",
    ),
    "W322": Explanation(
        "Oil warmed beyond the model",
        "Between manifold and drain the oil would be warmed by more than 100 K (an assumption): one viscosity for "
        "the whole film and no heat to the metal are then no model of the bearing. Where viscosity or temperature "
        "of the film is given, by more than 40 K: the film would have about half the viscosity that it is given.",
        "Give the oil by its supply temperature, so that the heat balance finds that of the film; more flow (a "
        "wider gap, wider restrictors), a thinner oil, less speed or supply pressure.",
        effect=Effect.NO_VERDICT,
    ),
    "W323": Explanation(
        "Negative damping",
        "At a frequency of the case oil that gives way in recess and line, or turning with the journal, feeds a "
        "motion instead of damping it.",
        "Shallower recesses, restrictors close to the recess, oil without air, more land.",
        effect=Effect.NO_VERDICT,
    ),
    "W324": Explanation(
        "Mass balance open",
        "What the restrictors let in and what the film lets out differ by more than a millionth.",
        "Choose another accuracy; report the case to the developers.",
        effect=Effect.NO_VERDICT,
    ),
    "W325": Explanation(
        "Heat balance open",
        "The heat of the film and what the oil carries off at its temperature differ by more than a thousandth.",
        "More flow or less friction; report the case to the developers.",
        effect=Effect.NO_VERDICT,
    ),
    "W328": Explanation(
        "Lifted shaft rolls aside",
        "Pockets on one pressure: where the shaft comes near one of them, the pressure of the film grows on the "
        "other "
        "side of it, and the shaft rolls farther. The place at the bottom of the bore will not be found.",
        "A restrictor or a stage of a flow divider for every pocket.",
        effect=Effect.NO_VERDICT,
    ),
    "W326": Explanation(
        "Film outside the data of its oil",
        "The film, or the oil before the restrictors, is warmer or colder than the temperatures for which the "
        "numbers of the lubricant are meant.",
        "Describe the lubricant by points that enclose the temperatures of operation, or bring the oil nearer to "
        "them.",
        effect=Effect.NO_VERDICT,
    ),
}
