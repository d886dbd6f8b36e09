# SPDX-License-Identifier: LGPL-2.1-or-later
"""The scenes of scripts/measure bars: name, scene, goals, theories, and what makes a truth that
is richer in every source than what it judges."""

from measure_fields import laminate, materials_of
from measure_tools import ROOT

ISOTROPIC = {"Width": 1., "Layup": "0", "Ply thickness": 1.,
             "Ply materials": "aluminium", "Cells per ply": 4, "Cells across": 4}
ALUMINIUM = {"Isotropic": "70000, 0.3"}


def cantilever(section, length):
    """Clamped at its start, a force over its end; deflection of the tip, stresses at a
    third of the length at the top and inside."""
    width = section["Width"]
    x = 0.3 * width
    return {
        "Title": "Cantilever", "Units": "mm, N", **materials_of(section),
        "Section strip": section,
        "Body beam": {"Section": "strip", "Length": length,
                      "Kinematics": {"Axis elements": "auto"}},
        "Support clamp": {"On": "beam: start"},
        "Load tip": {"On": "beam: end", "Force": f"0, 0, {1e-3 / length ** 2}"},
        "Probe tip": {"At": f"beam: {width / 2}, {length}, 0.5"},
        "Probe third": {"At": f"beam: {x}, {length / 3}, 0.9"},
        "Probe inside": {"At": f"beam: {x}, {length / 3}, 0.45"}}


TIP = ["tip: uz", "third: syy", "inside: syz"]


def cantilevers():
    layups = (("square", ISOTROPIC), ("[0/90/0]", laminate("0/90/0")),
              ("[45/-45/0]", laminate("45/-45/0")))
    for name, section in layups:
        for slenderness in (5, 20, 100, 1000, 10000):
            theories = ["EBBT", "TE-3", "LE-1", "LE-2", "LE-3", "SV", "SV-6"]
            if slenderness <= 20:
                theories += ["LE-4", "solid-1"]
            # Finer elements than these at a clamp, a hair of 1e4 heights long, are
            # beyond double precision.
            finer = "auto" if slenderness > 1000 else "auto 2"
            yield (f"{name}, L/h = {slenderness}", cantilever(section, slenderness),
                   TIP, theories,
                   ["Theory=LE-6" if slenderness <= 20 else "Theory=LE-5",
                    f"Body beam/Kinematics/Axis elements={finer}"])


def pagano(slenderness):
    """Half of a [0/90/0] strip in cylindrical bending, as in tutorials/step-2, where the
    exact solution is known; @p slenderness is span over height."""
    length = 1.5 * slenderness
    graphite = "175000, 7000, 7000, 3500, 3500, 1400, 0.25, 0.25, 0.25"
    return {
        "Title": "Cylindrical bending", "Units": "mm, N",
        "Material graphite": {"Engineering constants": graphite},
        "Section strip": {"Width": 1, "Layup": "0/90/0", "Ply thickness": 1},
        "Body half": {"Section": "strip", "Length": length,
                      "Kinematics": {"Axis elements": 6}},
        "Support plane_strain": {"On": "half: body", "u": "0, free, free"},
        "Support bearing": {"On": "half: start", "u": "free, free, 0"},
        "Support symmetry": {"On": "half: end", "u": "free, 0, free"},
        "Load pull": {"On": "half: top",
                      "Pressure": f"{-36. / slenderness ** 2} * sin(pi*y/{2 * length})"},
        "Probe deflection": {"At": f"half: 0.5, {length}, 1.5"},
        "Probe top": {"At": f"half: 0.5, {length}, 3"},
        "Probe shear": {"At": "half: 0.5, 0, 1.5"}}


def paganos():
    for slenderness in (4, 10, 50):
        yield (f"Pagano [0/90/0], L/h = {slenderness}", pagano(slenderness),
               ["deflection: uz", "top: syy", "shear: syz"],
               ["EBBT", "TE-3", "TE-5", "LE-1", "LE-2", "LE-3", "LE-4", "solid-1", "solid-2"],
               ["Theory=LE-6", "Body half/Kinematics/Axis elements=24"])


