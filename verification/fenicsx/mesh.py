"""Meshes of a quarter of the (r, z) plane: quadrilaterals, fine where an edge is or passes, and out to a thousand contacts.

        r ->   0        band         core            outer
    z   +------+||||||||||||+---+----+--------------+     surface: graded, uniform over the band, graded
    |   +------+||||||||||||+---+----+              |
    v   |      |||||||||||||    |    |   layers     |     depth: graded from the surface
        +------+||||||||||||+---+----+   similar    |
        |          \\        \\       \\  to the core  |
        +-------------------------------------------+     far sides r = far and z = far

A mesh is a tensor grid, the core, and layers around it that are blown up from its far sides: angles stay, sizes grow, so that no element gets thin.
"""

from dataclasses import dataclass

import numpy as np


def growing(first, length, ratio):
    """Steps first, first*ratio, ... that fill a length exactly."""
    count = max(1, int(round(np.log1p(length / first * (ratio - 1.0)) / np.log(ratio))))
    steps = ratio ** np.arange(count)
    return steps * (length / steps.sum())


def surface_of_band(low, high, width, ratio, core):
    """Places on the surface: uniform from `low` to `high`, graded to the axis and to `core`."""
    count = int(round((high - low) / width))
    assert abs(count * width - (high - low)) < 1e-9 * high, "the band is no multiple of its width"
    inner = low - np.cumsum(growing(width * ratio, low, ratio))
    outer = high + np.cumsum(growing(width * ratio, core - high, ratio))
    inner[-1], outer[-1] = 0.0, core
    return np.concatenate([inner[::-1], low + (high - low) * np.arange(count + 1) / count, outer])


def surface_of_edge(radius, smallest, ratio, core):
    """Places on the surface graded from both sides to one edge at rest, whose last elements are `smallest`."""
    inner = radius - np.cumsum(growing(smallest, radius, ratio))
    outer = radius + np.cumsum(growing(smallest, core - radius, ratio))
    inner[-1], outer[-1] = 0.0, core
    return np.concatenate([inner[::-1], [radius], outer])


@dataclass(frozen=True)
class Grid:
    """Corner points, quadrilaterals (tensor order of their corners), and where the body ends."""
    points: np.ndarray
    cells: np.ndarray
    far: float


def grid(surface, first_depth, ratio, layers, layer_ratio):
    """The core below `surface` (square) and `layers` layers around it, each `layer_ratio` times the one within."""
    core = surface[-1]
    depth = np.concatenate([[0.0], np.cumsum(growing(first_depth, core, ratio))])
    depth[-1] = core
    nr, nz = len(surface), len(depth)
    points = [np.stack(np.meshgrid(surface, depth, indexing="ij"), axis=-1).reshape(-1, 2)]
    index = np.arange(nr * nz).reshape(nr, nz)
    cells = [np.stack([index[:-1, :-1], index[1:, :-1], index[:-1, 1:], index[1:, 1:]], axis=-1).reshape(-1, 4)]
    # The far sides of the core, from the surface down and back to the axis.
    ring = np.concatenate([index[-1, :], index[-2::-1, -1]])
    corner = points[0][ring]
    for layer in range(1, layers + 1):
        fresh = sum(len(p) for p in points) + np.arange(len(ring))
        points.append(corner * layer_ratio**layer)
        cells.append(np.stack([ring[:-1], ring[1:], fresh[:-1], fresh[1:]], axis=-1))
        ring = fresh
    return Grid(np.concatenate(points), np.concatenate(cells), core * layer_ratio**layers)
