#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Holds the pictures of loads, shapes, scales and strength against what is known.

Usage: check_pictures_of_runs.py FIGURES.py WORKDIR

Tables of known numbers, and the figures of scripts/figures*.py made of them before they
become pictures: which curve stands on which axis, with which unit, and where each label
is. Exit status 77 (skipped) without numpy or matplotlib.
"""

import json
import sys
from pathlib import Path

from check_pictures import Figures, Run, all_axes, check

# ---- the load history


HISTORY = (["step", "load_factor"]
           + [f"support:clamp:f{c}" for c in "xyz"]
           + [f"contact:{name}:f{c}" for name in ("nip", "far-1") for c in "xyz"]
           + [f"probe:{name}:u{c}" for name in ("tip", "mid_1") for c in "xyz"]
           + [f"{name}:m{c}" for name in ("support:clamp", "contact:nip") for c in "xyz"]
           + ["measure:twist"])


def steps(with_contact=True):
    """Loads 1, 2, 3 of a cantilever of length 500: 10 N, and 5 N m at its clamp; what
    touches carries 4 N at y = 400, so 1.6 N m about the origin."""
    for k in (1, 2, 3):
        row = {"step": k, "load_factor": k, "support:clamp:fz": 10. * k,
               "support:clamp:fx": 1e-9 * k, "support:clamp:mx": -5e3 * k,
               "support:clamp:my": 1e-3 * k, "probe:tip:uz": -2. * k,
               "probe:mid_1:uz": -k, "measure:twist": 1e5 * k}
        if with_contact:
            row.update({"contact:nip:fz": 4. * k, "contact:nip:mx": 1.6e3 * k})
        yield row


def curves_of(axis):
    """The label of each curve of an axis, and its last value."""
    return {line.get_label(): round(float(line.get_ydata()[-1]), 9)
            for line in axis.lines}


def history_of(figures, folder, rows, **summary):
    run = Run(folder)
    told = json.loads((folder / "summary.json").read_text())
    (folder / "summary.json").write_text(json.dumps({**told, **summary}))
    run.write("history.csv", HISTORY, rows)
    (name, figure), = figures.history.load_history(figures.data.Results(folder))
    check(name == "history", name)
    return figure


def check_history(figures, folder):
    failure = {"ply": 2, "body": "beam", "mode": "tension", "load_factor": 2.}
    figure = history_of(figures, folder, steps(), first_failure=failure)
    forces, moments = figure.axes
    check(forces.get_ylabel() == "force [N]" and moments.get_ylabel() == "moment [N m]",
          f"two axes: {forces.get_ylabel()}, {moments.get_ylabel()}")
    mark = "first failure: ply 2 of beam, tension"
    drawn = curves_of(forces)
    check(drawn == {"$F_z$ of contact nip": 12., mark: 8.},
          f"forces, and the first failure on one: {drawn}")
    drawn = curves_of(moments)
    check(drawn == {"$-M_x$ of support clamp": 15.}, f"moments of supports: {drawn}")
    check(moments.get_xlabel() == "$-u_z$ of tip [mm]", moments.get_xlabel())

    forces, _ = history_of(figures, folder, steps(with_contact=False)).axes
    drawn = curves_of(forces)
    check(drawn == {"$F_z$ of support clamp": 30.},
          f"forces of supports where nothing touches: {drawn}")

    def only(*columns):
        """What else the clamp holds is rounding."""
        return ({c: value if c in columns or "clamp" not in c else 1e-9 * row["step"]
                 for c, value in row.items()} for row in steps(with_contact=False))

    axis, = history_of(figures, folder, only("support:clamp:fz")).axes
    check(axis.get_ylabel() == "force [N]", "no axis for moments that are rounding")
    axis, = history_of(figures, folder, only("support:clamp:mx"),
                       first_failure=failure).axes
    check(axis.get_ylabel() == "moment [N m]" and mark in curves_of(axis),
          "a couple alone: no axis for forces that are rounding")


# ---- strength


PLIES = "step,body,ply,s,x,y,z,inverse_reserve_factor".split(",")


def outside(figure):
    """The texts that reach beyond what is saved of a figure."""
    figure.canvas.draw()
    renderer = figure.canvas.get_renderer()
    saved = figure.get_tightbbox(renderer).padded(0.01)
    low, high = (figure.dpi_scale_trans.transform(corner) for corner in (
        saved.min, saved.max))
    texts = list(figure.texts) + [text for axis in all_axes(figure) for text in (
        axis.xaxis.label, axis.yaxis.label, axis.title, *axis.texts)]
    boxes = [(text.get_text(), text.get_window_extent(renderer)) for text in texts
             if text.get_text()]
    return [text for text, box in boxes
            if (box.min < low).any() or (box.max > high).any()]


def check_strength(figures, folder):
    for plies in (1, 2, 3, 16):
        run = Run(folder)
        run.write("plies_along.csv", PLIES, (
            {"step": 1, "body": "bar", "ply": ply, "s": k, "y": k,
             "inverse_reserve_factor": "" if k < 3 or ply == 2 else 0.1 * k / ply}
            for ply in range(1, plies + 1) for k in range(15)))
        (_, figure), = figures.strength.ply_stacks(figures.data.Results(folder))
        check(not outside(figure), f"{plies} plies: all labels are in the picture "
              f"{outside(figure)}")
        contours = figure.axes[0].collections[1:]
        check(contours, "a line where 1/R is 1")


def main():
    if len(sys.argv) != 3:
        sys.exit("Usage: check_pictures_of_runs.py FIGURES.py WORKDIR")
    try:
        import matplotlib  # noqa: F401
        import numpy  # noqa: F401
    except ImportError:
        print("numpy or matplotlib is not here: skipped")
        sys.exit(77)
    figures, folder = Figures(Path(sys.argv[1])), Path(sys.argv[2])
    for part in (check_history, check_strength):
        part(figures, folder)
        figures.style.plt.close("all")


if __name__ == "__main__":
    main()