def shipped():
    sandwich = ROOT / "prm/sandwich.prm"
    yield ("sandwich", sandwich,
           ["indentation: fz", "quarter: uy", "bottom: syy", "bottom: uz", "core: syz",
            "tension: syy"],
           ["EBBT", "TE-4", "TE-8", "LE-1", "LE-2", "LE-3", "SV", "SV-6", "solid-1"],
           ["Theory=LE-4", "Body beam/Kinematics/Axis breaks=",
            "Body beam/Kinematics/Axis elements=auto 2"])
    beams = ROOT / "prm/laminated_beams.prm"
    finer = [f"Body {body}/Kinematics/Axis elements=60" for body in ("upper", "lower")]
    # The contact is node to node by penalty: the truth has no penetration.
    yield ("laminated beams", beams,
           ["upper_top: uz", "lower_top: uz", "upper_top: syy", "middle: fz"],
           ["EBBT", "TE-2", "TE-4", "LE-1", "LE-2", "LE-3"],
           ["Theory=LE-4", "Contact middle/Enforcement=exact"] + finer)
    yield ("double-T, twisted", ROOT / "tests/scenes/double_t.prm",
           ["middle: uz", "edge: uz", "root: syy"],
           ["EBBT", "TE-3", "TE-6", "LE-1", "LE-2", "LE-3", "LE-4", "SV", "SV-6", "solid-1"],
           ["Theory=LE-6", "Body beam/Kinematics/Axis breaks=",
            "Body beam/Kinematics/Axis elements=auto 2"])
    yield ("coupon", ROOT / "prm/flexure_test.prm",
           ["c_nose: fz", "middle: uz", "outer: syy", "core: syz", "below: szz"],
           ["TE-4", "SV", "SV-6"],
           ["Theory=SV-14", "Section laminate/Cells across=8",
            "Body coupon/Kinematics/Axis elements=4, 8, 16, 8, 16, 8, 4"])
    crossed = ROOT / "tests/scenes/crossed_beams.prm"
    lengths = [f"Body {body}/Kinematics/Axis elements=8, 12, 8" for body in ("upper", "lower")]
    yield ("crossed beams", crossed, ["press: fz", "cross: fz"],
           ["EBBT", "TE-2", "LE-1", "LE-2", "LE-3", "LE-4", "SV-6"], ["Theory=LE-5"] + lengths)
    strip = ROOT / "prm/hertz_plane_strain.prm"
    yield ("Hertz, plane strain", strip, None, ["LE-1", "LE-2", "LE-3"],
           ["Theory=LE-5", "Section half/Finest cell=0.015"])


# Scenes that no rule was fitted to.

def twisted(title, material, section, width, length, probes):
    """A tube of @p width, clamped at its start, bent and twisted by a force over its end."""
    (name, entries), = section.items()
    return {
        "Title": title, "Units": "mm, N", "Material carbon": material,
        f"Section {name}": entries,
        "Body tube": {"Section": name, "Length": length,
                      "Kinematics": {"Axis elements": "auto"}},
        "Support clamp": {"On": "tube: start"},
        "Load tip": {"On": "tube: end", "Force": f"0, 0, -0.01*(1+x/{width})"},
        **{f"Probe {probe}": {"At": f"tube: {at}"} for probe, at in probes.items()}}


def hexagon():
    """One that Gmsh has meshed."""
    return twisted("Hexagon", ALUMINIUM,
                   {"hexagon": {"Shape": "file", "File": ROOT / "prm/sections/hexagon.msh"}},
                   20, 100, {"tip": "19, 100, 0", "top": "10, 50, 8.66025",
                             "side": "19, 30, 0"})


def tube():
    """One of carbon, wound at 0/45/-45."""
    return twisted("Tube", {"Library": "IM7-8552"},
                   {"tube": {"Shape": "tube", "Width": 40, "Height": 40, "Wall thickness": 3,
                             "Wall layup": "0/45/-45", "Material": "carbon"}},
                   40, 200, {"tip": "39, 200, 20", "top": "20, 100, 39.5",
                             "side": "39.5, 60, 20"})


def leaves():
    """Two strips of glass, clamped together; the longer one presses the shorter down."""
    return {
        "Title": "Two leaves", "Units": "mm, N",
        "Material glass": {"Engineering constants":
                           "39000, 8600, 8600, 3800, 3800, 3000, 0.28, 0.28, 0.43"},
        "Section leaf": {"Width": 20, "Layup": "0", "Ply thickness": 5,
                         "Ply materials": "glass", "Cells per ply": 2, "Cells across": 2},
        "Body lower": {"Section": "leaf", "Length": 80, "Kinematics": {"Axis elements": 10}},
        "Body upper": {"Section": "leaf", "Length": 120, "Origin": "0, 0, 5",
                       "Kinematics": {"Axis breaks": 80, "Axis elements": "10, 6"}},
        "Support clamp": {"On": "lower: start; upper: start"},
        "Load tip": {"On": "upper: end", "Force": "0, 0, -0.5"},
        "Contact between": {"First": "upper: bottom", "Second": "lower: top",
                            "Discretization": "surface to surface", "Enforcement": "exact"},
        "Probe tip": {"At": "upper: 10, 120, 7.5"}, "Probe top": {"At": "upper: 10, 40, 10"},
        "Probe end": {"At": "lower: 10, 80, 2.5"}}


def hot_laminate():
    """A laminate that is warmer above, clamped at one end."""
    return {
        "Title": "Warm laminate", "Units": "mm, N",
        "Material carbon": {"Library": "IM7-8552",
                            "Thermal expansion": "-0.5e-6, 30e-6, 30e-6"},
        "Section strip": {**laminate("0/90/90"), "Cells per ply": 1},
        "Body beam": {"Section": "strip", "Length": 12,
                      "Kinematics": {"Axis elements": "auto"}},
        "Support clamp": {"On": "beam: start"},
        "Load warm": {"On": "beam: body", "Temperature": "50 + 40*z"},
        "Probe tip": {"At": "beam: 1, 12, 0.5"}, "Probe third": {"At": "beam: 0.6, 5, 0.9"},
        "Probe inside": {"At": "beam: 1, 5, 0.2"}}


