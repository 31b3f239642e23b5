"""Journal bearings whose film is solved: from the description of a bearing to the film, its heat balance and its answer.

``model`` and ``bore`` describe, ``layout`` draws the film, ``warm_film`` finds it at a temperature, ``check`` answers.
"""
