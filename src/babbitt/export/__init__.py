"""Exchange of dynamic coefficients with programs for rotor dynamics, both ways, frame and units declared."""

from babbitt.export.ansys import read_ansys, write_ansys
from babbitt.export.coefficients import CoefficientTable
from babbitt.export.film_table import coefficient_table
from babbitt.export.formats import FORMATS, OVER_FREQUENCY, ExportFormat, export
from babbitt.export.frame import Frame, Rotation
from babbitt.export.frames import for_rotor_programs, in_load_frame, mirrored, rotated
from babbitt.export.json_file import read_json, write_json
from babbitt.export.ross import RossVersion, read_ross, write_ross
from babbitt.export.tidy_csv import read_csv, write_csv
from babbitt.export.whirl import OverFrequency, SystemMatrices
from babbitt.export.xltrc2 import read_xltrc2, write_xltrc2

__all__ = [
    "CoefficientTable",
    "ExportFormat",
    "FORMATS",
    "OVER_FREQUENCY",
    "Frame",
    "OverFrequency",
    "RossVersion",
    "Rotation",
    "SystemMatrices",
    "coefficient_table",
    "export",
    "for_rotor_programs",
    "in_load_frame",
    "mirrored",
    "read_ansys",
    "read_csv",
    "read_json",
    "read_ross",
    "read_xltrc2",
    "rotated",
    "write_ansys",
    "write_csv",
    "write_json",
    "write_ross",
    "write_xltrc2",
]
