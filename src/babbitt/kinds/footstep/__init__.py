"""The hydrostatic footstep of a pump's screw, with a smooth or a screw-grooved heel.

``model`` says what is computed; ``states`` finds every steady state by ``superposition`` (the equations of the
published study, corrected) or by ``warm_films`` (narrow-groove theory with heat to the metal); ``clearances``
tells where states vanish; ``axial`` and ``eccentric`` hold stiffness, damping and side forces; ``check`` makes
results of them.
"""
