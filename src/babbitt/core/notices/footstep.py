"""Warnings about footsteps of screw pumps."""

from __future__ import annotations

from babbitt.core.notices.explanation import Effect, Explanation

FOOTSTEP: dict[str, Explanation] = {
    "C131": Explanation(
        "Oil enough for the friction heat",
        "The oil that leaves against what would carry off, at a rise of 100 K and beside the metal, the heat that "
        "the method leaves out of it. With less the state cannot last as computed: metal takes the heat, or "
        "the films are far warmer.",
        "Take `method: narrow_groove` with `wall`, which says where the heat goes.",
    ),
    "W160": Explanation(
        "Steady state not stable",
        "Pressures settle in about 0.1 ms, the heat of the oil in seconds. In this state a small change of "
        "temperature comes back larger through viscosity and flow, and the heel runs away to another state: the "
        "hot "
        "state of a grooved heel to the cold one if it becomes cooler, and to a groove that drains the rim if it "
        "becomes warmer. It satisfies the equations and will not be found running.",
        "Look at the stable states of the same heel; the message names the one to which a warmer groove leads.",
        effect=Effect.NO_VERDICT,
    ),
    "W161": Explanation(
        "Oil of the groove very hot",
        "The oil that leaves the groove, or a film, is hotter than 150 °C. The temperature of the rim, where "
        "streams "
        "are mixed, does not show it.",
        "Read the state as a sign that the adiabatic groove is too simple; compare with `method: narrow_groove` "
        "and a `wall`. The groove is cooler with a wider face gap, a thinner oil, less speed, a smaller clearance "
        "or a deeper groove; a larger clearance makes it hotter.",
    ),
    "W162": Explanation(
        "Lands are no lands",
        "The clearance is a third of the groove depth or more: the lands hardly hinder the oil, and the "
        "formulas that "
        "set grooves against lands lose their sense.",
        "A smaller clearance or deeper grooves.",
        effect=Effect.NO_VERDICT,
    ),
    "W163": Explanation(
        "Ambient pressure looks like a gauge pressure",
        "Less than 50 kPa absolute around the pump is unusual. Supply and ambient pressure must be of one kind.",
        "Give both as absolute pressures, or `pressures: gauge` with the supply pressure above ambient.",
    ),
    "W164": Explanation(
        "Flow in the footstep is not laminar",
        "A Reynolds number of groove, recess or clearance exceeds 1500; all formulas are for laminar films.",
        "Take flows and friction as estimates: turbulence raises friction and lowers the flow at equal pressure.",
        effect=Effect.NO_VERDICT,
    ),
    "W165": Explanation(
        "Grooves do not close around the heel",
        "The number of starts times the sum of groove and land width misses the circumference by more than 3 %, "
        "and "
        "the case accepts it.",
        "Correct the widths (both normal to the groove), the number of starts, or the angle.",
    ),
    "W166": Explanation(
        "The rim feeds the recess",
        "The pressure at the rim exceeds that of the supply: oil of the groove flows back into the recess and the "
        "bore. The footstep no longer draws oil from the delivery side, and what comes back is warm.",
        "Wanted or not, provide for it: a larger clearance or a shallower groove lowers the pressure at the rim.",
        effect=Effect.INFORMATION,
    ),
    "W167": Explanation(
        "Negative axial stiffness",
        "The load rises as the face gap opens: the gap lies upstream of the clearance, and where oil flows "
        "outwards "
        "through it, opening it lets more pressure reach the rim. The heel finds no place of its own under a "
        "constant "
        "load; it runs away from it or onto its stop.",
        "The load must fall faster with the face gap than the footstep's own, or a stop must hold the heel; "
        "damping of "
        "the face gap only delays it.",
    ),
    "W168": Explanation(
        "Equations of the study",
        "Groove and clearance are taken as two separate flows, the groove gives no heat to the metal, and the "
        "shear of "
        "the lands heats no oil. The study printed load gains of 10 and 25 % that are no property of these "
        "equations: "
        "`babbitt validate screw_heel_claims` shows each claim beside what they give.",
        "Compare with `method: narrow_groove`, which sees the clearance as one film and the conduction of the "
        "metal.",
    ),
    "W169": Explanation(
        "Few grooves",
        "Narrow-groove theory counts on many grooves. With 20 or more it meets the film in two dimensions "
        "within 1 % in "
        "flow and pressure; at 5 starts the clearance lets through about 3 % more (`babbitt validate "
        "film_groove_pitch`).",
        "Take the leakage as a few per cent too small; more starts pump more evenly.",
        effect=Effect.INFORMATION,
    ),
    "W170": Explanation(
        "Eccentric grooved heel",
        "Leakage and friction of an eccentric or tilted grooved heel count the local clearance only; side forces "
        "are computed for the smooth heel alone.",
        "Read side forces from the smooth heel as an order of magnitude.",
    ),
    "W171": Explanation(
        "Friction heat outside the balance",
        "The study's equations warm the oil by the loss of pressure in the face gap and, grooved, by what the "
        "groove itself dissipates; the shear of heel and lands, most of the friction power, warms nothing. "
        "Narrow-groove theory without `wall` keeps its films as cold as the oil that comes in. Both heels are "
        "computed too cold.",
        "Take `method: narrow_groove` with `wall`, where the heat of the films goes into metal and oil. "
        "Otherwise read the friction power as an upper bound and the leakage as a lower one.",
    ),
    "W176": Explanation(
        "Oil of the footstep warmed beyond the model",
        "Oil that is warmed by more than 100 K (an assumption), or would be by the friction heat that the method "
        "leaves out of it, is outside what these equations are made for: one exponent of viscosity, constant heat "
        "capacity, metal that takes nothing or has one temperature.",
        "Take `method: narrow_groove` with `wall`, or wider gaps, a thinner oil, less speed.",
        effect=Effect.NO_VERDICT,
    ),
    "W177": Explanation(
        "Mass balance at the rim open",
        "What enters the rim of the heel and what leaves it differ by more than a millionth. Where the face gap "
        "is thousands of times the clearance, rim and recess have one pressure but for round-off, and the flow "
        "between them is lost in it.",
        "Check face gap and clearance; where they are of one order, report the case to the developers.",
        effect=Effect.NO_VERDICT,
    ),
    "W178": Explanation(
        "Groove drains the rim",
        "The groove cannot hold back the pressure at the rim even with cold oil: oil leaves through it to "
        "ambient, "
        "and the heel carries less than a smooth one.",
        "A shallower groove, more speed, a more viscous oil, less supply pressure, or a larger clearance.",
    ),
}
