"""The infinitely long film with heat exchange through journal and bush.

One dimension, around the journal: no oil leaves at the sides, so that loads are upper bounds. `model` says what
is given, `pressure` integrates Reynolds' equation, `walls` makes heat and takes it through the walls, `network`
closes the balances of film, bush ring and journal, `solve` iterates all of them, `check` makes the design check.
"""
