"""A coefficient table in another frame: axes turned, bearing seen from the other end, axes along the load."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from babbitt.core.notices import InputError
from babbitt.export.coefficients import Array, CoefficientTable
from babbitt.export.frame import Rotation

_MIRROR = np.diag([-1.0, 1.0])


def rotated(table: CoefficientTable, angle: float) -> CoefficientTable:
    """The same bearing in axes turned counter-clockwise.

    With R the rotation matrix of the new axes in the old, v = R v' for any vector, so that K' = R^T K R.

    Parameters
    ----------
    table : CoefficientTable
    angle : float
        From the old x axis to the new, counter-clockwise, rad.

    Returns
    -------
    CoefficientTable
        Trace, determinant and the difference of the cross-coupling terms stay what they were.
    """
    c, s = np.cos(angle), np.sin(angle)
    axes = np.array([[c, -s], [s, c]])
    load = table.frame.load_angle
    frame = replace(
        table.frame,
        x_axis_angle=table.frame.x_axis_angle + angle,
        load_angle=None if load is None else load - angle,
    )
    return replace(_transformed(table, axes), frame=frame)


def mirrored(table: CoefficientTable) -> CoefficientTable:
    """The same bearing seen from the other end of the shaft.

    The horizontal axis points the other way then, the journal turns the other way, and the cross-coupling
    terms change their sign. Read the other way round: the bearing of opposite hand under the mirrored load.
    Coefficients that were computed for one rotation sense serve a shaft that turns in the other sense if the
    bearing and its load are mirror images of each other, and only then.

    Parameters
    ----------
    table : CoefficientTable

    Returns
    -------
    CoefficientTable
        x has become -x; applied twice it is the table itself.
    """
    load, axis = table.frame.load_angle, table.frame.x_axis_angle
    frame = replace(
        table.frame,
        rotation=table.frame.rotation.opposite,
        load_angle=None if load is None else np.pi - load,
        x_axis_angle=-axis,
    )
    return replace(_transformed(table, _MIRROR), frame=frame)


def in_load_frame(table: CoefficientTable) -> CoefficientTable:
    """The frame of Lund and Thomsen: x along the load, y a quarter turn further in the sense of rotation.

    For a load straight down and counter-clockwise rotation, K_xx and K_yy change places, and K_xy becomes
    -K_yx. A clockwise table is seen from the other end first, so that y lies in the sense of rotation.

    Parameters
    ----------
    table : CoefficientTable

    Returns
    -------
    CoefficientTable

    Raises
    ------
    InputError
        E003 when the table does not know the direction of its load.

    References
    ----------
    Lund, J. W.; Thomsen, K. K.: A calculation method and data for the dynamic coefficients of oil-lubricated
    journal bearings. Topics in Fluid Film Bearing and Rotor Bearing System Design and Optimization, ASME 1978.
    """
    seen = mirrored(table) if table.frame.rotation is Rotation.CLOCKWISE else table
    if seen.frame.load_angle is None:
        raise InputError(
            "E003", f"{table.name}: the table does not say where its load points; give frame.load_angle"
        )
    return rotated(seen, seen.frame.load_angle)


def for_rotor_programs(table: CoefficientTable) -> CoefficientTable:
    """The frame that programs for rotor dynamics take for granted: x right, y up, rotation from x towards y.

    Axes that lie otherwise are turned back. A clockwise table is refused, for only the caller knows whether the
    rotor model is seen from the other end.

    Parameters
    ----------
    table : CoefficientTable

    Returns
    -------
    CoefficientTable

    Raises
    ------
    InputError
        E003 for a clockwise table.
    """
    if table.frame.rotation is Rotation.CLOCKWISE:
        raise InputError(
            "E003",
            f"{table.name}: the table holds for clockwise rotation; rotor programs count speed positive from x "
            "to y and would take the cross-coupling with the wrong sign. Write mirrored(table), the bearing seen "
            "from the other end, and build the rotor from that end",
        )
    return table if table.frame.x_axis_angle == 0.0 else rotated(table, -table.frame.x_axis_angle)


def _transformed(table: CoefficientTable, axes: Array) -> CoefficientTable:
    """The table in new axes, which turn or mirror the plane of the journal; the frame is left to the caller."""

    def change(matrices: Array) -> Array:
        return np.asarray(axes.T @ matrices @ axes)

    over = table.over_frequency
    return replace(
        table,
        stiffness=change(table.stiffness),
        damping=change(table.damping),
        mass=None if table.mass is None else change(table.mass),
        over_frequency=None if over is None else over.changed(change),
        systems=tuple(system.turned(axes, axes is _MIRROR) for system in table.systems),
    )
