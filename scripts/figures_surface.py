# SPDX-License-Identifier: LGPL-2.1-or-later
"""The outer surface of the bodies from the last step's VTU, or that of a mode, for
scripts/plot: where it was, how it has moved, and the stresses on it."""

import struct
import xml.etree.ElementTree as ElementTree
import zlib
from dataclasses import dataclass

import numpy as np

from figures_data import STRESSES

TYPES = {"Float32": "<f4", "Int32": "<i4", "UInt8": "<u1"}
CORNER = 0.8  # cosine between sides that meet at an edge worth a line
MOST_FACES = 200000  # a picture of more takes minutes
FINE = 40000  # facets that show no steps
MOST_STEPS = 64  # into which one side is divided


@dataclass
class Surface:
    """Quadrilaterals: their corners (count, 4, 3) as they were, how these have moved,
    stresses there (count, 4, 6) in the scene's axes, or None, and of each its body and
    its ply (0 where the file does not say)."""

    places: np.ndarray
    moved: np.ndarray
    stresses: np.ndarray
    bodies: np.ndarray
    plies: np.ndarray

    def __len__(self):
        return len(self.places)

    def stress(self, name):
        return self.stresses[:, :, STRESSES.index(name)]


# ---- reading


def arrays_of(path, wanted):
    """Of a VTU file with raw appended arrays those with names that are wanted, and how
    many cells it has."""
    head, _, data = path.read_bytes().partition(b'<AppendedData encoding="raw">\n_')
    piece = ElementTree.fromstring(head + b"</VTKFile>").find(".//Piece")
    return {array.get("Name"): decode(data, int(array.get("offset")),
                                      TYPES[array.get("type")])
            for array in piece.iter("DataArray") if array.get("Name") in wanted
            }, int(piece.get("NumberOfCells"))


def decode(data, offset, kind):
    """The numbers of an array in blocks of zlib."""
    n_blocks, = struct.unpack_from("<I", data, offset)
    begin, blocks = offset + 4 * (3 + n_blocks), []
    for size in struct.unpack_from(f"<{n_blocks}I", data, offset + 12):
        blocks.append(zlib.decompress(data[begin:begin + size]))
        begin += size
    return np.frombuffer(b"".join(blocks), kind)


def datasets(collection):
    """(time, path) of the files that a PVD file lists; none without the file."""
    return [(float(entry.get("timestep")), collection.parent / entry.get("file"))
            for entry in ElementTree.parse(collection).iter("DataSet")
            ] if collection.exists() else []


def parts_of(path):
    """The VTU files of a dataset: one, or one per process."""
    if path.suffix == ".pvtu":
        return [path.parent / piece.get("Source")
                for piece in ElementTree.parse(path).iter("Piece")]
    return [path]


def blocks(path):
    """(fields, bodies, plies) of the cells of equal degrees. Fields are positions,
    displacements and, where the file has them, stresses, on each cell's grid:
    (cells, n, n, n, 6 or 12), the n of any two directions may differ."""
    arrays, n_cells = arrays_of(path, ("points", "displacement", "body", "ply", "offsets",
                                       "HigherOrderDegrees", *STRESSES))
    if n_cells == 0:
        return
    points = arrays["points"].reshape(-1, 3).astype(float)
    moved = arrays["displacement"].reshape(-1, 3).astype(float)
    fields = np.column_stack([points - moved, moved] + [
        arrays[name] for name in STRESSES if name in arrays])
    plies = arrays.get("ply", np.zeros(n_cells))
    degrees = arrays["HigherOrderDegrees"].reshape(-1, 3).astype(int)
    ends = arrays["offsets"]
    # Points stand cell by cell, those of a cell along the axis, across, and upwards.
    for kind in np.unique(degrees, axis=0):
        mask = np.all(degrees == kind, axis=1)
        n = kind + 1
        index = (ends[mask] - n.prod())[:, None] + np.arange(n.prod())
        yield (fields[index].reshape(mask.sum(), n[2], n[0], n[1], -1),
               arrays["body"][mask].astype(int), plies[mask].astype(int))


# ---- the outer surface


def faces_of(cells):
    """The sides of each cell of (cells, n, n, n, fields), three times two of
    (cells, n, n, fields)."""
    return [cells[:, 0], cells[:, -1], cells[:, :, 0], cells[:, :, -1],
            cells[:, :, :, 0], cells[:, :, :, -1]]


def surface_of(results):
    """Read once for all figures."""
    if not hasattr(results, "surface"):
        last = datasets(results.folder / "solution.pvd")[-1:]
        results.surface = outer_surface([part for _, path in last for part in parts_of(path)])
    return results.surface


