# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paper's Tables 1, 2, 4, 5, 6, 8 and 9 with our rows; see scripts/benchmark."""

from benchmark_scenes import HERTZ, LAMINATED, SANDWICH
from benchmark_tools import best, number, off, table, wanted

# As printed: model, discretization, DoFs, seconds.
TABLE_1 = [("ABQ - Coarse", "1,000 C3D8R", 8445, 11),
           ("ABQ - Medium", "6,000 C3D8R", 44583, 76),
           ("ABQ - Refined", "32,000 C3D8R", 218559, 719),
           ("CUF - 1D", "1 B4 - 128 L9", 13176, 296)]
TABLE_4 = [("ABQ - Coarse", "6,000 C3D8R, 1 element per ply", 51597, 57),
           ("ABQ - Medium", "14,400 C3D8R, 2 elements per ply", 107541, 191),
           ("ABQ - Refined", "43,200 C3D8R, 3 elements per ply", 301041, 785),
           ("ABQ - Quadratic", "6,000 C3D20R, 1 element per ply", 189945, 436),
           ("CUF LW", "20 B4 - 12 L9", 23058, 227)]
TABLE_8 = [("ABQ3D - Coarse", "11,200 C3D8R, 1 element per ply", 45408, 40),
           ("ABQ3D - Medium", "44,800 C3D8R, 2 elements per ply", 153300, 320),
           ("ABQ3D - Refined", "80,000 C3D8R, 4 elements per ply", 261675, 832),
           ("ABQ3D - Quadratic", "14,000 C3D20R, 1 element per ply", 201504, 396),
           ("CUF LW", "10 B4 - 32 L9, 1 element per ply", 14229, 279)]
# Model, sigma_zz.
TABLE_2 = [("ABQ - Coarse", -0.49371), ("ABQ - Medium", -0.96185),
           ("ABQ - Refined", -1.42374), ("CUF - 1D", -1.47791),
           ("Hertz - Analytical", -1.68676)]
# Model, u_y, u_z, sigma_yy.
TABLE_5 = [("ABQ - Coarse", 0.2156, -134.340, -89.1),
           ("ABQ - Medium", 0.2159, -134.363, -111.7),
           ("ABQ - Refined", 0.2158, -134.353, -119.1),
           ("ABQ - Quad", 0.2156, -134.316, -133.7),
           ("EBBT", 0.2159, -134.395, -126.4), ("TBT", 0.2159, -134.395, -126.4),
           ("CUF LW", 0.2157, -134.335, -126.6)]
TABLE_6 = [("ABQ - Coarse", 7.188, -44.761, -29.7),
           ("ABQ - Medium", 7.193, -44.779, -37.2),
           ("ABQ - Fine", 7.193, -44.776, -39.7),
           ("ABQ - Quad", 7.186, -44.765, -44.5),
           ("EBBT", 7.198, -44.798, -42.1), ("TBT", 7.198, -44.798, -42.1),
           ("CUF LW", 7.190, -44.778, -42.2)]
# Model, u_y, sigma_zz, sigma_yy(z = 0).
TABLE_9 = [("ABQ3D - Coarse", 0.0527, -1.17, 23.8),
           ("ABQ3D - Medium", 0.0530, -1.28, 27.1),
           ("ABQ3D - Refined", 0.0531, -1.34, 28.9),
           ("ABQ3D - Quad", 0.0531, -1.35, 30.7), ("CUF LW", 0.0553, -1.33, 31.1)]

