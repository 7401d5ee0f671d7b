"""Histories on meshes whose edge passes one element a step, and punches and increments on meshes graded to an edge at rest."""

import numpy as np

import cases
import edge
import j_integral
import mesh
from contact import Contact
from halfspace import HalfSpace
from maxwell import plane_modulus, poisson

DEGREE, RATIO, LAYERS, LAYER_RATIO = 3, 1.4, 16, 1.5
SMALL, SMALL_RATIO, SMALL_DEGREE = 1e-5, 1.8, 4             # the graded mesh: its last elements over the radius
PUNCH = (1e-4, 2.0, 4)


def sphere(r):
    return 0.5 * r * r


def band_body(solid, low, high, refinement):
    width = cases.COARSEST / refinement
    surface = mesh.surface_of_band(low, high, width, RATIO, cases.CORE)
    body = HalfSpace(mesh.grid(surface, width, RATIO, LAYERS, LAYER_RATIO), DEGREE, poisson(*solid.glassy))
    return body, int(np.searchsorted(body.radii, high * (1.0 + 1e-9)))


def graded_body(solid, radius, smallest=SMALL, ratio=SMALL_RATIO, degree=SMALL_DEGREE):
    surface = mesh.surface_of_edge(radius, smallest * radius, ratio, 4.0 * radius)
    body = HalfSpace(mesh.grid(surface, smallest * radius, ratio, LAYERS, LAYER_RATIO), degree, poisson(*solid.glassy))
    return body, int(np.searchsorted(body.radii, 1.6 * radius))


def steps_of(row, before, width, resting):
    """How many steps a row of a path takes."""
    return int(round(abs(row[0] - before[0]) / width)) or resting


def edge_is_resolved(case, k):
    """Whether the edge rests, or has its layer of age, speed times relaxation time, over an element: K of an edge that creeps is not to be had from such meshes."""
    moved = abs(case.path[k][0] - case.path[k - 1][0])
    return moved == 0.0 or moved / case.path[k][2] * max(case.solid.times) >= cases.COARSEST


def history(case, refinement):
    """{(instant, quantity, place): value} on one mesh."""
    radii = [row[0] for row in case.path]
    low, high = min(radii) - cases.ZONE, max(radii) + cases.ZONE + 2.0 * cases.COARSEST
    body, candidates = band_body(case.solid, low, high, refinement)
    contact = Contact(body, case.solid, sphere, candidates)
    first = case.path[0]
    if case.start == "relaxed":
        contact.start_relaxed(first[0], first[1])
    else:
        contact.step(first[0], first[1], 0.0)
    place = max(radii) + cases.ZONE
    at = int(np.argmin(np.abs(contact.radii - place)))
    out, width = {}, cases.COARSEST / refinement
    # The rows of a cycle are less than an element apart: a mesh takes those that are its nodes.
    rows = [(k, row) for k, row in enumerate(case.path) if abs(row[0] / width - round(row[0] / width)) < 1e-6]
    for (k0, before), (k, row) in zip(rows, rows[1:]):
        duration = sum(r[2] for r in case.path[k0 + 1:k + 1])
        count = steps_of(row, before, width, case.resting * refinement)
        for step in range(1, count + 1):
            part = step / count
            contact.step(before[0] + (row[0] - before[0]) * part, before[1] + (row[1] - before[1]) * part, duration / count)
        if k in case.asked:
            out[k, "force", ""] = contact.force()
            if edge_is_resolved(case, k):
                out[k, "stress_intensity_factor", ""] = edge.intensity(contact, refinement if row[0] == before[0] else 0)
            out[k, "zone_work", ""] = edge.closure(contact, case.zone)
            out[k, "displacement", repr(round(place, 12))] = float(contact.surface()[at])
    return out


def punch(solid, body, candidates, per_doubling):
    """{(instant, quantity, place): value}: the step of depth at time 0, then steps that double their length each octave of time."""
    contact = Contact(body, solid, lambda r: 0.0 * r, candidates)
    contact.step(cases.PUNCH_RADIUS, cases.PUNCH_DEPTH, 0.0)
    out, time, octave = {}, 0.0, cases.PUNCH_TIMES[0] / 4.0
    # The end of the core, a node of every mesh.
    place = int(np.argmin(np.abs(body.radii - 4.0 * cases.PUNCH_RADIUS)))
    for index, end in enumerate(cases.PUNCH_TIMES):
        while time < end * (1.0 - 1e-9):
            for _ in range(per_doubling):
                contact.step(cases.PUNCH_RADIUS, cases.PUNCH_DEPTH, octave / per_doubling)
            time += octave
            octave = time
        out[index, "force", ""] = contact.force()
        out[index, "displacement", repr(round(4.0 * cases.PUNCH_RADIUS, 12))] = float(contact.u[body.surface[place]])
    return out


RINGS = ((0.02, 0.1), (0.1, 0.4), (0.3, 0.9))


def elastic_state(solid, radius, penetration, *fineness):
    """{(method, quantity): value} of an elastic contact; energies of four others, each on a mesh graded to its own edge."""

    def solved(edge_radius):
        body, candidates = graded_body(solid, edge_radius, *fineness)
        contact = Contact(body, solid, sphere, candidates)
        contact.start_relaxed(edge_radius, penetration)
        return body, contact

    def energy(edge_radius):
        _, contact = solved(edge_radius)
        count = len(contact.reactions)
        return 0.5 * float(contact.reactions @ (penetration - contact.rise[:count]))

    body, contact = solved(radius)
    out = {("reactions", "force"): contact.force()}
    h = 0.02 * radius
    slope = (8.0 * (energy(radius + h) - energy(radius - h)) - energy(radius + 2.0 * h) + energy(radius - 2.0 * h)) / (12.0 * h)
    out["energy difference", "energy_release_rate"] = slope / (2.0 * np.pi * radius)
    for inner, outer in RINGS:
        out[f"ring {inner} {outer}", "energy_release_rate"] = j_integral.energy_release_rate(
            body, solid.bulk, solid.shear, contact.u, contact.reactions, lambda r: r, radius, inner * radius, outer * radius)
    return out


def increment(solid, radius, drawn, size, refinement):
    """{(method, quantity): value}: K before and after by energy differences, and of the increment by J."""
    body, candidates = band_body(solid, radius - cases.ZONE, radius + cases.ZONE, refinement)
    contact = Contact(body, solid, sphere, candidates)
    contact.start_relaxed(radius, drawn[0])
    steps = 8 * refinement
    for step in range(1, steps + 1):
        contact.step(radius, drawn[0] + (drawn[1] - drawn[0]) * step / steps, drawn[2] / steps)
    out = {("energy difference", "intensity_before"): edge.intensity(contact, refinement), ("reactions", "force_before"): contact.force()}
    field, reactions = contact.u.copy(), contact.reactions.copy()
    contact.step(radius, drawn[1] + size, 0.0)
    out["energy difference", "intensity_after"] = edge.intensity(contact, refinement)
    bulk, shear = solid.glassy
    modulus = plane_modulus(bulk, shear)
    for inner, outer in RINGS:
        rate = j_integral.energy_release_rate(body, bulk, shear, contact.u - field, contact.reactions - reactions, lambda r: 0.0 * r, radius,
                                              inner * radius, outer * radius)
        out[f"ring {inner} {outer}", "intensity_of_increment"] = float(np.sqrt(2.0 * modulus * rate) * -np.sign(size))
    return out
