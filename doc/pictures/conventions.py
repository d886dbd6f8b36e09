#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws conventions.png: axes, ply angle, stress order and signs of contact.

Usage: scripts/python doc/pictures/conventions.py
"""

from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Arc, Polygon, Rectangle

BLUE, RED, GREEN, GREY = "#0072B2", "#D55E00", "#009E73", "0.45"
PLIES = ("0.93", "0.80", "0.93")

plt.rcParams.update({"font.size": 11, "figure.dpi": 150})


def arrow(axis, start, end, color="black", width=1.8):
    axis.annotate("", end, start, arrowprops=dict(
        arrowstyle="-|>,head_width=0.25,head_length=0.5", color=color,
        linewidth=width, shrinkA=0, shrinkB=0))


def panel(axis, title, x, y):
    axis.set_title(title, loc="left", fontsize=12, fontweight="bold")
    axis.set_xlim(*x)
    axis.set_ylim(*y)
    axis.set_aspect("equal", anchor="NW")
    axis.axis("off")


# Oblique, seen from the left, so that the edge from the origin along the axis is
# in sight: the axis runs backwards and to the left.
ALONG = np.array([-0.90, 0.32])


def oblique(x, y, z):
    return np.array([x, z]) + y * ALONG


def beam(axis):
    panel(axis, "A beam and its frame", (-6.8, 4.4), (-1.2, 4.6))
    width, length, ply = 2.4, 5.4, 0.44
    height = len(PLIES) * ply

    def face(points, color):
        axis.add_patch(Polygon([oblique(*p) for p in points], facecolor=color,
                               edgecolor="black", linewidth=0.9))

    face([(0, 0, height), (width, 0, height), (width, length, height),
          (0, length, height)], "white")
    for k, color in enumerate(PLIES):
        low, high = k * ply, (k + 1) * ply
        face([(0, 0, low), (0, length, low), (0, length, high), (0, 0, high)],
             color)
        face([(0, 0, low), (width, 0, low), (width, 0, high), (0, 0, high)], color)
        axis.text(*oblique(width / 2, 0, (low + high) / 2), f"ply {k + 1}",
                  ha="center", va="center", fontsize=10)
    axis.text(*oblique(width + 0.2, 0, 2.5 * ply), "plies from\nbottom to top",
              fontsize=10, va="center")

    origin = oblique(0, 0, 0)
    arrow(axis, origin, oblique(width + 0.8, 0, 0), RED, 2.2)
    axis.text(*oblique(width + 0.9, 0, 0), "x  width", color=RED, va="center")
    arrow(axis, origin, oblique(0, 0, height + 1.), GREEN, 2.2)
    axis.text(*oblique(0, 0, height + 1.1), "z  up", color=GREEN, ha="center",
              va="bottom")
    arrow(axis, origin, oblique(0, length + 0.9, 0), BLUE, 2.2)
    axis.text(*oblique(0, length + 0.95, 0), "y  axis", color=BLUE, ha="right",
              va="bottom")
    axis.plot(*origin, "o", color="black", markersize=7)
    axis.annotate("origin: the lower left corner of the section",
                  origin, (-5.6, -0.9), fontsize=10, va="center",
                  arrowprops=dict(arrowstyle="-", color=GREY, shrinkB=4,
                                  relpos=(0.9, 1)))


def ply_angle(axis):
    panel(axis, "Ply angle, seen from above", (-0.5, 4.9), (-0.95, 5.0))
    axis.add_patch(Rectangle((0, 0), 2.6, 3.6, facecolor="0.95", edgecolor="black",
                             linewidth=0.9))
    center, angle = np.array([1.3, 1.1]), np.radians(30)
    fiber = np.array([np.sin(angle), np.cos(angle)])
    clip = axis.patches[-1]
    for shift in np.arange(-3, 3.1, 0.34):
        start = center + shift * np.array([1, 0])
        line, = axis.plot(*zip(start - 6 * fiber, start + 6 * fiber), color="0.78",
                          linewidth=1.)
        line.set_clip_path(clip)
    axis.plot(*zip(center, center + (0, 2.2)), color=BLUE, linestyle="--",
              linewidth=1.3)
    arrow(axis, center, center + 2.2 * fiber, "black", 2.2)
    axis.add_patch(Arc(center, 2.6, 2.6, theta1=60, theta2=90, linewidth=1.5))
    axis.text(*(center + 1.55 * np.array([np.sin(angle / 2), np.cos(angle / 2)])),
              r"$\theta$", ha="center", va="center", fontsize=13)
    axis.text(2.75, 2.9, "fiber at\n$\\theta = +30°$", fontsize=10, va="center")
    arrow(axis, (0, 0), (0, 4.4), BLUE)
    axis.text(0, 4.5, "y", color=BLUE, ha="center", va="bottom")
    arrow(axis, (0, 0), (3.3, 0), RED)
    axis.text(3.4, 0, "x", color=RED, va="center")
    axis.text(-0.3, -0.7, "$\\theta = 0$ along +y, positive from +y towards +x",
              fontsize=10, va="center")


def stress_order(axis):
    panel(axis, "Order of stresses and strains", (0, 6.4), (-1.1, 3.1))
    order = ("xx", "yy", "zz", "xy", "xz", "yz")
    for k, pair in enumerate(order):
        axis.add_patch(Rectangle((k * 1.05 + 0.02, 1.75), 0.98, 0.85,
                                 facecolor="0.93", edgecolor="none"))
        axis.text(k * 1.05 + 0.51, 2.17, rf"$\sigma_{{{pair}}}$", ha="center",
                  va="center", fontsize=14)
    axis.text(0, 1.2, "strains likewise; shear strains are engineering ones,",
              fontsize=10, va="center")
    axis.text(0, 0.72, r"$\gamma_{yz} = \partial u_y/\partial z +"
              r" \partial u_z/\partial y$;  tension is positive", fontsize=10,
              va="center")
    axis.text(0, 0.1, "11, 22, 33, 12, 13, 23: the same order in ply axes", fontsize=10,
              va="center")
    axis.text(0, -0.38, r"$e_1 = (\sin\theta, \cos\theta, 0)$ along the fiber,"
              r" $e_3 = z$,", fontsize=10, va="center")
    axis.text(0, -0.86, r"$e_2 = e_3 \times e_1 = (-\cos\theta, \sin\theta, 0)$",
              fontsize=10, va="center")


def contact(axis):
    panel(axis, "Contact", (-0.05, 9.2), (0., 4.8))
    across = np.linspace(0, 5, 60)
    upper = 3.0 + 0.09 * (across - 2.5) ** 2
    lower = np.full_like(across, 1.35)
    axis.fill_between(across, upper, 4.6, color=PLIES[0], linewidth=0)
    axis.fill_between(across, 0.2, lower, color=PLIES[1], linewidth=0)
    axis.plot(across, upper, across, lower, color="black", linewidth=1.)
    axis.text(0.25, 4.25, "first body", fontsize=11, va="center")
    axis.text(0.25, 0.5, "second body", fontsize=11, va="center")
    first, second = np.array([2.5, 3.0]), np.array([2.5, 1.35])
    axis.plot(*first, "o", *second, "o", color="black", markersize=5)
    axis.text(2.65, 3.22, "$X_1$", va="center")
    axis.text(2.65, 1.08, "$X_2$", va="center")
    arrow(axis, first, first - (0, 0.95), BLUE, 2.2)
    axis.text(2.35, 2.3, "n", color=BLUE, ha="right", va="center", fontsize=13,
              fontweight="bold")
    arrow(axis, (4.1, 1.35), (4.1, 0.4), RED, 2.2)
    axis.text(4.22, 0.82, "f n", color=RED, va="center", fontsize=13)
    axis.annotate("", (3.35, 1.37), (3.35, 3.05), arrowprops=dict(
        arrowstyle="<->", color=GREY, shrinkA=0, shrinkB=0))
    axis.text(3.45, 2.2, "$g$", color="0.2", va="center", fontsize=13)
    notes = ("n: outward normal of the first body",
             "gap  $g = n \\cdot (u_2 - u_1) + g_{init}$",
             "open: $g > 0$;  closed: $g = 0$",
             "force f and pressure are",
             "positive in compression",
             "resultants are reported",
             "on the second body")
    for line, height in zip(notes, (4.3, 3.6, 2.9, 2.1, 1.6, 0.8, 0.3)):
        axis.text(5.3, height, line, fontsize=10, va="center")


def main():
    figure = plt.figure(figsize=(10.5, 7.4))
    beam(figure.add_axes((0.02, 0.50, 0.62, 0.45)))
    ply_angle(figure.add_axes((0.67, 0.47, 0.32, 0.48)))
    contact(figure.add_axes((0.02, 0.01, 0.60, 0.42)))
    stress_order(figure.add_axes((0.62, 0.05, 0.37, 0.38)))
    figure.savefig(Path(__file__).with_name("conventions.png"))


if __name__ == "__main__":
    main()
