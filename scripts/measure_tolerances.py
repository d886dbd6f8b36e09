# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs to a tolerance against uniform meshes that have it; see scripts/measure."""

import resource
import subprocess
import sys
import tempfile
from pathlib import Path

from measure_bar_scenes import cantilever
from measure_bars import BarRun, bar_of, poorer
from measure_fields import laminate
from measure_tools import ENVIRONMENT, PROGRAM, ROOT, table

# What a run to a tolerance may take; beyond that it is a row of its own kind.
MOST_SECONDS = 300
# Theories and axes: factors on the scene's own elements, and axes that are graded.
UNIFORM = [(theory, axis) for theory in ("LE-1", "LE-2", "LE-3", "LE-4")
           for axis in (0.5, 1, 2, "auto", "auto 2")]
SOLIDS = [(theory, axis) for theory in ("solid-1", "solid-2") for axis in (1, 2, 4)]
# Of a scene that has 32 plies: more does not fit in half an hour, and LE-2 has it.
FEW = {"coupon": ([("LE-1", 1), ("LE-2", 1)], [])}


class Timed(BarRun):
    """With the processor's seconds, less those of starting the program, and the passes
    of a run to a tolerance."""

    start = None

    def __init__(self, scene, overrides):
        if Timed.start is None:
            Timed.start = min(self.seconds_of([PROGRAM, "--version"]) for _ in range(3))
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        super().__init__(scene, overrides)
        self.seconds = (resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
                        - Timed.start)

    @staticmethod
    def seconds_of(words):
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        subprocess.run(words, env=ENVIRONMENT, capture_output=True, check=True)
        return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def kinematics(bodies, entry, value):
    return [f"Body {body}/Kinematics/{entry}={value}" for body in bodies]


def graded(bodies, factor=""):
    return (kinematics(bodies, "Axis breaks", "")
            + kinematics(bodies, "Axis elements", f"auto {factor}".strip()))


# Name, scene, bodies, goals, axis elements and breaks of the scene, what makes the truth.
SANDWICH = ROOT / "prm/sandwich.prm"
SCENES = [
    ("laminated beams", ROOT / "prm/laminated_beams.prm", ["upper", "lower"],
     ["upper_top: uz", "upper_top: syy", "middle: fz"], ([20], ""),
     ["Theory=LE-4", "Contact middle/Enforcement=exact",
      *kinematics(["upper", "lower"], "Axis elements", "60")]),
    ("sandwich", SANDWICH, ["beam"],
     ["indentation: fz", "quarter: uy", "bottom: syy", "core: syz"],
     ([6, 2, 2, 2, 6], "230, 247, 253, 270"),
     ["Theory=LE-4", *graded(["beam"], "2")]),
    ("Hertz, plane strain", ROOT / "prm/hertz_plane_strain.prm", ["upper", "lower"],
     ["press: fz", "upper_center: szz"], ([1], ""),
     ["Theory=LE-5", "Section half/Finest cell=0.015"]),
    ("Hertz, free faces", ROOT / "prm/hertz.prm", ["upper", "lower"],
     ["press: fz", "lower_center: szz"], ([1, 1, 1, 1, 1], "0.05, 0.2, 0.8, 0.95"),
     ["Theory=LE-4"]),
    ("coupon", ROOT / "prm/flexure_test.prm", ["coupon"],
     ["c_nose: fz", "middle: uz", "core: syz"],
     ([2, 4, 8, 4, 8, 4, 2], "12, 14, 76, 78, 140, 142"),
     ["Theory=SV-14", "Section laminate/Cells across=8",
      "Body coupon/Kinematics/Axis elements=4, 8, 16, 8, 16, 8, 4"]),
    ("cantilever [45/-45/0], L/h = 20", cantilever(laminate("45/-45/0"), 20), ["beam"],
     ["tip: uz", "third: syy", "inside: syz"], ([2, 4], "2"),
     ["Theory=LE-5", "Section strip/Cells across=8", "Section strip/Cells per ply=2",
      *graded(["beam"], "2")]),
    ("double-T", ROOT / "tests/scenes/double_t.prm", ["beam"],
     ["middle: uz", "edge: uz"], ([2, 6], "10"),
     ["Theory=LE-7", *graded(["beam"], "2")])]


def off_by(run, true, goals):
    """The largest error of a goal, relative."""
    return max(abs(run.value(goal) / true.value(goal) - 1.) for goal in goals)


def uniform(scene, bodies, goals, axis, true, models):
    """Seconds, DoFs, name and error of each of @p models, the cheapest first."""
    found = []
    for theory, which in models:
        elements, breaks = axis
        if isinstance(which, str):
            numbers, breaks = which, ""
        else:
            numbers = ", ".join(str(max(1, round(n * which))) for n in elements)
        run = Timed(scene, [f"Theory={theory}", "Goals/Error bars=false",
                            *kinematics(bodies, "Axis breaks", breaks),
                            *kinematics(bodies, "Axis elements", numbers)])
        if not run.failure:
            found.append((run.seconds, run.summary["dofs"], f"{theory}, axis {which}",
                          off_by(run, true, goals)))
    return sorted(found)


