"""What is computed: solids, histories, states. Reduced sphere: R = 1, moduli near 1; every radius is a multiple of COARSEST, a third of the zone."""

from dataclasses import dataclass

from maxwell import Solid, constant_poisson, elastic_bulk

ZONE = 0.012
COARSEST = ZONE / 3.0
CORE = 0.8                  # the core of a mesh, several times the largest contact

ONE = constant_poisson("one", 0.3, 1.0, ((9.0, 1.0),))
THREE = constant_poisson("three", 0.4, 1.0, ((4.0, 0.03), (2.0, 0.5), (1.0, 6.0)))
ELASTIC_BULK = elastic_bulk("elastic bulk", 5.0, 0.3, ((2.7, 1.0),))                        # Poisson ratio 0.25 to 0.47
ELASTIC_BULK_TWO = elastic_bulk("elastic bulk, two", 4.0, 0.25, ((1.5, 0.1), (0.75, 2.0)))   # 0.24 to 0.47
SOLIDS = {solid.name: solid for solid in (ONE, THREE, ELASTIC_BULK, ELASTIC_BULK_TWO)}


def frozen(solid, state):
    """The elastic solid that this one is when loaded slowly or at once."""
    bulk, shear = (solid.bulk, solid.shear) if state == "relaxed" else solid.glassy
    return Solid(f"{solid.name}, {state}", bulk, shear, ())


@dataclass(frozen=True)
class History:
    """path: (radius, penetration, duration); the first row is the start. Rows with the same radius rest. `asked`: rows whose end is compared."""
    kind: str
    name: str
    solid: Solid
    start: str
    path: tuple
    asked: tuple
    zone: float = ZONE
    resting: int = 8        # steps of a rest, on the coarsest mesh


def prescribed(name, solid, start, *path):
    return History("prescribed", name, solid, start, path, tuple(range(1, len(path))))


def histories():
    yield prescribed("retraction", ONE, "relaxed", (0.24, 0.032, 0.0), (0.2, 0.02, 1.0), (0.16, 0.0, 1.0))
    yield prescribed("approach and retraction", THREE, "untouched", (0.08, 0.0, 0.0), (0.2, 0.04, 1.0), (0.14, 0.0, 0.6))
    yield prescribed("retraction and advance again", ONE, "relaxed", (0.2, 0.03, 0.0), (0.14, 0.008, 0.8), (0.22, 0.04, 0.8))
    yield prescribed("elastic bulk, advance again", ELASTIC_BULK, "relaxed", (0.2, 0.03, 0.0), (0.14, 0.008, 0.8), (0.22, 0.04, 0.8))
    yield prescribed("elastic bulk, two, return rest advance", ELASTIC_BULK_TWO, "untouched", (0.1, 0.002, 0.0), (0.18, 0.03, 0.6), (0.14, 0.008, 0.4),
                     (0.14, 0.012, 0.5), (0.2, 0.035, 0.6))


# The reduced run: two meshes of these.
REDUCED = ("retraction and advance again", "elastic bulk, advance again")

PUNCH_RADIUS = 0.2
PUNCH_DEPTH = 0.01
PUNCH_TIMES = (0.0625, 0.25, 1.0, 4.0, 16.0)


def punches():
    """(name, solid): pressed at once, held."""
    yield "punch, three", THREE
    yield "punch, elastic bulk", ELASTIC_BULK
    yield "punch, elastic bulk, two", ELASTIC_BULK_TWO


def states():
    """Elastic contacts of a sphere: (name, solid, radius, penetration)."""
    yield "slow, pulled", frozen(ELASTIC_BULK, "relaxed"), 0.2, 0.01
    yield "fast, pulled", frozen(ELASTIC_BULK, "glassy"), 0.2, 0.01
    yield "slow, no depth", frozen(ONE, "relaxed"), 0.16, 0.0


def increments():
    """A fixed edge: relaxed, drawn for a while, then drawn at once: (name, solid, radius, (depth, drawn to, duration), increment)."""
    yield "glassy increment, one", ONE, 0.2, (0.03, 0.02, 0.7), -0.004
    yield "glassy increment, elastic bulk", ELASTIC_BULK, 0.2, (0.03, 0.02, 0.7), -0.004