def outer_surface(files):
    """The sides that belong to one cell of a body only; None without any."""
    sides, owners = [], []
    for path in files:
        for fields, body, ply in blocks(path):
            for side in faces_of(fields):
                sides.append(side)
                owners.append(np.column_stack([body, ply]))
    if not sides:
        return None
    size = max(np.abs(side[..., :3]).max() for side in sides)
    corners = np.concatenate([
        side[:, ::side.shape[1] - 1, ::side.shape[2] - 1, :3].reshape(-1, 4, 3)
        for side in sides])
    middles = np.round(corners.mean(axis=1) / size, 5)
    keys = np.column_stack([np.concatenate(owners)[:, 0], middles])
    _, inverse, counts = np.unique(keys, axis=0, return_inverse=True,
                                   return_counts=True)
    outside = counts[inverse.ravel()] == 1
    pieces, begin = [], 0
    for side, owner in zip(sides, owners):
        mask = outside[begin:begin + len(side)]
        begin += len(side)
        pieces.append((quadrilaterals(side[mask]),
                       np.repeat(owner[mask], (side.shape[1] - 1) * (side.shape[2] - 1),
                                 axis=0)))
    fields, owner = (np.concatenate(part) for part in zip(*pieces))
    return Surface(fields[..., :3], fields[..., 3:6],
                   fields[..., 6:] if fields.shape[2] == 12 else None, *owner.T)


def quadrilaterals(faces):
    """Those between neighboring points of (faces, n, m, fields)."""
    quads = np.stack([faces[:, :-1, :-1], faces[:, 1:, :-1], faces[:, 1:, 1:],
                      faces[:, :-1, 1:]], axis=3)
    return quads.reshape(-1, 4, faces.shape[3])


def edges_of_bodies(places, bodies):
    """(quadrilateral, its corner where the edge begins), an edge a row: where sides
    meet at an angle."""
    normals = np.cross(places[:, 2] - places[:, 0], places[:, 3] - places[:, 1])
    normals /= np.linalg.norm(normals, axis=1)[:, None] + 1e-300
    middles = 0.5 * (places + np.roll(places, -1, axis=1))
    keys = np.column_stack([np.repeat(bodies, 4), np.round(
        middles.reshape(-1, 3) / np.abs(places).max(), 5)])
    _, edge = np.unique(keys, axis=0, return_inverse=True)
    order = np.argsort(edge.ravel(), kind="stable")
    first, second = order[:-1], order[1:]
    pairs = edge.ravel()[first] == edge.ravel()[second]
    first, second = first[pairs], second[pairs]
    cosine = np.abs(np.sum(normals[first // 4] * normals[second // 4], axis=1))
    return np.column_stack([first // 4, first % 4])[cosine < CORNER]


# ---- smooth


def continuous(surface, values):
    """(count, 4) values at corners, where elements of one ply meet their mean, as in
    the tables; different plies keep their own."""
    size = np.abs(surface.places).max()
    keys = np.column_stack([
        np.repeat(np.column_stack([surface.bodies, surface.plies]), 4, axis=0),
        np.round(surface.places.reshape(-1, 3) / size * 1e5)]).astype(np.int64)
    # One number for each key; that two keys get the same is as good as impossible.
    mixed = keys @ np.array([0x9E3779B97F4A7C15, 0xC2B2AE3D27D4EB4F, 0x165667B19E3779F9,
                             0x27D4EB2F165667C5, 0x85EBCA77C2B2AE63],
                            np.uint64).astype(np.int64)
    _, where = np.unique(mixed, return_inverse=True)
    sums = np.bincount(where.ravel(), values.ravel())
    return (sums / np.bincount(where.ravel()))[where].reshape(values.shape)


def fine_facets(corners, count=FINE):
    """(count, 4, fields), of which the first two are places in the picture: divided
    bilinearly, so often in each direction that no facet is large in the picture."""
    reach = np.linalg.norm(corners[:, :, :2] - np.roll(corners[:, :, :2], -1, axis=1),
                           axis=2)
    reach = np.maximum(reach[:, :2], reach[:, 2:])
    size = np.sqrt(reach.prod(axis=1).sum() / count) or 1.
    steps = np.clip(np.ceil(reach / size), 1, MOST_STEPS).astype(int)
    kinds, kind = np.unique(steps, axis=0, return_inverse=True)
    return np.concatenate([divided(corners[kind.ravel() == k], *pair)
                           for k, pair in enumerate(kinds)])


def divided(corners, across, up):
    """Each into across x up of them."""
    s, t = np.meshgrid(np.linspace(0., 1., across + 1), np.linspace(0., 1., up + 1),
                       indexing="ij")
    weights = np.stack([(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t], axis=-1)
    return quadrilaterals(np.einsum("ijc,ncf->nijf", weights, corners))
