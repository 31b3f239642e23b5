"""Warnings about films of one dimension."""

from __future__ import annotations

from babbitt.core.notices.explanation import Effect, Explanation

ONE_DIMENSION: dict[str, Explanation] = {
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
        effect=Effect.INFORMATION,
    ),
    "W153": Explanation(
        "The groove makes the film hotter",
        "Under the same load the rigid film with a groove runs at a greater eccentricity, and what leaves it is "
        "hotter than without the groove. A groove cools at the same gap, not at the same load, unless the "
        "deformed film keeps its load capacity, which this model cannot show. In a film of finite width, whose "
        "sides let oil out, a groove need not heat.",
        "Place the groove outside the loaded zone, or see the film in two dimensions: `babbitt compare`.",
        effect=Effect.INFORMATION,
    ),
    "W154": Explanation(
        "Blind groove short of oil",
        "Even without any pressure in the blind groove more oil could leave it than enters it: the film behind it "
        "would starve.",
        "Move the groove away from the thinnest film, or open and feed it.",
    ),
    "W155": Explanation(
        "Film thinner than the roughness allows",
        "The film is thinner than three times the combined roughness σ = sqrt(Rq_B² + Rq_J²), with Rq of about "
        "1.25 Ra: the surfaces begin to touch.",
        "Smoother surfaces, a more viscous or cooler oil, or less load.",
        effect=Effect.NO_VERDICT,
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
    "W158": Explanation(
        "Too narrow for an infinitely wide film",
        "The film has no sides by which oil leaves, and so carries more than that of the bearing: textbooks take "
        "it for a fair model above B/D of about 2 (A. Z. Szeri, Fluid Film Lubrication, 1998; B. J. Hamrock, "
        "Fundamentals of Fluid Film Lubrication, 1994). At an eccentricity of 0.8 and one viscosity a full "
        "bearing carries 62 % of its load at B/D 1.5, 47 % at 1, 23 % at 0.5, 2 % at 0.125. At the same "
        "temperatures the film is thicker than the real one under a given load, and the load larger at a given "
        "eccentricity, so that a limit that is kept says nothing. Under a high load the other error counts: no "
        "fresh oil comes in by the sides, the film grows too hot, and may be lost where the real one is not.",
        "Judge the film thickness by `method: film`, or `iso7902`; take this method for where the heat goes.",
    ),
}
