"""What to cite for the methods of footsteps."""

KIRICHENKO = (
    "A. S. Kirichenko: study of a hydrostatic footstep with a screw-grooved heel in a three-screw pump. "
    "Problems of "
    "Tribology (2011) (equations, corrected; see `babbitt validate screw_heel_claims`)."
)
NARROW_GROOVE = (
    "J. H. Vohr, C. Y. Chow: Characteristics of herringbone-grooved, gas-lubricated journal bearings. Journal "
    "of Basic "
    "Engineering 87 (1965) 568-578 (narrow-groove theory)."
)