def cell_of(found, tolerance):
    for seconds, dofs, name, error in found:
        if error <= tolerance:
            return f"{name}: {dofs}, {seconds:.1f} s", seconds
    return "none", None


def alone(run):
    """Seconds by the clock of the run's last model, without bars: those of its phases."""
    return sum(seconds for phase, seconds in run.summary["seconds"].items()
               if phase != "total")


def to_tolerance(scene, bodies, goals, per_cent):
    return Timed(scene, ["Theory=auto", *graded(bodies), f"Goals/Tolerance={per_cent}",
                         "Goals/Quantities=" + " | ".join(goals),
                         f"Goals/Budget seconds={MOST_SECONDS}"])


def tolerances(pick=""):
    """doc/verification/tolerance-runs.md: nothing said about theory or mesh, against the cheapest uniform
    LE and solid. Seconds are the processor's, less the program's start."""
    rows = []
    for name, scene, bodies, goals, axis, truth in SCENES:
        if pick not in name:
            continue
        print(name, file=sys.stderr)
        true = BarRun(scene, [*truth, "Goals/Error bars=false"])
        if true.failure:
            raise RuntimeError(f"{name}: {true.failure}")
        layers, bricks = (uniform(scene, bodies, goals, axis, true, models)
                          for models in FEW.get(name, (UNIFORM, SOLIDS)))
        for per_cent in (1, 0.1):
            run = to_tolerance(scene, bodies, goals, per_cent)
            if run.failure:
                rows.append([name, per_cent, run.failure[:70]] + 8 * [""])
                continue
            passes = max(int(row["pass"]) for row in run.tables["passes.csv"])
            met = sum(goal["met"] for goal in run.summary["goals"].values())
            best, seconds = cell_of(layers, per_cent / 100)
            brick, of_brick = cell_of(bricks, per_cent / 100)
            theory = "; ".join(dict.fromkeys(run.summary["theory"].values()))
            rows.append([name, per_cent, theory, passes, run.summary["dofs"],
                         f"{run.seconds:.1f}", f"{run.seconds / alone(run):.1f}",
                         f"{met} of {len(goals)}",
                         f"{100 * off_by(run, true, goals):.2g}", best, brick])
            print(rows[-1], seconds, of_brick, file=sys.stderr)
    table(["scene", "tolerance, %", "ends with", "passes", "DoFs", "seconds",
           "over its last model", "goals met",
           "largest true error, %", "cheapest uniform LE: DoFs, seconds",
           "cheapest solid"], rows)


# Templates of `lamella new`, with what makes a reference that is richer in degree, axis and cells
# than what the runs end with.
CELLS = ["Section laminate/Cells across=4", "Body coupon/Kinematics/Axis elements=auto 2"]
TEMPLATES = {
    "three-point": ["Theory=LE-4", *CELLS],
    "four-point": ["Theory=LE-4", *graded(["coupon"], "2"), CELLS[0]],
    "short-beam": ["Theory=LE-5", *CELLS],
    "leaf-spring": ["Theory=LE-4", "Section leaf/Cells across=4", "Section leaf/Cells per ply=2",
                    "Body leaf/Kinematics/Axis elements=auto 2"],
    "indentation": ["Theory=LE-5", "Section sandwich/Cells across=4",
                    "Body beam/Kinematics/Axis elements=auto 4"]}
# Seconds and bytes that a run may take: a `Budget seconds` is kept between passes only.
MOST_OF_TEMPLATE = 240
LIMITS = ["prlimit", f"--as={8 * 2**30}", "timeout", str(MOST_OF_TEMPLATE)]


def verdict(bar):
    """Whether the bar covers the error; open if the reference may be off by as much."""
    if bar.bar is None:
        return "no bar"
    if bar.holds():
        return "covered"
    return "open" if abs(bar.error) <= bar.bar + bar.floor else "not covered"


def row_of_template(kind, theory, per_cent, run, true, nearly_true):
    """The goals of a run by verdict, those that it calls met first, and each of the others."""
    name = [kind, theory, f"{per_cent} %"]
    if run.failure:
        why = (f"not within {MOST_OF_TEMPLATE} s" if run.wall >= MOST_OF_TEMPLATE else
               run.failure.splitlines()[0][:90])
        return [*name, "", "", "", f"{run.wall:.0f}", why]
    goals = run.summary["goals"]
    bars = {goal: bar_of(run, goal, kind, theory, true, nearly_true) for goal in goals}
    counts = []
    for is_met in (True, False):
        found = [verdict(bars[goal]) for goal in goals if goals[goal]["met"] == is_met]
        counts.append(", ".join(f"{found.count(what)} {what}" for what in dict.fromkeys(found))
                      or "none")
    worst = max((bar for bar in bars.values() if bar.bar is not None),
                key=lambda bar: (verdict(bar) == "not covered", abs(bar.error)), default=None)
    described = "" if worst is None else (
        f"{worst.goal}: {100 * worst.error:+.2g} +- {100 * worst.bar:.2g}, "
        f"reference to {100 * worst.floor:.1g}")
    passes = max(int(row["pass"]) for row in run.tables["passes.csv"])
    return [*name, *counts, described, f"{run.wall:.0f}", passes]


