"""ISO 7902: steady-state hydrodynamic plain journal bearings, circular cylindrical."""

from babbitt.kinds.journal.iso7902.model import DesignCase
from babbitt.kinds.journal.iso7902.procedure import check

__all__ = ["DesignCase", "check"]
