# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paper's three scenes as scripts/benchmark runs them: meshes, the paper's seconds
and the converged values that errors are taken against."""

from dataclasses import dataclass

from measure_tools import axis


@dataclass
class Quantity:
    """A result: of a probe a column, of a support or a contact a component."""
    name: str
    kind: str
    of: str
    which: object
    converged: float
    #: The table's unit over the scene's.
    scale: float = 1.

    def value(self, run):
        """Of a run with probes, supports and contacts."""
        return self.scale * float(getattr(run, self.kind)[self.of][self.which])

    def error(self, run):
        return abs(self.value(run) / self.converged - 1)


@dataclass
class Scene:
    file: str
    title: str
    #: The mesh of the paper, the contact that comes closest to it, tiny meshes.
    mesh: list
    contact: list
    tiny: list
    #: Of the paper's CUF run, and its DoFs.
    seconds: float
    dofs: int
    quantities: list


def beam(elements, breaks=""):
    return [f"Body beam/Kinematics/Axis elements={elements}",
            f"Body beam/Kinematics/Axis breaks={breaks}"]


# Converged: CalculiX 2.20, C3D20R, mesh series until nothing moves (linear
# kinematics, frictionless); doc/verification/hertz.md, doc/verification/laminated-beams.md, doc/verification/sandwich.md.
HERTZ = Scene(
    "hertz.prm", "Two cylinders (Sec. 4.1)",
    ["Section half/Sectors=16", "Section half/Finest cell=8"] + axis(1),
    ["Contact nip/Discretization=node to node", "Contact nip/Enforcement=penalty",
     "Contact nip/Search distance=auto"],
    ["Section half/Sectors=8", "Section half/Finest cell=1"] + axis(1),
    296, 13176,
    [Quantity("force", "supports", "press", 2, -0.3241),
     Quantity("sigma_zz", "probes", "lower_center", "szz", -1.728)])
LAMINATED = Scene(
    "laminated_beams.prm", "Two laminated beams (Sec. 4.2)",
    [], [], ["Section strip/Cells across=2"] + axis(4),
    227, 23058,
    [Quantity("force [N]", "supports", "press", 2, -172.461),
     Quantity("contact force [N]", "contacts", "middle", 2, -43.111),
     Quantity("u_z [mm]", "probes", "upper_top", "uz", -134.3571, 1e3),
     Quantity("u_y [mm]", "probes", "upper_top", "uy", 0.215696, 1e3),
     Quantity("sigma_yy [MPa]", "probes", "upper_top", "syy", -133.82, 1e-6)])
SANDWICH = Scene(
    "sandwich.prm", "A sandwich under a roller (Sec. 4.3)",
    ["Section sandwich/Cells per ply=1,1,1,2,1,1,1"] + beam(10),
    ["Contact indentation/Discretization=node to surface",
     "Contact indentation/Enforcement=penalty"],
    ["Section sandwich/Cells per ply=1", "Section sandwich/Cells across=2",
     "Contact indentation/Search distance=auto"] + beam(4),
    279, 14229,
    [Quantity("force [N]", "contacts", "indentation", 2, 754.5),
     Quantity("u_y [mm]", "probes", "quarter", "uy", 0.05529),
     Quantity("sigma_yy [MPa]", "probes", "bottom", "syy", 32.08),
     Quantity("sigma_yy at 150 [MPa]", "probes", "tension", "syy", 2.543),
     Quantity("sigma_yz at 150 [MPa]", "probes", "core", "syz", -0.2278)])
SCENES = {"hertz": HERTZ, "laminated_beams": LAMINATED, "sandwich": SANDWICH}
