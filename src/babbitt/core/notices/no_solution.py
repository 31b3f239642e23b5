"""What is said when there is no solution."""

from __future__ import annotations

from babbitt.core.notices.explanation import Explanation

NO_SOLUTION: dict[str, Explanation] = {
    "S001": Explanation(
        "No film can carry the load",
        "At the coolest possible film, or on the way to the equilibrium temperature, the load asked for more than "
        "the film carries at the largest eccentricity of the characteristics (0.99). A film with its own "
        "temperatures has closed at its thinnest place; the message tells the largest load with a film.",
        "A wider or larger bearing, a more viscous or cooler oil, a smaller clearance, more speed, or less load.",
    ),
    "S002": Explanation(
        "Thermal runaway",
        "The friction heat exceeds what oil and housing carry away at every temperature up to 300 °C. In a film "
        "with its own temperatures: some place, mostly the thinnest, would be hotter than that; the message tells "
        "the largest load with a cooler film.",
        "More oil, a cooler supply, a larger clearance, less load, or a cooling surface.",
    ),
    "S003": Explanation(
        "The clearance closes",
        "The journal expands more than the bearing and grips before the heat balance closes.",
        "A larger cold clearance, or materials with closer thermal expansion.",
    ),
    "S004": Explanation(
        "Not converged",
        "The iteration used up its steps without meeting its tolerance; the last state is no operating point. A "
        "film with its own temperatures mostly ends so near the largest load that it carries; the message tells "
        "the largest load with a film.",
        "Less load, or a position farther from contact; move supplies out of the loaded zone and try another "
        "accuracy; a bore that gives way by far more than the film is thick may be too soft for this load; if the "
        "bearing is an ordinary one, report the case to the developers.",
    ),
    "S005": Explanation(
        "Lubricant data end",
        "The film settles, if at all, at a temperature where a law of the lubricant has no usable value: "
        "viscosity, density or heat capacity would be absent, zero or negative.",
        "Describe the lubricant by points that enclose the operating temperature, with a gentler slope of density "
        "and heat capacity.",
    ),
    "S006": Explanation(
        "Position outside the clearance",
        "At the prescribed position the journal touches or cuts the bore: there is no film. Of a thrust bearing: "
        "at the prescribed mean film a pad touches the collar.",
        "A position nearer to the centre, or a larger clearance; both count at operating temperature. Of a thrust "
        "bearing less tilt, or a thicker film.",
    ),
    "S007": Explanation(
        "The film is squeezed out",
        "Under the changing load the film becomes thinner from cycle to cycle until nothing is left. A load that "
        "rotates at half the speed of the journal builds no wedge and does so always.",
        "Another ratio of the speeds, a steady load besides, more oil, or less load.",
    ),
    "S008": Explanation(
        "The orbit does not close",
        "The journal does not come back to its place after a cycle of the load, however long it runs: it whirls, "
        "or its orbit takes several cycles.",
        "A smaller `moving_mass`, or a bore with preload.",
    ),
    "S009": Explanation(
        "Bound on work reached",
        "The search for the equilibrium was stopped because it had used up the work allowed for its grid (400 "
        "solutions of the finest film), of thrust bearings and shaft lines 120 000 passes of a pad. It tells "
        "nothing about the load: neither that the film carries it nor that it does not.",
        "A coarser `accuracy`, or another direction of load or place of the supplies; of thrust bearings "
        "`thermal: global`, less tilt, fewer waves of the runout, fewer points of a sweep. If the bearing is an "
        "ordinary one, report the case to the developers.",
    ),
    "S020": Explanation(
        "No steady state with a groove that feeds the rim",
        "With cold oil the groove could hold back the pressure at the rim; its own heat thins the oil so far "
        "that it "
        "cannot: at every flow towards the rim, the rim receives more oil than the clearance can carry away. What "
        "the footstep then does, the message tells: oil leaves through the groove.",
        "A shallower groove, more speed, a more viscous oil, less supply pressure, or a larger clearance (the "
        "fold "
        "clearance says from where): in a trial of 17 random footsteps without such a state these gave one in 17, "
        "14, 14, 16 and 13; less speed in none. `method: narrow_groove` has a steady state for every clearance.",
    ),
    "S301": Explanation(
        "Unstable recess network",
        "A valve lets in more oil with rising pressure than the lands let out: the recess pressures run "
        "away, and no state is reported.",
        "Lower the gain of the valve, or limit it by its open ports.",
    ),
    "S302": Explanation(
        "Starved recess",
        "A recess would stand below the pressure at which oil cavitates: the film drags out more oil than "
        "the restrictor lets in. Of a journal bearing: a closed pocket or hole (`flow: 0 L/min`) sends off more "
        "oil than reaches it, even at the pressure at which the film breaks.",
        "A wider restrictor, more supply pressure, less speed or eccentricity; a closed pocket where the film is "
        "full, or one that a pressure feeds.",
    ),
    "S303": Explanation(
        "Lifted off",
        "Even at the widest gap that is searched, far beyond that of a bearing, the recesses press with more than "
        "the load: the supply lifts the moving part off.",
        "More load, as by a second pad that presses against it, less supply pressure, or smaller restrictors.",
    ),
    "S401": Explanation(
        "Pad at its limit",
        "A pad whose pivot stands behind the middle unloads all at once: below a least load its tilt has no "
        "equilibrium. Here one pad would have to carry more than nothing and less than that least load, so the "
        "journal has no static place: it would go to and fro.",
        "More preload of that pad, a pivot nearer to the middle, or another direction of the load.",
    ),
}
