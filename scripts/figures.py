#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws what a run left in a folder into its subfolder pictures.

Usage: figures.py DIR (through scripts/plot, which finds a fitting python3)

No scene is known by name: the data decide which figures there are. A line along a
body's axis, thickness or width gives a figure of that kind, lines of two bodies that
meet one through both, a section cut a contour, several load steps a
picture of forces and moments over a displacement, and each section its mesh. A contact with more than a few
active pairs gives its pressure, over a patch also as a map, and over the width of a
long patch beside the Hertz ellipse where the materials in scene.prm are isotropic;
cuts through the patch give contours around it, friction its shear, what sticks and
slips, and the loop of a load that turns. Nodes that carry different lists of
fields give a strip along each body, goals their error bars, a run to a tolerance its
passes, and a sweep for strength how near each ply comes to failure along its body. The
bodies for ParaView give the deformed shape, the stress on it, and the shape of each mode.
response.csv gives amplitudes and phases over the frequency.

figures_data.py reads, figures_style.py holds what all figures share, and
figures_lines.py, figures_history.py, figures_sections.py, figures_contact.py, figures_friction.py,
figures_goals.py, figures_strength.py, figures_shape.py, figures_stress.py and figures_modes.py
draw; figures_surface.py reads what the last three show. In the end the script
says where the pictures are.
"""

import sys
from collections import defaultdict
from pathlib import Path

from figures_contact import around_the_contact, contact_pressure
from figures_data import Results
from figures_friction import contact_friction, loop
from figures_goals import fields_of_nodes, goals_with_bars, passes_of_a_tolerance
from figures_history import load_history
from figures_lines import across_the_width, along_the_axis, through_the_thickness
from figures_modes import harmonic_response, mode_shapes
from figures_sections import section_cuts, section_meshes
from figures_shape import deformed_shape
from figures_strength import ply_stacks
from figures_stress import stress_on_the_shape
from figures_style import plt

FIGURES = (deformed_shape, stress_on_the_shape, along_the_axis, through_the_thickness,
           across_the_width, section_cuts, load_history, loop, contact_pressure,
           contact_friction, around_the_contact, section_meshes, fields_of_nodes,
           goals_with_bars, passes_of_a_tolerance, ply_stacks, mode_shapes,
           harmonic_response)


def main():
    if len(sys.argv) != 2 or not Path(sys.argv[1]).is_dir():
        sys.exit("Usage: scripts/plot DIR (the output folder of a run)")
    folder = Path(sys.argv[1])
    results = Results(folder)
    pictures = folder / "pictures"
    pictures.mkdir(exist_ok=True)
    for old in pictures.glob("*.png"):
        old.unlink()
    taken = defaultdict(int)
    for draw in FIGURES:
        for name, figure in draw(results):
            taken[name] += 1
            suffix = f"_{taken[name]}" if taken[name] > 1 else ""
            figure.savefig(pictures / f"{name}{suffix}.png")
            plt.close(figure)
    if taken:
        print(f"Pictures:  {pictures}")
    else:
        print(f"{folder} holds nothing to draw (no lines, cuts, load steps or goals).")


if __name__ == "__main__":
    main()
