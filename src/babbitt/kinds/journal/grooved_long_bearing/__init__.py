"""Heat balance by segments: a long film with one axial groove in its loaded zone.

`model` says what is given, `pressure` integrates one segment, `solve` closes the heat of both, the groove between
them and the compliance of the wall, `ungrooved_reference` compares the bearing with the ungrooved one, `check`
makes the design check.
"""