ODD_HERTZ = """\
*Odd in the paper.* "Hertz - Analytical" is sqrt(F' E* / (pi R*)) of the force 0.3254
of bodies with free end faces; there the pressure varies along y, and the center
carries 2.5 % more than this two-dimensional value. The other stresses are
element-center or quadrature-point values on meshes that do not resolve the half
width of 0.123."""
ODD_LAMINATED = """\
*Odd in the paper.* The stresses of C3D8R are element-center values: 2/3, 5/6 and 8/9
of the surface's. Those of EBBT, TBT and CUF fit a quadrature point (0.925 of the
height, y = 0.80694), where a right code gives -126.5: ours is shown there, too. Table
6 heads u_y with "x 10^3"; 7.19 is 0.0719 mm. "21x fewer degrees of freedom and 6x
less time" does not follow from Table 4. Displacements are nearly pure kinematics and
hold for any stiffness."""
ODD_SANDWICH = """\
*Odd in the paper.* The u_y of the ABAQUS models is 4 % low, that of CUF right. The
values 23.8, 27.1 and 28.9 of sigma_yy(z = 0) are element-center values on their way
to the surface's. sigma_zz has no stated point, and below the roller it falls from a
spike of -72 MPa at z = 36 to -0.44 in the core: no single point gives -1.35 on a
converged mesh. Ours, and the converged one, are at z = 34, ours from below and from
above that interface. Neither radius nor material of the roller is given; here
R = 10 mm, rigid."""


def variants(scene, bench):
    """Name -> fastest run: the paper's mesh in two ways, and the shipped one."""
    times = bench.times(3)
    if bench.reduced:
        return {"Lamella, tiny": best(scene.file, scene.tiny, times)}
    runs = {}
    if scene.contact:
        runs["Lamella, the paper's mesh and contact at nodes"] = \
            best(scene.file, scene.mesh + scene.contact, times)
        runs["Lamella, the paper's mesh"] = best(scene.file, scene.mesh, times)
        runs["Lamella, as shipped"] = best(scene.file, [], times)
    else:
        runs["Lamella, the paper's mesh, as shipped"] = best(scene.file, [], times)
    return runs


def theories(scene, bench):
    """The classical theories on the laminated beams, too."""
    mesh = scene.tiny if bench.reduced else []
    return {f"Lamella, {theory}": best(scene.file, mesh + [f"Theory={theory}"],
                                       bench.times(3))
            for theory in ("EBBT", "TBT")}


def models(printed, runs, scene, meshes):
    """Table 1, 4 or 8: what each model has and took."""
    rows = [[name, what, f"{dofs:,}", seconds, "-"]
            for name, what, dofs, seconds in printed]
    rows += [[name, mesh, f"{run.summary['dofs']:,}", f"{run.wall:.2f}",
              f"1/{scene.seconds / run.wall:.0f}"]
             for (name, run), mesh in zip(runs.items(), meshes)]
    return table(["model", "discretization of a body", "DoFs", "time [s]",
                  f"of the paper's CUF, {scene.seconds} s"], rows)


def forces(scene, runs):
    """Ours beside the converged values, also where the paper has none."""
    rows = [[q.name, number(q.converged)] +
            [f"{number(q.value(run))} ({off(q.value(run), q.converged)})"
             for run in runs.values()] for q in scene.quantities]
    return table(["quantity", "C3D20R, converged"] + list(runs), rows)


def fast_enough(scene, runs):
    """The requirement on the first of the runs, which has the paper's mesh."""
    name, run = next(iter(runs.items()))
    return wanted(f"prm/{scene.file}, {name}, seconds over the paper's "
                  f"{scene.seconds} s", 0.01, run.wall / scene.seconds)


def hertz(bench):
    runs = variants(HERTZ, bench)
    meshes = ["1 B4 - 128 L9, node to node, penalty",
              "1 B4 - 128 L9, surface to surface, exact",
              "5 graded B4, cells of 0.02 at the contact"]
    if bench.reduced:
        meshes = ["1 B4, 8 sectors"]
    converged = HERTZ.quantities[1].converged
    values = TABLE_2 + [(name, HERTZ.quantities[1].value(run))
                        for name, run in runs.items()]
    values.append(("C3D20R, converged", converged))
    second = table(["model", "sigma_zz", "off converged"],
                   [[name, f"{value:.5f}", off(value, converged)]
                    for name, value in values])
    return [f"### {HERTZ.title}", "Table 1:", models(TABLE_1, runs, HERTZ, meshes),
            "Table 2, at [8, 0.5, 8]:", second, ODD_HERTZ,
            forces(HERTZ, runs)], [fast_enough(HERTZ, runs)]


