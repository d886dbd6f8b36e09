# SPDX-License-Identifier: LGPL-2.1-or-later
"""What layers of cells at a section's corners do to displacements; see scripts/measure."""

from measure_bar_scenes import cantilever
from measure_bars import BarRun
from measure_fields import laminate
from measure_tools import ROOT, table

WITHOUT = "Goals/Error bars=false"


def corners():
    """doc/reference/sections.md: errors of deflections, equal cells, cells divided, layers at corners."""
    graded = ["Body beam/Kinematics/Axis breaks=", "Body beam/Kinematics/Axis elements=auto"]
    for name, scene, section, goal, truth, axis in (
            ("double-T", ROOT / "tests/scenes/double_t.prm", "beam", "edge: uz",
             ["Theory=LE-7", "Section beam/Corner layers=1"], graded),
            ("[45/-45/0], L/h = 20", cantilever(laminate("45/-45/0"), 20), "strip", "tip: uz",
             ["Theory=LE-6", "Section strip/Cells divided=1"], [])):
        true = BarRun(scene, [WITHOUT, *axis, *truth])
        variants = ["Corner layers=0", "Cells divided=1", "Corner layers=1", "Corner layers=2"]
        rows = []
        for degree in (3, 4, 5, 6):
            cells = []
            # Two layers of high degrees are more than most machines hold.
            for variant in variants if degree < 5 else variants[:3]:
                run = BarRun(scene, [WITHOUT, *axis, f"Theory=LE-{degree}",
                                     f"Section {section}/{variant}"])
                error = abs(run.value(goal) / true.value(goal) - 1.)
                cells.append(f"{run.summary['dofs']}, {100 * error:.2g}")
            rows.append([name, f"LE-{degree}", *cells] + [""] * (len(variants) - len(cells)))
        table(["section", "theory"] + [f"{variant}: DoFs, error of {goal}, %"
                                       for variant in variants], rows)
