"""How far an unsolved case came, in words."""

from __future__ import annotations

from babbitt.design.heat_balance import Equilibrium, FilmT
from babbitt.results import Outcome


def failure(found: Equilibrium[FilmT], most: str = "an eccentricity of 0.99") -> str:
    """Say how far an unsolved case came.

    Parameters
    ----------
    found : Equilibrium
    most : str
        The thinnest film that the method knows.
    """
    reached = f"{found.last_temperature - 273.15:.1f} °C"
    match found.outcome:
        case Outcome.OVERLOADED if found.film is None:
            return f"already at {reached} the load is more than {most} carries"
        case Outcome.OVERLOADED:
            return f"the film collapses at {reached} ({most.removeprefix('an ')}) while friction still heats it"
        case Outcome.THERMAL_RUNAWAY:
            return f"at {reached} the friction power still exceeds the heat carried away"
        case Outcome.NO_CLEARANCE:
            return f"the clearance is used up at {reached}"
        case _ if found.film is None:
            return f"no equilibrium of the journal was found at {reached}"
        case _:
            return f"the last effective temperature was {reached}"