def beam_table(printed, runs, body, scale, converged):
    """Table 5 or 6: u_y, u_z and sigma_yy of a beam, and at the Gauss point."""
    rows = [[name, uy, f"{uz:.3f}", syy, off(syy, converged[2]), "-"]
            for name, uy, uz, syy in printed]
    for name, run in runs.items():
        top, inside = run.probes[f"{body}_top"], run.probes[f"{body}_quadrature"]
        syy = 1e-6 * float(top["syy"])
        rows.append([name, f"{scale * float(top['uy']):.5g}",
                     f"{1e3 * float(top['uz']):.3f}", f"{syy:.2f}",
                     off(syy, converged[2]), f"{1e-6 * float(inside['syy']):.1f}"])
    rows.append(["C3D20R, converged", f"{converged[0]:.5g}", f"{converged[1]:.3f}",
                 f"{converged[2]:.2f}", off(1, 1), "-"])
    u_y = "u_y [mm]" if scale == 1e3 else 'u_y "x 10^3" [mm]'
    return table(["model", u_y, "u_z [mm]", "sigma_yy [MPa]", "off converged",
                  "at the Gauss point"], rows)


def laminated(bench):
    runs = variants(LAMINATED, bench) | theories(LAMINATED, bench)
    meshes = ["20 B4 - 12 L9", "20 B4", "20 B4"]
    if bench.reduced:
        meshes = ["4 B4 - 6 L9", "4 B4", "4 B4"]
    return [f"### {LAMINATED.title}", "Table 4:",
            models(TABLE_4, runs, LAMINATED, meshes),
            "Table 5, upper beam at [0.05, 0.8, 0.106]:",
            beam_table(TABLE_5, runs, "upper", 1e3, (0.215696, -134.3571, -133.82)),
            "Table 6, lower beam at [0.05, 0.8, 0.003]:",
            beam_table(TABLE_6, runs, "lower", 1e5, (7.1908, -44.7856, -44.62)),
            ODD_LAMINATED, forces(LAMINATED, runs)], [fast_enough(LAMINATED, runs)]


def sandwich(bench):
    runs = variants(SANDWICH, bench)
    meshes = ["10 B4 - 32 L9, node to surface, penalty",
              "10 B4 - 32 L9, surface to surface, exact",
              "18 graded B4 - 40 L9, surface to surface, exact"]
    if bench.reduced:
        meshes = ["4 B4 - 14 L9"]
    rows = [[name, f"{uy:.4f}", szz, f"{syy:.1f}", off(syy, 32.08)]
            for name, uy, szz, syy in TABLE_9]
    for name, run in runs.items():
        uy, syy = (float(run.probes[probe][column]) for probe, column in
                   (("quarter", "uy"), ("bottom", "syy")))
        # Two plies meet there.
        szz = " / ".join(f"{float(row['szz']):.2f}"
                         for row in run.lines["thickness_250"]
                         if abs(float(row["z"]) - 34) < 1e-6)
        rows.append([name, f"{uy:.5f}", szz, f"{syy:.2f}", off(syy, 32.08)])
    rows.append(["C3D20R, converged", "0.05529", "-2.6", "32.08", off(1, 1)])
    ninth = table(["model", "u_y [mm] (y = 125, z = 36)", "sigma_zz [MPa]",
                   "sigma_yy [MPa] (z = 0)", "off converged"], rows)
    return [f"### {SANDWICH.title}", "Table 8:",
            models(TABLE_8, runs, SANDWICH, meshes), "Table 9:", ninth, ODD_SANDWICH,
            forces(SANDWICH, runs)], [fast_enough(SANDWICH, runs)]


def paper(bench):
    """Rows of the paper as it prints them, ours below; the fastest of three."""
    blocks = ["The paper's rows as printed, ours below them: whole process, the "
              "fastest of three. Stresses of ours are at the named points, at "
              "surfaces on the surface. Where a mesh of the paper's is far coarser "
              "than the contact, `surface to surface` averages gaps over more than "
              "it, and rows at nodes come closer."]
    demands = []
    for scene in (hertz, laminated, sandwich):
        text, lines = scene(bench)
        blocks += text
        demands += lines
    return blocks + [demands]