def plate():
    """A strip as wide as long, clamped at both ends, a pressure on it that varies across."""
    return {
        "Title": "Plate", "Units": "mm, N", "Material carbon": {"Library": "IM7-8552"},
        "Section plate": laminate("0/90/0", width=20., across=6),
        "Body plate": {"Section": "plate", "Length": 20,
                       "Kinematics": {"Axis elements": "auto"}},
        "Support clamps": {"On": "plate: ends"},
        "Load press": {"On": "plate: top", "Pressure": "0.01*(1+0.05*x)"},
        "Probe middle": {"At": "plate: 10, 10, 0.5"}, "Probe above": {"At": "plate: 6, 10, 0.95"},
        "Probe shear": {"At": "plate: 10, 5, 0.5"}}


def patch():
    """A strip in plane strain on a floor that holds it, pressed by a smooth hill."""
    return {
        "Title": "Strip under a hill", "Units": "mm, N", "Material aluminium": ALUMINIUM,
        "Section strip": {"Width": 1, "Layup": "0", "Ply thickness": 2.,
                          "Ply materials": "aluminium", "Cells per ply": 4},
        "Body strip": {"Section": "strip", "Length": 10,
                       "Kinematics": {"Axis elements": 10}},
        "Support plane": {"On": "strip: body", "u": "0, free, free"},
        "Support floor": {"On": "strip: bottom", "u": "free, free, 0"},
        "Support end": {"On": "strip: start", "u": "free, 0, free"},
        "Load hill": {"On": "strip: top", "Pressure": "exp(-(y-5)*(y-5)/2)"},
        "Probe top": {"At": "strip: 0.5, 5, 2"}, "Probe inside": {"At": "strip: 0.5, 5, 1.1"},
        "Probe beside": {"At": "strip: 0.5, 3.8, 1.3"}}


def unseen():
    beams = ["EBBT", "TE-3", "LE-1", "LE-2", "LE-3", "LE-4", "SV", "SV-6"]
    layers = ["LE-1", "LE-2", "LE-3", "LE-4"]
    finer = "Kinematics/Axis elements=auto 2"
    yield ("hexagon, by Gmsh", hexagon(), ["tip: uz", "top: syy", "side: syz"], beams,
           ["Theory=LE-5", f"Body tube/{finer}"])
    yield ("tube of carbon", tube(), ["tip: uz", "top: syy", "side: syz"], beams,
           ["Theory=LE-5", f"Body tube/{finer}"])
    yield ("two leaves", leaves(), ["tip: uz", "top: syy", "end: uz"], ["TE-3", *layers],
           ["Theory=LE-5", "Body lower/Kinematics/Axis elements=24",
            "Body upper/Kinematics/Axis elements=24, 14"])
    yield ("warm laminate", hot_laminate(), ["tip: uz", "third: syy", "inside: syy"], beams,
           ["Theory=LE-6", f"Body beam/{finer}"])
    yield ("plate", plate(), ["middle: uz", "above: syy", "shear: syz"], layers,
           ["Theory=LE-6", f"Body plate/{finer}"])
    yield ("strip under a hill, plane strain", patch(),
           ["top: uz", "inside: szz", "beside: syz"], ["TE-3", "TE-5", *layers],
           ["Theory=LE-7", "Body strip/Kinematics/Axis elements=40"])


def singular():
    """Stresses without a limit, that no bar can be of: name, scene, goals, theories."""
    theories = ["LE-2", "LE-3", "LE-4", "SV-6"]
    for name, section in (("square", ISOTROPIC), ("[0/90/0]", laminate("0/90/0"))):
        scene = cantilever(section, 5)
        scene["Probe edge"] = {"At": f"beam: {section['Width'] / 2}, 0, 1"}
        scene["Probe corner"] = {"At": f"beam: {section['Width']}, 0, 1"}
        yield (f"edge of a clamp, {name}", scene, ["edge: syy", "corner: szz"], theories)
    carbon = {"Library": "IM7-8552"}
    angle = {"angle": {"Shape": "angle", "Width": 20, "Height": 20, "Wall thickness": 4}}
    yield ("corner of an angle, twisted",
           twisted("Angle", carbon, angle, 20, 200, {"corner": "4, 100, 4"}),
           ["corner: sxy", "corner: syz"], theories)
    scene = cantilever(laminate("45/-45"), 10)
    scene["Probe edge"] = {"At": f"beam: 0, 5, 0.5"}
    yield ("free edge, [45/-45]", scene, ["edge/1: syy", "edge/2: sxy"], theories)
    scene = leaves()
    scene["Probe edge"] = {"At": "upper: 10, 80, 5"}
    yield ("where a leaf ends on another", scene, ["edge: szz", "edge: syz"], theories[:3])
    scene = cantilever(ISOTROPIC, 10)
    scene["Load tip"] = {"On": "beam: line", "At": "0, 5, 1; 1, 5, 1", "Force": "0, 0, -1e-3"}
    scene["Probe below"] = {"At": "beam: 0.5, 5, 1"}
    yield ("line load", scene, ["below: szz", "below: syy"], theories)
