"""What the checks of a design compare."""

from __future__ import annotations

from babbitt.core.notices.explanation import Explanation, Subject

CHECKS: dict[str, Explanation] = {
    "C101": Explanation(
        "Film thickness by experience",
        "The minimum film thickness is compared with a value by experience for diameter and surface speed. Found "
        "from the load by a film of one dimension it is too thick: it can miss the limit, but not keep it.",
        "A more viscous or cooler oil, a larger bearing, less load.",
        subject=Subject.FILM_THICKNESS,
    ),
    "C102": Explanation(
        "Film thickness by surface geometry",
        "The minimum film thickness is compared with the sum of roughness, half the tilt offset, half the "
        "deflection, and effective waviness.",
        "Finer or truer surfaces, better alignment, or a thicker film.",
        subject=Subject.FILM_THICKNESS,
    ),
    "C103": Explanation(
        "Specific load",
        "The specific load is compared with the value by experience of the family of the bearing metal, or with "
        "the limit that the case sets.",
        "A larger bearing or a stronger metal.",
        subject=Subject.SPECIFIC_LOAD,
    ),
    "C104": Explanation(
        "Temperature",
        "The oil outlet temperature (pressure fed) or the bearing temperature (self-cooled) is compared with the "
        "value by experience or with the limit that the case sets; that of the case holds for the hottest known. "
        "A prescribed effective temperature can miss the limit, not keep it: no heat balance tells the hottest.",
        "More oil, a cooler supply, a larger clearance, or a thinner oil.",
        subject=Subject.TEMPERATURE,
    ),
    "C105": Explanation(
        "Specific load of the metal",
        "The specific load is compared with the limit of the bearing metal for the character of the load. Of "
        "thrust pads it is the mean pressure of the one that carries most, a recommendation for B83 if no "
        "metal is given.",
        "A larger bearing or a stronger metal.",
        subject=Subject.SPECIFIC_LOAD,
    ),
    "C106": Explanation(
        "Surface speed of the metal",
        "The surface speed is compared with the limit of the bearing metal.",
        "A smaller journal, a lower speed, or another metal.",
    ),
    "C107": Explanation(
        "Load times speed of the metal",
        "The product of specific load and surface speed is compared with the limit of the bearing metal.",
        "A wider bearing, a lower speed, or another metal.",
    ),
    "C108": Explanation(
        "Limiting temperature of the metal",
        "The hottest known temperature of bush, wall or film is compared with the limit of the metal, else with "
        "that of its family, else with the limit of the case (C104), else with the general one of bearing "
        "temperatures (an assumption). Of thrust pads it is that of the oil, of metal B83 if none is given.",
        "More or cooler oil, or another metal.",
        subject=Subject.TEMPERATURE,
    ),
    "C109": Explanation(
        "Recommended temperature of the metal",
        "A recommendation: the temperature recommended for lasting operation of the metal.",
        "More or cooler oil; a thermal film calculation tells the temperature of the metal itself.",
    ),
    "C110": Explanation(
        "Laminar film",
        "The Reynolds number of the film is compared with 41.3 sqrt(D/C), the end of validity of the procedure.",
        "Use `method: film` with `turbulence: ng_pan` or `constantinescu`.",
    ),
    "C111": Explanation(
        "Transition to mixed friction",
        "The speed is compared with the speed below which the surfaces touch.",
        "Smoother surfaces, a more viscous oil, less load, or jacking oil for starting.",
    ),
    "C112": Explanation(
        "Whirl screening by Orlov",
        "A screening indicator of the ISO 7902 result, no stability calculation: the relative clearance should "
        "exceed 3.5e-3 sqrt(lambda B/D), else the journal can whirl by itself. It changes no verdict.",
        "Solve the bearing with `method: film`, whose stiffness and damping decide (C115), and see C115 for "
        "what helps.",
    ),
    "C115": Explanation(
        "Critical mass",
        "The mass above which a rigid rotor whirls, and with `shaft_stiffness` that of a rotor on an elastic "
        "shaft, is compared with the mass of the rotor (`rotor_mass`), or, as a recommendation, with the load "
        "over g. Few films bear heavy rotors alone: then the least stable mass is compared.",
        "A bore with preload, tilting pads, or a narrower bearing; at light load also a smaller clearance (mind "
        "the heat). A larger clearance or a thinner oil helps only where it brings the relative eccentricity "
        "above about 0.7 to 0.8: try it with a sweep.",
    ),
    "C116": Explanation(
        "Pressure of plain bearings",
        "Where no bearing metal is given to compare the load with, the largest film pressure is compared with "
        "100 MPa, about the yield strength of a white metal of Brinell hardness 30, the hardest on board.",
        "Give the metal (`materials: {bearing_metal: ...}`), which has limits of its own; a larger bearing.",
    ),
    "C117": Explanation(
        "Supply capacity",
        "What the supply can deliver is compared with the side flow Q3: Q_p + (U/2) h b with width and gap at the "
        "downstream edge of hole, pocket or half groove before the load, for a pocket less the film that comes "
        "back to it; Q_p alone for a groove all around; no more than tubes and holes pass. Where it is less, the "
        "heat balance is repeated with it and decides; the miss itself counts only if that has no equilibrium.",
        "Wider pockets or grooves, wider tubes, more supply pressure, or a full analysis with `method: film`.",
    ),
    "C122": Explanation(
        "Stiffness and damping against the slope of the load",
        "Central differences of the film's own load are compared with stiffness and damping, where the film has "
        "nodes of its own (holes, pockets, pressurised grooves, tilt, temperatures).",
        "A margin on threshold speed and critical mass.",
    ),
    "C114": Explanation(
        "Recommended clearance",
        "A recommendation: the mean relative clearance should reach 0.8e-3 U^(1/4), with U in m/s.",
        "Choose a larger clearance where heat matters; against whirl it can make things worse (C115).",
    ),
    "C130": Explanation(
        "Stability of the steady state",
        "Thermal loop gain of the footstep: which share of a small lasting change of temperature comes back "
        "through "
        "viscosity and flow, pressures being in balance at every instant. Below 1 the change dies out; at 1 or "
        "more "
        "it runs away. Disturbances that swing are counted beside it (W160).",
        "Design for the stable state; see the plot of the steady states over the clearance.",
    ),
    "C201": Explanation(
        "Loss of load capacity by shaking",
        "Largest dynamic force of a pad over the mean static load of a pad, for any phase between propeller and "
        "collar; the usual limit is 50 %.",
        "Reduce the cause that dominates; a backing ring of the stiffness shown halves the dynamic load.",
    ),
    "C202": Explanation(
        "Thinnest film of the pads",
        "Thinnest film over the edges and the face of a pad: static, and in a shaft line with all harmonics for "
        "any phase.",
        "Less load or runout, a more viscous or cooler oil, a better alignment, a compliant ring.",
        subject=Subject.FILM_THICKNESS,
    ),
    "C203": Explanation(
        "Load left on the pad that is unloaded most",
        "Least of static plus dynamic load over the mean pad load; at 0 a pad leaves the collar.",
        "Reduce tilt first, which unloads the pads on one side, then runout.",
    ),
    "C204": Explanation(
        "Distance of the excitations from resonance",
        "Least relative distance of an excitation from a peak of its own response, where pad forces exceed twice "
        "their static value, or from a damped mode with a damping ratio below 25 %, films and tilts at that "
        "frequency; 20 % are advised. Undamped frequencies on films at rest are information.",
        "Bar the speed range, or move the frequency by seating, ring, shaft or number of blades.",
    ),
    "C205": Explanation(
        "Axial vibration of the shaft",
        "Largest amplitude of axial vibration along the shaft, half of peak to peak, for any phases of the "
        "excitations, against the admissible one of the case; what sea trials measure.",
        "Keep away from resonance; less ripple, a stiffer seating or ring, damping at the propeller.",
    ),
    "C401": Explanation(
        "Log decrement of the rotor among its pads",
        "The log decrement of the rotor's motion that lasts longest, forward or backward, against 0.1, the "
        "criterion of API 617 that API RP 684 explains, or the limit of the case; of any motion of rotor or "
        "pads that grows. Pads keep their own motions: synchronous coefficients do not tell whether a motion "
        "grows. One that grows without swinging counts as -100.",
        "Less preload or a larger assembled clearance, load between pads, a softer support with damping, or "
        "pads of less inertia.",
    ),
    "C402": Explanation(
        "Preload left on every pad",
        "A recommendation: the eccentricity ratio at the pivot of every pad less that at which the pad unloads. "
        "Below zero a pad carries nothing and may flutter.",
        "More preload of the pads that face away from the load, pivots nearer to the middle, or fewer pads.",
    ),
    "C301": Explanation(
        "Least gap",
        "The smallest gap against the least that the case allows, or that jacking is to reach.",
        "More supply pressure, more recess area, or a stiffer restrictor; more flow of a jacking pump.",
        subject=Subject.FILM_THICKNESS,
    ),
    "C302": Explanation(
        "Load against its limit",
        "The load against the one whose equilibrium, in the same direction and with the same moments, has "
        "the least gap allowed.",
        "More supply pressure or recess area.",
    ),
    "C303": Explanation(
        "Supply pressure",
        "The supply pressure against what the pump can hold.",
        "Another pump or wider restrictors.",
    ),
    "C304": Explanation(
        "Jacking pressure",
        "Breakaway and lifting pressure against the relief valve of the pump.",
        "A higher relief setting or a larger pocket.",
    ),
}
