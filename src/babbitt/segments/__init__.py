"""Heat balance by segments: a long film with one axial groove in its loaded zone.

`model` says what is given, `pressure` integrates one segment, `balance` closes its heat, `solve` iterates both
segments, the groove between them and the compliance of the film, `beside` puts the bearing beside the ungrooved one,
`check` makes the design check.
"""
