"""Journal bearings whose film is solved: from description to film, heat balance and answer.

``model`` and ``bore`` describe, ``layout`` draws the film, ``isothermal`` finds it at a temperature,
``check`` answers.
"""
