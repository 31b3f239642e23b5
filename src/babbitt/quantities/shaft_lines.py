"""Axial vibration of shaft lines."""

from __future__ import annotations

from babbitt.quantities.quantity import Quantity, quantity

SHAFT_LINES: tuple[Quantity, ...] = (
    quantity("loss_mean_bound", "L_1", "1", "%", 3, "Dynamic over mean static pad load, any phases"),
    quantity("loss_mean_peak", "L_1,peak", "1", "%", 3, "Dynamic over mean static pad load, phases as given"),
    quantity(
        "loss_mean_worst_turn", "L_1,turn", "1", "%", 3, "The same at the worst angle of propeller to collar"
    ),
    quantity("loss_own_bound", "L_2", "1", "%", 3, "Dynamic over own static load of a pad, any phases"),
    quantity("loss_own_peak", "L_2,peak", "1", "%", 3, "Dynamic over own static load of a pad, phases as given"),
    quantity("unload_margin_bound", "L_3", "1", "%", 3, "Least load left on a pad over the mean, any phases"),
    quantity(
        "unload_margin_peak",
        "L_3,peak",
        "1",
        "%",
        3,
        "Least load left on a pad over the mean, phases as given",
    ),
    quantity("dynamic_minimum_film", "h_dyn", "m", "um", 3, "Thinnest dynamic film, any phases"),
    quantity("dynamic_minimum_film_peak", "h_dyn,peak", "m", "um", 3, "Thinnest dynamic film, phases as given"),
    quantity("relative_film_amplitude", "h_rel", "1", "", 3, "Largest dynamic over static film at a pivot"),
    quantity("runout_share", "L_runout", "1", "%", 3, "Dynamic load by runout alone"),
    quantity("ripple_share", "L_ripple", "1", "%", 3, "Dynamic load by thrust ripple alone"),
    quantity("tilt_share", "L_tilt", "1", "%", 3, "Dynamic load with less without tilt and pad heights"),
    quantity("elasticity_share", "L_shaft", "1", "%", 3, "Dynamic load with the elastic less with a rigid shaft"),
    quantity("natural_frequency_1", "f_1", "rad/s", "Hz", 4, "First axial natural frequency, undamped"),
    quantity("natural_frequency_2", "f_2", "rad/s", "Hz", 4, "Second axial natural frequency, undamped"),
    quantity("natural_frequency_3", "f_3", "rad/s", "Hz", 4, "Third axial natural frequency, undamped"),
    quantity("natural_frequency_4", "f_4", "rad/s", "Hz", 4, "Fourth axial natural frequency, undamped"),
    quantity("damping_ratio_1", "D_1", "1", "%", 3, "Damping ratio of the first mode"),
    quantity(
        "frequency_separation", "δ_f", "1", "%", 3, "Least distance of an excitation from a natural frequency"
    ),
    quantity("admissible_runout", "A_adm", "m", "um", 3, "Largest runout amplitude within the limit of loss"),
    quantity("admissible_tilt", "e_adm", "m", "um", 3, "Largest tilt of the housing within the limit of loss"),
    quantity("admissible_ripple", "Q_adm", "N", "kN", 4, "Largest thrust ripple within the limit of loss"),
    quantity("half_load_ring_stiffness", "c_half", "N/m", "GN/m", 4, "Stiffest ring that halves the dynamic load"),
    quantity("best_ring_stiffness", "c_best", "N/m", "GN/m", 4, "Ring with the least dynamic load of the sweep"),
    quantity("best_ring_loss", "L_best", "1", "%", 3, "Dynamic load on that ring"),
    quantity("nonlinear_load_peak", "N_load", "N", "kN", 4, "Nonlinear motion: largest load above the static one"),
    quantity(
        "nonlinear_unload_peak",
        "N_unload",
        "N",
        "kN",
        4,
        "Nonlinear motion: largest load below the static one",
    ),
    quantity("nonlinear_minimum_film", "h_nl", "m", "um", 3, "Nonlinear motion: thinnest film"),
    quantity("mean_film_shift", "Δh", "m", "um", 3, "Nonlinear motion: largest mean film less the static one"),
    quantity("runout_force", "N_R,i", "N", "kN", 4, "Amplitude of each pad force by runout"),
    quantity("ripple_force", "N_Q,i", "N", "kN", 4, "Amplitude of each pad force by thrust ripple"),
    quantity("dynamic_peak", "N_peak,i", "N", "kN", 4, "Largest dynamic force of each pad, phases as given"),
    quantity("dynamic_bound", "N_bound,i", "N", "kN", 4, "Largest dynamic force of each pad, any phases"),
    quantity("pad_dynamic_film", "h_dyn,i", "m", "um", 3, "Thinnest dynamic film of each pad, any phases"),
    quantity("damped_modes", "D", "1", "", 4, "Damped frequency (rad/s) and damping ratio of each mode"),
    quantity(
        "ring_sweep",
        "c_sweep",
        "1",
        "",
        4,
        "Ring: stiffness, runout, ripple, bound, film amplitude, thinnest film, first frequency, static ratio; SI",
    ),
    quantity(
        "campbell",
        "f_n",
        "1",
        "",
        4,
        "Speed (rad/s), loss (bound) and natural frequencies (rad/s) of each point of the sweep",
    ),
    quantity("barred_ranges", "n_bar", "1", "", 4, "Barred speeds: from, to (rad/s), order of the excitation"),
)