def templates(pick=""):
    """doc/verification/tolerance-runs.md: runs to a tolerance of the scenes of `lamella new`, with the theory of
    the template and with `auto`, against references. Seconds are by the clock."""
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for kind, truth in TEMPLATES.items():
            if pick not in kind:
                continue
            subprocess.run([PROGRAM, "new", kind, "--kind", kind], cwd=folder, check=True,
                           capture_output=True)
            scene = Path(folder) / f"{kind}.prm"
            true, nearly_true = (BarRun(scene, [*overrides, "Goals/Error bars=false"])
                                 for overrides in (truth, poorer(truth)))
            for theory in ("", "auto"):
                for per_cent in (10, 2):
                    chosen = [f"Theory={theory}"] if theory else []
                    run = BarRun(scene, [*chosen, f"Goals/Tolerance={per_cent}"], LIMITS)
                    rows.append(row_of_template(kind, theory or "its own", per_cent, run, true,
                                                nearly_true))
                    print(rows[-1], file=sys.stderr, flush=True)
    table(["template", "theory", "tolerance", "goals met", "goals not met",
           "largest error, its bar [%]", "seconds", "passes"], rows)


# Elements that meet the ends of the load, graded from there to the clamps.
BREAKS = ("10, 30, 100, 400, 2000, 2400, 2470, 2490, 2495, 2505, 2510, 2530, 2600, "
          "3000, 4600, 4900, 4970, 4990")
ELEMENTS = [2, 2, 2, 2, 2, 2, 2, 2, 1, 2, 1, 2, 2, 2, 2, 2, 2, 2, 2]


def indentation():
    """doc/verification/tolerance-runs.md: a beam of 5 m, loaded over 10 mm."""
    scene = ROOT / "tests/scenes/indented_beam.prm"
    goals = ["middle: uz", "below: szz", "outer: syy"]

    def by_hand(theory, factor):
        elements = ", ".join(str(factor * n) for n in ELEMENTS)
        return [f"Theory={theory}", *kinematics(["beam"], "Axis breaks", BREAKS),
                *kinematics(["beam"], "Axis elements", elements)]

    true = BarRun(scene, by_hand("LE-6", 1))
    rows = []
    for name, overrides in (
            ("Tolerance = 1", ["Goals/Tolerance=1",
                               "Goals/Quantities=" + " | ".join(goals)]),
            ("LE-3, axis graded by hand", by_hand("LE-3", 1)),
            ("LE-3, twice as many", by_hand("LE-3", 2)),
            ("LE-3, auto", ["Theory=LE-3"]),
            ("LE-3, 100 equal elements",
             ["Theory=LE-3", *kinematics(["beam"], "Axis elements", "100")]),
            ("LE-3, 250 equal elements",
             ["Theory=LE-3", *kinematics(["beam"], "Axis elements", "250")])):
        run = Timed(scene, overrides)
        print(name, run.failure, file=sys.stderr)
        if run.failure:
            rows.append([name, run.failure[:60]] + 4 * [""])
            continue
        rows.append([name, run.summary["dofs"], f"{run.seconds:.1f}"] + [
            f"{100 * (run.value(goal) / true.value(goal) - 1):.2g}" for goal in goals])
    table(["model", "DoFs", "seconds"] + [f"{goal}, %" for goal in goals], rows)


def c3d20r():
    """doc/verification/tolerance-runs.md: runs to 1 % beside meshes of C3D20R, whole scenes, taking turns;
    errors are those to the converged values of doc/verification/sandwich.md and the like."""
    from functools import partial
    from benchmark_calculix import OURS, STIFFNESS, THEIRS, Variant, section
    from benchmark_scenes import LAMINATED, SANDWICH
    from peers import MISSING, find_ccx, lamella_run, peer_run
    if find_ccx() is None:
        print(MISSING + "\n")
        return
    for name, scene in (("laminated_beams", LAMINATED), ("sandwich", SANDWICH)):
        solve = partial(peer_run, contact_stiffness=STIFFNESS[name])
        ours = [Variant(scene, "Lamella", *OURS[name][-1], lamella_run)]
        theirs = [Variant(scene, "C3D20R", *mesh, solve) for mesh in THEIRS[name]]
        print("\n\n".join(section(scene, ours, theirs)[0]), flush=True)
