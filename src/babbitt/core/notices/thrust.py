"""Warnings about thrust bearings and shaft lines."""

from __future__ import annotations

from babbitt.core.notices.explanation import Effect, Explanation

THRUST: dict[str, Explanation] = {
    "W201": Explanation(
        "Pads share the load very unevenly",
        "The tilt of the housing, or a pad height, with the runout, is as large as the film that an even share "
        "would have, or a pad carries less than 1 % of the mean. Such a pad flutters or runs dry on "
        "another day of another alignment.",
        "Align the housing, adjust the heights of the pads, or give the ring more compliance.",
    ),
    "W202": Explanation(
        "Dynamic film beyond the linear range",
        "The film at a pivot moves by more than a fifth of its static value. Stiffness and damping of the static "
        "film are then off: the error of a peak was measured as 5 % at 0.22 and 9 % at 0.33.",
        "Solve the nonlinear motion (nonlinear: true), or take the bound with a margin.",
    ),
    "W203": Explanation(
        "Excitation near a resonance",
        "An excitation comes within 20 % of a peak of its response or of a lightly damped mode. Frequencies are "
        "known no better than the stiffness of seating and ring and the entrained water.",
        "Bar this speed range, or move the frequency by seating, ring, shaft or number of blades.",
    ),
    "W204": Explanation(
        "Film of the pads is not laminar",
        "The Reynolds number of the film at the mean radius exceeds about 1000. Vortices raise friction and carry "
        "more load than the laminar film.",
        "Choose turbulence: ng_pan or constantinescu.",
        effect=Effect.NO_VERDICT,
    ),
    "W205": Explanation(
        "A pad leaves the collar or touches it",
        "In the nonlinear motion the load of a pad falls to nothing, a film becomes as thin as surfaces are "
        "rough, or tilts leave the films that were tabulated. What follows is not computed reliably.",
        "Reduce runout, tilt or ripple; the tools for admissible amplitudes say how far.",
        effect=Effect.NO_VERDICT,
    ),
    "W206": Explanation(
        "Speed outside the Campbell map",
        "The speed of the case lies outside the speeds for which a map was asked: what the map says of barred "
        "ranges "
        "does not hold there.",
        "Widen speeds, lowest to highest, to hold the speed of the case.",
        effect=Effect.INFORMATION,
    ),
    "W207": Explanation(
        "No film of pads carries this load",
        "The film that would carry the load is thinner than 1 µm: surfaces of a good finish touch there, and the "
        "numbers describe no bearing.",
        "Less thrust, more or larger pads, a more viscous or cooler oil, more speed, or a straighter housing.",
        effect=Effect.NO_VERDICT,
    ),
    "W208": Explanation(
        "Sweeps without a film in places",
        "At some speeds of the map, or on some backing rings, the pads find no film for the thrust: faces that "
        "lean with the housing touch, pads are overloaded, or the oil runs hot; or the work that is allowed for "
        "the line ended before. These points are left out of tables and figures.",
        "Align the housing, or read the sweep only where it has points.",
        effect=Effect.INFORMATION,
    ),
    "W209": Explanation(
        "No film while the runout passes slowly",
        "The film is solved for a collar without runout. With its runout, turned so slowly that nothing swings, "
        "the pads find no film at some position: faces that lean touch the collar or do not come to rest, or the "
        "work that is allowed ends before (the message says which). The "
        "largest pad load over the mean is not given, and no film is counted on for the limit (C202).",
        "Less runout, a ring that gives way, pads on point pivots, or a case of kind thrust_line, which counts "
        "how line and pads move with the runout.",
    ),
    "W210": Explanation(
        "No nonlinear motion that repeats",
        "The nonlinear motion was asked for, and none was found that repeats with the excitations: they have no "
        "common period, or the search did not end, as where pads lose their load. No nonlinear value is given; "
        "the linear answer stands alone.",
        "Reduce runout, tilt or ripple, or give excitations of whole orders; leave nonlinear out to accept the "
        "linear answer.",
    ),
    "W211": Explanation(
        "Oil or heat of the pads is not conserved",
        "What enters the film of a pad and what leaves it differ by more than the bound, or friction and the heat "
        "that the oil carries away do: the film was left before it had settled.",
        "A straighter housing or less load; thermal: global in place of adiabatic.",
        effect=Effect.NO_VERDICT,
    ),
    "W212": Explanation(
        "A pad with negative damping",
        "The film of a pad feeds its vibration at a frequency of the line, its tilts following: small motions "
        "grow by themselves, and no state at rest is to be expected.",
        "Another place of the pivot, lighter pads, or less load on the pads that carry most.",
        effect=Effect.NO_VERDICT,
    ),
    "W213": Explanation(
        "One pad carries nearly all",
        "Tilt of the housing and heights of the pads are so much larger than the film that fewer than two pads' "
        "worth carry the thrust. Such a bearing turns collar or housing until more pads carry, which an axial "
        "model does not follow.",
        "Align the housing, adjust the heights of the pads, or give the backing ring more compliance.",
        effect=Effect.NO_VERDICT,
    ),
    "W214": Explanation(
        "Crown of pads on a central pivot assumed",
        "A plane pad on a pivot in its middle has no balance; real ones carry by the crown that heat and load "
        "give them. Where none is given it is alpha dT B^2/(8 t) of steel, 5 K through the pad and a thickness of "
        "a third of its length: assumptions on which film and load depend much (the example on such pads: 7.5 µm, "
        "with half the difference 5.8 µm, with twice 9.1 µm). Bending under load is left out.",
        "Give crown: as measured or computed for the pads, heat and load included.",
    ),
}
