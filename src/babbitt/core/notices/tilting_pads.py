"""Warnings about tilting-pad journal bearings."""

from __future__ import annotations

from babbitt.core.notices.explanation import Effect, Explanation

TILTING_PADS: dict[str, Explanation] = {
    "W401": Explanation(
        "A pad carries nothing",
        "The journal stands so far from a pad that no tilt of it builds a film that carries (spragging). It "
        "counts as concentric with its bore: it has neither stiffness nor damping, shears the oil that it "
        "passes, and may flutter, which wears its edge and pivot.",
        "More preload of that pad; the message says from which on a pad on a centred pivot carries.",
    ),
    "W402": Explanation(
        "A pad is near the end of its load",
        "The eccentricity ratio at the pivot is less than 0.05 above that at which the pad unloads; tolerances of "
        "the pads and heat move it by more.",
        "More preload of that pad.",
    ),
    "W403": Explanation(
        "Stiffness, damping and virtual mass do not fit",
        "Over the whirl ratios of the case the impedance of the bearing differs from K - ω² M + j ω C by more "
        "than 5 %. Coefficients at each ratio stand beside the fit.",
        "A narrower band of whirl_ratios, coefficients over speed and frequency, or the full matrices with pads.",
        effect=Effect.INFORMATION,
    ),
    "W405": Explanation(
        "The pads get less oil than they draw in",
        "The supply gives less than the leading edges draw in besides the oil that is carried over. The films "
        "then begin later than the pads, and carry and cool less than computed.",
        "More oil, more carry-over where that is true, or less clearance.",
        effect=Effect.NO_VERDICT,
    ),
    "W407": Explanation(
        "Films of the pads are not laminar",
        "The Reynolds number at the machined clearance exceeds 41.3 sqrt(R/c_p), where vortices begin (Taylor; "
        "the limit of ISO 7902). They raise friction and temperatures; the films here are laminar.",
        "Take a bearing in the laminar range, or count friction and temperatures as too low.",
        effect=Effect.NO_VERDICT,
    ),
    "W408": Explanation(
        "Wide contact of a pivot",
        "The half width of a line contact is more than 5 % of the radius of the pivot: the half-spaces of Hertz "
        "end, and the pivot is stiffer than computed.",
        "A smaller difference of radii is no contact of Hertz: give the pivot as a table or a stiffness.",
    ),
    "W409": Explanation(
        "A pivot before the middle of its pad",
        "In the sense of rotation the pivot stands nearer to the leading edge than to the trailing one. Such a "
        "pad carries less and unloads at once; offset pads are made for one sense of rotation.",
        "Check the sign of speed and the fraction of the pivot, which counts from the leading edge.",
    ),
    "W410": Explanation(
        "Unusual pads",
        "Two pads hold the journal in one direction only; a preload below zero gives a pad more room at its pivot "
        "than its bore is wider than the journal.",
        "Check number of pads and clearances: 1 - preload is the assembled over the machined clearance.",
    ),
    "W412": Explanation(
        "A film begins without oil",
        "A flexure holds a lightly loaded pad so that its gap widens behind the leading edge: the film ruptures "
        "there and begins again without oil (Reynolds condition). Flows, and with them the heat balance, count "
        "that oil.",
        "More preload of that pad, or a softer flexure.",
    ),
    "W411": Explanation(
        "The place of the journal is indifferent in one direction",
        "The loaded pads all push along one line. Across it nothing holds the journal, and it stands where the "
        "search began.",
        "More preload, or another direction of the load.",
        effect=Effect.NO_VERDICT,
    ),
}
