"""Every error, warning and status that Babbitt can say: code, meaning, remedy.

A notice in a result carries its code and the message with the numbers of the case. What the code means in
general and what can be done stands here once; ``babbitt explain CODE`` and the documentation print it.
The first letter tells the kind: E unusable input, W doubt that rides along with a result, S no solution.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Explanation:
    """What a code means and what to do about it."""

    title: str
    meaning: str
    remedy: str


@dataclass(frozen=True)
class Notice:
    """A doubt about a result: the code of an `Explanation` and the numbers of this case."""

    code: str
    message: str

    def __post_init__(self) -> None:
        if self.code not in EXPLANATIONS:
            raise KeyError(f"notice code {self.code} is not registered in babbitt.notices")


class BabbittError(Exception):
    """A mistake or a failure that the user can understand and act upon.

    Parameters
    ----------
    code : str
        A code of `EXPLANATIONS`.
    message : str
        What was wrong in this case, with its numbers and what is allowed.
    """

    def __init__(self, code: str, message: str) -> None:
        if code not in EXPLANATIONS:
            raise KeyError(f"error code {code} is not registered in babbitt.notices")
        super().__init__(message)
        self.code = code
        self.message = message


class InputError(BabbittError):
    """The input cannot be used; nothing was computed and nothing was written."""


EXPLANATIONS: dict[str, Explanation] = {
    # -- unusable input -------------------------------------------------------------------------------------
    "E001": Explanation(
        "File cannot be read",
        "The file does not exist, is not readable, is empty, too large, or is not text.",
        "Check the path. A case file is a UTF-8 text file of at most 1 MB.",
    ),
    "E002": Explanation(
        "Not valid YAML",
        "The text cannot be parsed as YAML: a bracket, an indentation, a quotation mark, a duplicate key, "
        "or an anchor that refers to itself.",
        "Look at the line named. `babbitt new journal` writes a file that works.",
    ),
    "E003": Explanation(
        "Field not usable",
        "A field is missing, unknown, of the wrong unit or type, or outside the range that makes sense.",
        "The message names the line, the field, what was given and what is allowed.",
    ),
    "E004": Explanation(
        "Fields contradict each other",
        "Two fields that are each allowed cannot both be true, such as a bore smaller than its journal.",
        "Correct one of the fields named.",
    ),
    "E005": Explanation(
        "Not in the catalogue",
        "A lubricant, material, tolerance class or case of that name is not on board.",
        "`babbitt list lubricants`, `babbitt list materials` show the names; own data can be given in the case.",
    ),
    "E006": Explanation(
        "Value outside a law or a table",
        "A quantity lies outside the range for which a law, fit or table is defined.",
        "The message names the range. Give own data where the catalogue ends.",
    ),
    "E007": Explanation(
        "Output cannot be written",
        "The folder does not exist, is not writable, or an extra needed for this format is not installed.",
        "Check the path; `pip install 'babbitt[report]'` installs what PDF, HTML and plots need.",
    ),
    "E101": Explanation(
        "Film cannot be laid out",
        "Lands, grooves, pockets, pressures or speeds do not describe a film: they overlap, are empty, "
        "lie outside "
        "the bearing, or nothing drives or feeds the film.",
        "Correct what the message names.",
    ),
    "E130": Explanation(
        "Footstep cannot be laid out",
        "Lengths, oil, pressures or grooves of a hydrostatic footstep do not describe one: a number is not "
        "positive "
        "or not finite, the radii are out of order, the supply pressure is not above ambient (both absolute), "
        "or the "
        "grooves do not close around the heel.",
        "Correct the quantity named. Groove and land widths are normal to the groove: starts (groove + land) = "
        "2 pi radius sin(angle).",
    ),
    "E201": Explanation(
        "Thrust pad cannot be laid out",
        "Radii, extent, pivot, face or number of the pads of a thrust bearing do not describe pads on a ring: "
        "they "
        "overlap, a pivot lies beside its pad, or a length is not positive.",
        "Correct what the message names.",
    ),
    "E202": Explanation(
        "Pad cannot be balanced on its pivot",
        "No tilt makes the moments of the film about the pivot vanish, or the pad carries nothing. A plane "
        "pad in oil "
        "of one viscosity carries only when its pivot lies behind the middle.",
        "Move the pivot towards the trailing edge (0.55 to 0.65 of the extent are usual), give the pad a "
        "crown, or "
        "turn the shaft the other way.",
    ),
    "E203": Explanation(
        "Shaft line cannot be computed",
        "A mass, length, stiffness, damping, speed or excitation of the shaft line is missing or of the wrong "
        "sign, or "
        "an excitation falls on a frequency of a rod between fixed ends.",
        "Correct what the message names.",
    ),
    "E204": Explanation(
        "Resonance without damping",
        "An excitation lies within 2 % of a natural frequency, and neither films nor propeller nor seating "
        "damp the "
        "line: the amplitude has no bound.",
        "Give the damping of propeller, films or seating, or change speed, stiffness or mass.",
    ),
    # -- doubts about the design check --------------------------------------------------------------------------
    "W101": Explanation(
        "Film is not laminar",
        "The Reynolds number of the film exceeds 41.3 sqrt(D/C), up to which the ISO 7902 procedure is valid. "
        "Vortices raise friction and temperature above the values shown.",
        "Use `method: film` with `turbulence: ng_pan` or `constantinescu`, a smaller clearance, a more "
        "viscous oil or a lower speed.",
    ),
    "W102": Explanation(
        "Width ratio outside the standard",
        "ISO 7902 tabulates B/D from 0.125 to 1. The characteristics used here are computed, not extrapolated, "
        "and the formulas for supply flow and limits have no experience there.",
        "Read the result with care, or compare it with a film method.",
    ),
    "W103": Explanation(
        "Supply element outside the range of its flow formula",
        "The fits for holes and pockets hold for a relative width of 0.05 to 0.7 of the bearing width; the value "
        "at the nearest bound was used.",
        "Take the supply flow as an estimate; a film method gives the flow of the real pocket.",
    ),
    "W104": Explanation(
        "Uneven pockets replaced by a centred arc",
        "The standard knows only arcs centred on the load. The arc between uneven pockets is replaced by a "
        "conventional span rounded to a tabulated one.",
        "Compare with a film method, which sees the pockets where they are.",
    ),
    "W105": Explanation(
        "Loaded arc shorter than any tabulated span",
        "The pockets leave less than 90 degrees of centred arc; the characteristics of 90 degrees flatter it.",
        "Move the pockets away from the load or use a film method.",
    ),
    "W106": Explanation(
        "Circumferential groove splits the bearing",
        "A full circumferential groove divides the film into two lands. The load number was formed with the "
        "whole width.",
        "Compute two bearings of half the land width with half the load each.",
    ),
    "W107": Explanation(
        "Temperature outside the lubricant data",
        "The effective temperature lies outside the range for which the lubricant's numbers are meant.",
        "Give the lubricant by points that enclose the operating temperature.",
    ),
    "W108": Explanation(
        "Danger of whirl",
        "Below an eccentricity of about 0.55 (possible up to 0.60) or below Orlov's clearance the journal can "
        "whirl by itself. This is a screening rule, not a stability calculation.",
        "A larger clearance, a thinner oil, a narrower bearing, or a rotordynamic check with film coefficients.",
    ),
    "W109": Explanation(
        "Fast bearing",
        "Above 20 m/s the dynamics of shaft and film deserve a check of their own.",
        "Make a rotordynamic check with stiffness and damping of the film.",
    ),
    "W110": Explanation(
        "Pressure feed needed",
        "Cooled by its surroundings alone the bearing becomes hotter than permissible.",
        "Feed oil under pressure, enlarge the cooling surface, or move more air.",
    ),
    "W111": Explanation(
        "Supply pressure used up",
        "The pressure losses on the way consume the supply pressure: nothing is left to push oil through the "
        "supply element, and the side flow may not be made good.",
        "Larger tubes and holes, or a higher supply pressure.",
    ),
    "W112": Explanation(
        "No transition speed",
        "The film thickness at which mixed friction begins is larger than the radial clearance, or smaller than "
        "the tables reach; the transition speed is absent or an upper bound.",
        "Check roughness, tilt and waviness against the clearance.",
    ),
    "W113": Explanation(
        "Closed-form characteristics",
        "The closed forms of DIN 31652 deviate from the solution of the Reynolds equation by up to 7 % in load "
        "and 2.5 degrees in attitude angle, and exist for a full bearing only.",
        "Use `characteristics: computed` (the default) unless an old calculation is to be repeated.",
    ),
    "W114": Explanation(
        "Rotating bearing",
        "The friction formula of the procedure holds for a bearing at rest; with a turning bearing only the film "
        "forces and flows follow the effective speed.",
        "Take friction power and temperature as estimates.",
    ),
    "W115": Explanation(
        "Outside the experience tables",
        "No experience value of the permissible film thickness exists for this diameter.",
        "Give `surfaces` or `limits: {minimum_film_thickness: ...}`.",
    ),
    "W116": Explanation(
        "Film thinner than rigid films go",
        "Above an eccentricity of 0.95, or where the film is thinner than 0.05 of the clearance, elastic "
        "deformation, roughness and heat decide the film; a rigid isoviscous film is too simple.",
        "Treat the film thickness as an order of magnitude; lower the load or raise the viscosity.",
    ),
    "W117": Explanation(
        "Number without unit",
        "A number without unit is in SI: a speed in rad/s, a load in N. This one looks as if another unit was "
        "meant.",
        "Write the unit: '3000 rpm', '6 kN'; '3000 rad/s' or '6 N' if the number is meant as it stands.",
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
        "energy equation was left before it had settled.",
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
        "into it, and the heat of that oil (`heat_returned`) leaves through the supply. `outlet_temperature` is "
        "that of the oil at the sides; `groove_returned_flows` and `groove_temperatures` tell of every supply.",
        "Move the groove or pocket out of the loaded zone, or count on warmer supply oil.",
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
        "The load points into a groove",
        "The load is directed at a groove as wide as the bearing. The groove carries no more than its own "
        "pressure, and the film beside it all the rest.",
        "Turn the groove away from the load; check `load_angle`, which is counter-clockwise from the x axis.",
    ),
    "W120": Explanation(
        "The journal whirls",
        "The rotor is heavier than the critical mass: in this film it leaves its place and whirls at about half "
        "the speed. The rotor is rigid, or one mass on an elastic shaft where `shaft_stiffness` is given.",
        "A larger clearance, a thinner oil, a narrower bearing, a bore with preload, or tilting pads; for a rotor "
        "of several masses make a rotordynamic analysis with stiffness and damping of the film.",
    ),
    "W125": Explanation(
        "No estimate of the grid error",
        "The film was found on the grid of the case, but not on a finer one, with which `error_estimate` compares "
        "it.",
        "Choose another `accuracy`; that numbers of two accuracies agree is an estimate, too.",
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
    ),
    # -- doubts about the films of one dimension ----------------------------------------------------------------
    "W150": Explanation(
        "Published discretisation does not conserve the flow",
        "The pressure equation of the published calculation left out the change of viscosity, so that the local "
        "flow varies along the film: by 5 % of its mean at an eccentricity of 0.3, by 160 % at 0.8. Its heat "
        "balance, and its table, carry this error.",
        "Use `discretisation: consistent` (the default) for anything but repeating the published numbers.",
    ),
    "W151": Explanation(
        "Thick film",
        "The radial clearance exceeds 0.005 of the radius, so that the theory of thin films is no longer safe.",
        "Check the clearance and its unit.",
    ),
    "W152": Explanation(
        "Coarse film",
        "With fewer than 90 sectors the load is off by more than about 0.5 %.",
        "Use more sectors.",
    ),
    "W153": Explanation(
        "The groove makes the film hotter",
        "Under the same load the rigid film with a groove runs at a greater eccentricity, and what leaves it is "
        "hotter than without the groove. A groove cools at the same gap, not at the same load, unless the "
        "deformed film keeps its load capacity, which this model cannot show.",
        "Place the groove outside the loaded zone, or compare with a film in two dimensions.",
    ),
    "W154": Explanation(
        "Blind groove short of oil",
        "Even without any pressure in the blind groove more oil could leave it than enters it: the film behind it "
        "would starve.",
        "Move the groove away from the thinnest film, or open and feed it.",
    ),
    "W155": Explanation(
        "Film thinner than the roughness allows",
        "The film is thinner than three times the combined roughness, sqrt(Ra_B² + Ra_J²): the surfaces touch.",
        "Smoother surfaces, a more viscous or cooler oil, or less load.",
    ),
    "W156": Explanation(
        "Gain of a blind groove is apparent",
        "A film cut in two has two mean temperatures in place of one and so carries more, even if the groove has "
        "no width at all. That is no benefit of the groove.",
        "Compare with the ungrooved film cut at the same angle.",
    ),
    "W157": Explanation(
        "Groove behind the loaded film",
        "The groove lies where the film has already broken, or widens from the groove on: the film behind it "
        "carries nothing and makes no heat, so that `outlet_temperature` is merely that of the oil in the groove. "
        "The oil that the loaded film warms is told as `segment_1_outlet_temperature`; limits hold for that.",
        "Leave the groove out, or place it before the narrowest gap.",
    ),
    # -- doubts about footsteps ---------------------------------------------------------------------------------
    "W160": Explanation(
        "Steady state not stable",
        "In this state a higher pressure at the rim brings more oil to the rim than leaves it, so that the "
        "pressure "
        "runs away to another state. It satisfies the equations and will not be found running.",
        "Look at the stable state of the same heel; where none is stable, change the clearance or the face gap.",
    ),
    "W161": Explanation(
        "Oil of the groove very hot",
        "The oil that leaves the groove, or a film, is hotter than 150 °C. The temperature of the rim, where "
        "streams "
        "are mixed, does not show it.",
        "Read the state as a sign that the adiabatic groove is too simple; compare with `method: narrow_groove` "
        "and a "
        "`wall`, or choose a larger clearance.",
    ),
    "W162": Explanation(
        "Lands are no lands",
        "The clearance is a third of the groove depth or more: the lands hardly hinder the oil, and the "
        "formulas that "
        "set grooves against lands lose their sense.",
        "A smaller clearance or deeper grooves.",
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
    ),
    "W170": Explanation(
        "Eccentric grooved heel",
        "The leakage of an eccentric or tilted grooved heel counts the local clearance only; forces to the side "
        "are "
        "computed for the smooth heel alone, and friction by superposition as for a concentric one.",
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
    # hydrostatic bearings
    "W301": Explanation(
        "Oil flows back through a restrictor",
        "The film raises a recess above the supply pressure and pushes oil back into the manifold; the "
        "bearing loses load.",
        "Put a check valve before each recess (`check_valve: true`), or raise the supply pressure.",
    ),
    "W302": Explanation(
        "Pressure ratio far from its best",
        "Recess over supply pressure at the design point lies outside 0.3 to 0.8; stiffness falls off on "
        "either side.",
        "Change the restrictor: `stiffest_pressure_ratio` in the results says what to aim at.",
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
    ),
    "W305": Explanation(
        "Film not laminar",
        "The Reynolds number of the film exceeds 1000; the laminar film equation ends there.",
        "Treat friction and flow as lower bounds.",
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
    ),
    "W310": Explanation(
        "Pneumatic-hammer-like",
        "Compressible oil takes away more damping than the film has: a heavy enough mass on the bearing "
        "vibrates by itself.",
        "Shallower recesses, restrictors close to the recess, oil without air, more land.",
    ),
    "W311": Explanation(
        "Friction against pumping power",
        "The sum of both powers is far from its least, which lies at a ratio of 1 (viscosity free) to 3 "
        "(gap free).",
        "`least_power_gap` in the results says what gap to aim at with restrictors made to suit.",
    ),
    "W312": Explanation(
        "Warm oil",
        "The oil warms by more than 20 K between manifold and drain; one viscosity for the whole film is a "
        "rough guess.",
        "More flow, a thinner oil, less supply pressure or speed.",
    ),
    "W313": Explanation(
        "Pump too weak",
        "The supply pressure exceeds what the pump can hold.",
        "Another pump, or wider restrictors.",
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
    ),
    "W319": Explanation(
        "Lumped lands",
        "The quick method lumps the lands: stiffness of a four-recess journal bearing is some 3 % low, flow "
        "5 % high, damping too low.",
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
    # -- doubts about thrust bearings and shaft lines -----------------------------------------------------------
    "W201": Explanation(
        "Pads share the load very unevenly",
        "The tilt of the housing, or a pad height, is as large as the film that an even share would have, or "
        "a pad "
        "carries less than 1 % of the mean. Such a pad flutters or runs dry on another day of another alignment.",
        "Align the housing, adjust the heights of the pads, or give the ring more compliance.",
    ),
    "W202": Explanation(
        "Dynamic film beyond the linear range",
        "The film at a pivot moves by more than a fifth of its static value. Stiffness and damping of the static "
        "film are then off: the error of a peak was measured as 5 % at 0.22 and 9 % at 0.33.",
        "Solve the nonlinear motion (nonlinear: true), or take the bound with a margin.",
    ),
    "W203": Explanation(
        "Excitation near a natural frequency",
        "An excitation comes within 20 % of a natural frequency of the line. Frequencies are known no better "
        "than the "
        "stiffness of seating and ring and the entrained water.",
        "Bar this speed range, or move the frequency by seating, ring, shaft or number of blades.",
    ),
    "W204": Explanation(
        "Film of the pads is not laminar",
        "The Reynolds number of the film at the mean radius exceeds about 1000. Vortices raise friction and carry "
        "more load than the laminar film.",
        "Choose turbulence: ng_pan or constantinescu.",
    ),
    "W205": Explanation(
        "A pad leaves the collar or touches it",
        "In the nonlinear motion the load of a pad falls to nothing, a corner comes as close as surfaces are "
        "rough, or "
        "tilts leave the films that were tabulated. What follows such a moment is not computed reliably.",
        "Reduce runout, tilt or ripple; the tools for admissible amplitudes say how far.",
    ),
    # -- no solution --------------------------------------------------------------------------------------------
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
        "Less load; move supplies out of the loaded zone and try another accuracy; a bore that gives way by far "
        "more than the film is thick may be too soft for this load; if the bearing is an ordinary one, report the "
        "case to the developers.",
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
        "At the prescribed position the journal touches or cuts the bore: there is no film.",
        "A position nearer to the centre, or a larger clearance; both count at operating temperature.",
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
    "S020": Explanation(
        "No steady state",
        "At every flow of the groove the rim of the heel receives more oil than the clearance can carry away: the "
        "pressure at the rim would rise without end, as far as these equations go.",
        "A larger clearance (the fold clearance says from where), a larger face gap, a shallower groove or a "
        "lower "
        "speed; `method: narrow_groove` has a steady state for every clearance.",
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
        "the restrictor lets in.",
        "A wider restrictor, more supply pressure, less speed or eccentricity.",
    ),
    # -- checks of the design -----------------------------------------------------------------------------------
    "C101": Explanation(
        "Film thickness by experience",
        "The minimum film thickness is compared with a value by experience for diameter and surface speed.",
        "A more viscous or cooler oil, a larger bearing, less load.",
    ),
    "C102": Explanation(
        "Film thickness by surface geometry",
        "The minimum film thickness is compared with the sum of roughness, half the tilt offset, half the "
        "deflection, and effective waviness.",
        "Finer or truer surfaces, better alignment, or a thicker film.",
    ),
    "C103": Explanation(
        "Specific load",
        "The specific load is compared with the value by experience of the family of the bearing metal, or with "
        "the limit that the case sets.",
        "A larger bearing or a stronger metal.",
    ),
    "C104": Explanation(
        "Temperature",
        "The oil outlet temperature (pressure fed) or the bearing temperature (self-cooled) is compared with the "
        "value by experience or with the limit that the case sets.",
        "More oil, a cooler supply, a larger clearance, or a thinner oil.",
    ),
    "C105": Explanation(
        "Specific load of the metal",
        "The specific load is compared with the limit of the bearing metal for the character of the load.",
        "A larger bearing or a stronger metal.",
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
        "The hottest known temperature is compared with that at which the metal loses its hardness.",
        "More or cooler oil, or another metal.",
    ),
    "C109": Explanation(
        "Recommended temperature of the metal",
        "Advice only: the temperature recommended for lasting operation of the metal.",
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
        "Advice only: the relative clearance should exceed 3.5e-3 sqrt(lambda B/D).",
        "A larger clearance, a thinner oil, a narrower bearing.",
    ),
    "C113": Explanation(
        "Whirl screening by Dmitriev",
        "Advice only: the eccentricity ratio should exceed 0.60; below 0.55 whirl is possible.",
        "A larger clearance, a thinner oil, a narrower bearing.",
    ),
    "C115": Explanation(
        "Critical mass",
        "The mass above which a rigid rotor whirls, and with `shaft_stiffness` that of a rotor on an elastic "
        "shaft, is compared with the mass of the rotor (`rotor_mass`), or, as advice only, with the load over g.",
        "A larger clearance, a thinner oil, a narrower bearing, or a bore with preload.",
    ),
    "C116": Explanation(
        "Pressure of plain bearings",
        "Where no bearing metal is given to compare the load with, the largest film pressure is compared with "
        "100 MPa, about the yield strength of a white metal of Brinell hardness 30, the hardest on board.",
        "Give the metal (`materials: {bearing_metal: ...}`), which has limits of its own; a larger bearing.",
    ),
    "C114": Explanation(
        "Recommended clearance",
        "Advice only: the mean relative clearance should reach 0.8e-3 U^(1/4), with U in m/s.",
        "Choose a larger clearance where heat or whirl matter.",
    ),
    "C130": Explanation(
        "Stability of the steady state",
        "How the balance of the rim answers to a higher pressure: a positive slope of outflow less inflow "
        "drains the rim "
        "and the state is stable, as long as things change slowly; a negative one feeds it.",
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
        "Thinnest film at a corner of a pad: static, and in a shaft line with all harmonics for any phase.",
        "Less load or runout, a more viscous or cooler oil, a better alignment, a compliant ring.",
    ),
    "C203": Explanation(
        "Load left on the pad that is unloaded most",
        "Least of static plus dynamic load over the mean pad load; at 0 a pad leaves the collar.",
        "Reduce tilt first, which unloads the pads on one side, then runout.",
    ),
    "C204": Explanation(
        "Distance of the excitations from natural frequencies",
        "Least relative distance of an excitation from a natural frequency of the line; 20 % are advised.",
        "Bar the speed range, or move the frequency by seating, ring, shaft or number of blades.",
    ),
    "C301": Explanation(
        "Least gap",
        "The smallest gap against the least that the case allows.",
        "More supply pressure, more recess area, or a stiffer restrictor.",
    ),
    "C302": Explanation(
        "Load against its limit",
        "The load against the force of the film at the least gap allowed.",
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
    # -- checks of thrust bearings and shaft lines --------------------------------------------------------------
}
