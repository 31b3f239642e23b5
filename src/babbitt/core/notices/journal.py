"""Warnings about journal bearings."""

from __future__ import annotations

from babbitt.core.notices.explanation import Effect, Explanation

JOURNAL: dict[str, Explanation] = {
    "W101": Explanation(
        "Film is not laminar",
        "The Reynolds number of the film exceeds 41.3 sqrt(D/C), up to which the ISO 7902 procedure is valid. "
        "Vortices raise friction and temperature above the values shown.",
        "Use `method: film` with `turbulence: ng_pan` or `constantinescu`, a smaller clearance, a more "
        "viscous oil or a lower speed.",
        effect=Effect.NO_VERDICT,
    ),
    "W102": Explanation(
        "Width ratio outside the standard",
        "ISO 7902 tabulates B/D from 0.125 to 1. The characteristics used here are computed, not extrapolated, "
        "and the formulas for supply flow and limits have no experience there.",
        "Read the result with care, or compare it with a film method.",
    ),
    "W103": Explanation(
        "Supply element outside the range of its flow formula",
        "The corrections q_H and q_P of holes and pockets hold for a width of 0.05 to 0.7 of that of the "
        "bearing; outside, that of the nearest bound is used. The logarithm takes the true width up to 0.9. "
        "Grooves wider than 0.7 leave narrow lands, and pass much oil by a formula that nothing confirms there.",
        "Take the supply flow as an estimate; a film method gives the flow of the real pocket.",
    ),
    "W196": Explanation(
        "Correction of the supply flow held at its bound",
        "The corrections q_H and q_P of holes and pockets hold up to 0.7 of the width of the bearing. From "
        "there to 0.9 a published gearbox study keeps that of 0.7, and the true width in the logarithm.",
        "`method: film` gives the flow of the real pocket.",
        effect=Effect.INFORMATION,
    ),
    "W104": Explanation(
        "Uneven pockets replaced by a centred arc",
        "The standard knows only arcs centred on the load. The arc between uneven pockets is replaced by a "
        "conventional span rounded to a tabulated one.",
        "Compare with a film method, which sees the pockets where they are.",
    ),
    "W105": Explanation(
        "Loaded arc shorter than any tabulated span",
        "The pockets leave less than 90 degrees of centred arc; the characteristics of 90 degrees flatter it, "
        "those of a wider span all the more.",
        "Move the pockets away from the load or use a film method.",
        effect=Effect.NO_VERDICT,
    ),
    "W107": Explanation(
        "Temperature outside the lubricant data",
        "The effective temperature lies outside the range for which the lubricant's numbers are meant.",
        "Give the lubricant by points that enclose the operating temperature.",
    ),
    "W109": Explanation(
        "Fast bearing",
        "Above 20 m/s the dynamics of shaft and film deserve a check of their own.",
        "Make a rotordynamic check with stiffness and damping of the film.",
        effect=Effect.INFORMATION,
    ),
    "W110": Explanation(
        "Pressure feed needed",
        "Cooled by its surroundings alone the bearing becomes hotter than permissible.",
        "Feed oil under pressure, enlarge the cooling surface, or move more air.",
        effect=Effect.INFORMATION,
    ),
    "W111": Explanation(
        "Supply pressure used up",
        "At the whole supply pressure tubes and holes pass less oil than the film wants: nothing is left to push "
        "oil through the supply element, and the film gets what they pass. ISO 7902 repeats its heat balance with "
        "that flow; the film of one temperature is solved as starved.",
        "Larger tubes and holes, or a higher supply pressure.",
    ),
    "W112": Explanation(
        "No transition speed",
        "The film thickness at which mixed friction begins is larger than the radial clearance, or smaller than "
        "the tables reach; the transition speed is absent or an upper bound.",
        "Check roughness, tilt and waviness against the clearance.",
        effect=Effect.INFORMATION,
    ),
    "W113": Explanation(
        "Closed-form characteristics",
        "The closed forms of DIN 31652 deviate from the solution of the Reynolds equation by up to 11 % in load "
        "(7 % at the widths they were fitted to), 4 % in side flow and 2.5 degrees in attitude angle (up to 13 "
        "below an eccentricity ratio of 0.1), and exist for a full bearing only.",
        "Use `characteristics: computed` (the default) unless an old calculation is to be repeated.",
    ),
    "W114": Explanation(
        "Rotating bearing",
        "Film forces follow the sum of both speeds, shear and friction heat their difference; permissible film "
        "thickness, recommended clearance and supply are known by experience of bearings at rest.",
        "Take limits from experience as estimates.",
    ),
    "W115": Explanation(
        "Outside the experience tables",
        "No experience value of the permissible film thickness exists for this diameter.",
        "Give `surfaces` or `limits: {minimum_film_thickness: ...}`.",
        effect=Effect.INFORMATION,
    ),
    "W116": Explanation(
        "Film thinner than rigid films go",
        "Above an eccentricity of 0.95, or where the film is thinner than 0.05 of the clearance, elastic "
        "deformation, roughness and heat decide the film; a rigid isoviscous film is too simple.",
        "Treat the film thickness as an order of magnitude; lower the load or raise the viscosity.",
    ),
    "W118": Explanation(
        "Oil leaves colder than it enters",
        "The housing takes more heat than friction makes, so that the oil is cooled on its way through the film. "
        "The rule of the mean temperature was made for oil that is heated.",
        "Check ambient temperature, cooling surface and heat transfer coefficient; leave `cooling` out if the oil "
        "carries the heat.",
    ),
    "W119": Explanation(
        "Film hardly loaded",
        "Below an eccentricity of 0.01 the characteristics follow their limit of small eccentricity.",
        "Check load and units; a bearing without load tends to whirl.",
    ),
    "W123": Explanation(
        "Supply delivers less than the film wants",
        "What the supply can deliver, Q_p and the oil that the journal shears away over the width of the supply "
        "element (none out of a groove all around), at most what tubes and holes pass, "
        "is less than the side flow with which ISO 7902 closes its heat balance. That is repeated with the lesser "
        "flow; its temperatures and films, named starved, are held against the limits. The estimate of what is "
        "delivered is an assumption, within a factor of about two of films that conserve their oil. Of holes, "
        "slots and pockets that deliver half or more, W190 says the same and questions nothing.",
        "Wider pockets or grooves, wider tubes and holes, or a higher supply pressure; `method: film` with "
        "`thermal: adiabatic` tells more.",
    ),
    "W189": Explanation(
        "Loaded arc shorter than the span",
        "A pocket or groove ends the film: between pockets at 90 deg to the load 180 deg less their extent carry, "
        "and a pocket or groove beside the load line leaves an arc of twice its distance (behind the load up to "
        "60 deg). The span is wider, and by the characteristics of the arc that is left the film is more than 5 % "
        "thinner (an assumption), or no characteristics are so short.",
        "The `span` that fits between the pockets, `uneven_pockets` with their true angles, or `method: film`; "
        "shorter pockets, or a load that points away from them.",
    ),
    "W191": Explanation(
        "Limit kept by less than one temperature can tell",
        "ISO 7902 knows one temperature of the film and that at its outlet. A film with temperatures of its own "
        "may miss a limit where the film thickness keeps it by less than 45 %, the Reynolds number by less than a "
        "factor of 2.1, or where the outlet and 15 K, or the inlet and 6.2 K times the root of specific load "
        "times speed in MPa m/s, pass that of the metal: 19 of 20 random bearings stay within that, each.",
        "`method: film` with `thermal: adiabatic` or `full`; more margin by less load, more or cooler oil.",
    ),
    "W192": Explanation(
        "Supply pressure rivals the film",
        "ISO 7902 presupposes a feed pressure that is negligible beside the pressures of the film. Above half the "
        "specific load, or where a pocket or half groove presses on the journal with more than a tenth of the "
        "load (assumptions: films with a pocket opposite the load are there 5 % thinner), it carries or loads the "
        "journal, and what the pump puts into the oil of Q_p, p over rho c in kelvin, is not in the heat balance.",
        "Check the pressure and its unit (20 bar are 2 MPa); `method: film` counts the pressure, and `kind: "
        "hydrostatic` a bearing that lives on it.",
    ),
    "W194": Explanation(
        "Whirl not judged",
        "The case gives the mass of the rotor, so that whirl matters, and the screening by Orlov (C112) is missed "
        "or kept by less than a tenth. ISO 7902 has neither stiffness nor damping and cannot tell whether this "
        "rotor whirls. Without a mass the screening is information alone: of 24 random bearings below an "
        "eccentricity ratio of 0.1 it was missed by all, and 20 of them carry their load as a weight without "
        "whirl.",
        "`method: film`, which compares the mass with the critical one (C115).",
    ),
    "W193": Explanation(
        "Clearance of no plain bearing",
        "Clearance over diameter lies outside 0.1 to 10 per mille: no experience and no limit of plain bearings "
        "reaches there (an assumption). Often a percentage or the wrong unit was typed.",
        "Check `clearance` and its unit: '1.1 permille' is 0.11 %.",
        effect=Effect.NO_VERDICT,
    ),
    "W190": Explanation(
        "Supply delivers somewhat less than the film wants",
        "As W123, with holes, slots or pockets that deliver at least half of the side flow. Their oil enters at "
        "the edge before the load, where warm oil that the film brings back fills part of the gap of pockets. The "
        "limits are held against the film with the lesser flow, which errs to the hot side: they are kept without "
        "a remark.",
        "Wider or shorter elements, or a higher supply pressure, for a cooler film.",
        effect=Effect.INFORMATION,
    ),
    "W195": Explanation(
        "Supply elements closer to the load than 90 deg",
        "The flow by pressure of elements at both sides, Q_p, holds at 90 deg to the load. Where an arc below 180 "
        "deg ends, or uneven pockets stand, the gap is thinner, and the film's pressure stands against the "
        "supply: the heat balance is repeated with the mean cube of the gaps there (an assumption), and the "
        "limits are held against the worse of both.",
        "`method: film`, which has the elements at the ends of the arc; a wider arc.",
        effect=Effect.INFORMATION,
    ),
    "W124": Explanation(
        "No supply flow",
        "Oil is supplied, yet no pressure presses any through the supply element, or none is given: only the "
        "journal draws oil to the film.",
        "The pressure of the supply and its `supply_element`, or compare with `method: film`.",
    ),
    "W186": Explanation(
        "Film not limited to its supply",
        "At the whole supply pressure tubes and holes pass less oil than the film draws. Only a film of one "
        "temperature that conserves its oil and carries a constant load is solved with the lesser flow; this one "
        "is cooled by oil that does not reach it.",
        "Larger tubes and holes, more supply pressure, or `thermal: global` with `cavitation: mass_conserving`.",
        effect=Effect.NO_VERDICT,
    ),
    "W187": Explanation(
        "Loss in the supply hole not counted",
        "The oil is so fast in a hole of the bearing that entrance and exit cost more than a tenth of the supply "
        "pressure. Only losses in `supply.tubes` and `supply.holes` are counted.",
        "Give the hole under `supply.holes`, too; a larger hole.",
    ),
    "W188": Explanation(
        "Span wider than a half groove leaves",
        "A groove around the unloaded half ends the film: the loaded arc is 180 deg. Characteristics of a wider "
        "arc flatter the bearing.",
        "`span: 180 deg`.",
    ),
    "W185": Explanation(
        "Nothing tells that oil reaches the film",
        "No supply element is given, or the supply delivers nothing: a groove all around without pressure, tubes "
        "or holes without pressure; or elements closer to the load than 90 deg give so little that the heat "
        "balance has no answer. The heat balance takes the film to draw its side flow all the same. Without "
        "oil no film and no temperature of it is known.",
        "Give the `supply_element` and the pressure of the supply; or `method: film`.",
        effect=Effect.NO_VERDICT,
    ),
    "W121": Explanation(
        "Flow of open grooves",
        "A groove as wide as the bearing ends somewhere, and how its ends are closed decides what leaks there. "
        "The film lets its pressure fall to that of the sides over the last 2.5 % of the width at either end and "
        "counts the flow over the lands beside them; what runs straight out of the ends is not counted. Supply "
        "flow and, through the heat balance, temperature and film thickness inherit this; a finer `accuracy` does "
        "not cure it.",
        "Describe grooves that end before the side as pockets with their true width.",
    ),
    "W122": Explanation(
        "The film reforms without oil",
        "The Reynolds condition lets the film begin again behind the ruptured zone without asking where the oil "
        "comes from. Flows, and with them the heat balance, count oil that no supply delivers.",
        "Use `cavitation: mass_conserving` (the default) where flows and temperatures matter.",
    ),
    "W140": Explanation(
        "Starved supply",
        "The film would draw more oil than a groove, pocket or hole is given. It fills only part of the gap "
        "behind it: the film begins later, is thinner, and is less stiff than a flooded one.",
        "More oil, or supplies where the film draws less; a wider bearing passes less oil for its load.",
        effect=Effect.INFORMATION,
    ),
    "W141": Explanation(
        "Oil drawn in at the sides",
        "Where the film is ruptured, or a side stands under pressure, the sides draw oil in. The film counts on "
        "it: its sides lie in oil, which enters as warm as that of the supply. A side in air would draw air.",
        "A `cavitation_pressure` of 0 bar for sides in air; otherwise a supply that keeps the sides flooded.",
    ),
    "W145": Explanation(
        "Film outside the lubricant data",
        "Somewhere in the film the temperature lies outside the range for which the lubricant's numbers are "
        "meant; its viscosity there is extrapolated.",
        "Give the lubricant by points that enclose the coldest and the hottest place of the film.",
    ),
    "W146": Explanation(
        "Heat balance of the film left open",
        "Dissipation, heat carried by the oil, and heat taken by bush and journal do not add up to round-off: the "
        "heat balance was left before it had settled, by less than a thousandth (W325 from there on).",
        "Try another `accuracy`; temperatures are right to about this share of their rise.",
    ),
    "W147": Explanation(
        "Stiffness with frozen temperatures only",
        "The stiffness was asked for with temperatures that follow the motion. The film beside the operating "
        "point did not settle.",
        "Use `temperature_coefficients: frozen`, or move supplies out of the loaded zone.",
    ),
    "W148": Explanation(
        "Warm oil flows back into a supply",
        "A groove or pocket lies where the film has more pressure than the supply: the film presses warm oil back "
        "into it. Or `carry_over` says that fresh oil flushes warm oil out of the grooves, more than leaves over "
        "their ends. The heat of all that oil (`heat_returned`) leaves through the supplies. `outlet_temperature` "
        "is that of the oil at the sides; `groove_returned_flows` and `groove_temperatures` tell of every supply.",
        "Move the groove or pocket out of the loaded zone, or count on warmer supply oil; with `carry_over`, let "
        "the supply line take that oil away.",
    ),
    "W149": Explanation(
        "Film prescribed colder than its oil",
        "The effective temperature that the case prescribes lies below that of the oil supplied. A film warms its "
        "oil, unless a housing cools it strongly: film and friction are computed all the same, for an oil more "
        "viscous than the bearing can have.",
        "Prescribe a temperature above that of the supply, correct one of the two, or leave "
        "`effective_temperature` out: the heat balance then finds it (film method: `thermal: global`).",
        effect=Effect.NO_VERDICT,
    ),
    "W142": Explanation(
        "Pressure beyond plain bearings",
        "The film pressure exceeds 100 MPa. There soft bearing metals yield, surfaces deform by more than the "
        "film is thick, and oils are several times as viscous as without pressure: a rigid film of constant "
        "viscosity, though solved, says little. The number is an assumption: a white metal of Brinell hardness "
        "30, the hardest on board, yields at about a third of its hardness.",
        "Check load, width and units; a larger bearing or less load.",
    ),
    "W143": Explanation(
        "The load points into a groove or pocket",
        "The load is directed at a groove as wide as the bearing, or at a pocket or hole. It carries no more than "
        "its own pressure, and the film beside it all the rest.",
        "Turn it away from the load; check `load_angle`, which is counter-clockwise from the x axis.",
    ),
    "W120": Explanation(
        "The journal whirls",
        "The rotor is heavier than the critical mass, or lighter than the least stable one: in this film it "
        "leaves its place and whirls, as a rule at about half the speed. The rotor is rigid, or one mass on an "
        "elastic shaft where `shaft_stiffness` is given.",
        "A bore with preload, tilting pads, or a narrower bearing; at light load a smaller clearance (mind the "
        "heat), while a larger one or a thinner oil helps only above a relative eccentricity of about 0.7 to 0.8. "
        "For a rotor of several masses make a rotordynamic analysis with stiffness and damping of the film.",
    ),
    "W125": Explanation(
        "No estimate of the grid error",
        "The film was found on the grid of the case, but not on a finer one, with which `error_estimate` compares "
        "it.",
        "Choose another `accuracy`; that numbers of two accuracies agree is an estimate, too.",
    ),
    "W127": Explanation(
        "The oil would be heated beyond the model",
        "Somewhere the oil would be more than 100 K warmer than it enters. The heat balances of plain bearings "
        "end there: oil ages, surfaces deform, and the numbers describe no bearing. The 100 K are an assumption.",
        "Check speed, load and units; more or cooler oil, a larger clearance, a thinner oil.",
        effect=Effect.NO_VERDICT,
    ),
    "W128": Explanation(
        "Oil hotter than its data",
        "The hottest oil known is above the temperatures for which the lubricant's numbers are meant: viscosity, "
        "and with it film, friction and temperature, are extrapolated where oil is thinnest.",
        "Give the lubricant by points that enclose the hottest place; more or cooler oil.",
        effect=Effect.NO_VERDICT,
    ),
    "W129": Explanation(
        "Film outside the validity of the method",
        "ISO 7902 holds up to an eccentricity ratio of 0.95. No film of smooth surfaces holds where it is thinner "
        "than the sum of the roughnesses Rz: there the surfaces touch.",
        "Less load, a more viscous or cooler oil, a larger bearing, smoother surfaces; check the clearance.",
        effect=Effect.NO_VERDICT,
    ),
    "W130": Explanation(
        "Unusual relative clearance",
        "Clearance over diameter lies outside 0.3 to 5 per mille, where plain bearings run (an assumption). Often "
        "a percentage or the radial clearance was typed.",
        "Check `clearance` and its unit: '1.1 permille' is 0.11 %.",
    ),
    "W131": Explanation(
        "The journal can rest elsewhere",
        "Under the same load the film has more than one equilibrium. The results are those of the one found "
        "first; where that is a saddle, those of the thinnest film among the places at which the journal stays. "
        "Slow, lightly loaded bearings with a high supply pressure are of this kind: beside a groove under "
        "pressure the narrowing gap chokes the flow, and the oil pushes the less, the nearer the journal comes.",
        "Lower the supply pressure, raise the speed or the load, or feed where the load does not lead the "
        "journal.",
    ),
    "W132": Explanation(
        "The journal leaves its place",
        "The equilibrium shown is a saddle: the smallest push and the journal moves to another place. No place "
        "where it stays was found, or with `equilibria: first` none was looked for.",
        "Leave `equilibria` at auto; lower the supply pressure, or raise the speed or the load.",
        effect=Effect.NO_VERDICT,
    ),
    "W133": Explanation(
        "Orbit on a coarse grid",
        "Where wedge and squeeze nearly cancel, as for a load that rotates near half the speed, the film force is "
        "a small difference of two large ones, and the grid blurs it.",
        "A finer `accuracy`.",
    ),
    "W134": Explanation(
        "An equilibrium may be missing",
        "The directions of the force around the clearance tell how many equilibria there must be, and another "
        "number was found. One of them may lie nearer to contact than the search looks.",
        "A finer `accuracy`; look at the film at the places in question with `position`.",
        effect=Effect.NO_VERDICT,
    ),
    "W135": Explanation(
        "Stiffness and damping not confirmed",
        "Central differences of the film's own load, with steps from 2 % of the smallest gap down, differ from "
        "stiffness and damping by more than 1 % and do not agree with each other: the film ends differently from "
        "step to step. Or no difference could be taken, and a bore that gives way is not counted in them. Results "
        "of stability are as uncertain.",
        "`accuracy: reference`; a margin on threshold speed and critical mass.",
    ),
    "W136": Explanation(
        "Stiffness and damping by differences of the load",
        "The derivative of the film with its ends frozen differs from the slope of its own load by more than 1 %, "
        "as beside pockets and holes and in a bore that gives way; the results hold central differences of the "
        "load, which count moving ends and a moving bore.",
        "Nothing; a finer `accuracy` brings both together.",
        Effect.INFORMATION,
    ),
    "W182": Explanation(
        "Direction of the load not used",
        "ISO 7902 takes the load through the middle of the loaded arc, and holes, pockets and grooves at places "
        "counted from the load. The direction of the load in space changes none of its results.",
        "Nothing, where the places of the supply elements were counted from the load; else give them so, or "
        "`method: film` with `grooves`, `pockets` or `holes` at their angles in the bore.",
        Effect.INFORMATION,
    ),
    "W183": Explanation(
        "Input not used",
        "The method does not read this field of the case: the result would be the same without it. A bearing "
        "may describe what feeds it twice, by `span` and `supply_element` for ISO 7902, and by `grooves`, "
        "`pockets` and `holes` for the film; every method reads its own.",
        "Nothing, where the field is meant for another method (`babbitt compare`); else leave it out, or choose "
        "the method that reads it.",
        Effect.INFORMATION,
    ),
    "W184": Explanation(
        "Supply of the film assumed",
        "The case does not say what feeds the film: it is taken as flooded with oil at the pressure of the supply "
        "along lines as wide as the bearing. Holes and pockets deliver less; the real film may be hotter and "
        "thinner.",
        "Give `supply_element`, or `grooves`, `pockets` or `holes`.",
    ),
    "W181": Explanation(
        "Digits that may be grouped",
        "A point is the decimal sign: '12.000 N' is twelve newtons. Where exactly three digits stand behind it, "
        "with a zero at the end or in a small unit (N, Pa, W, rpm), thousands may have been meant, as in "
        "'12.000 N' for twelve kilonewtons.",
        "Write '12 N' or '12 kN', whichever is meant.",
    ),
}
