"""The harness itself: arrays in and out, refusals, and that it is the same solver as the command line's."""

import pytest


def test_arrays_of_any_shape_and_plain_numbers(harness, need):
    np = need("numpy")
    one = harness.special("dawson", 0.5)
    assert isinstance(one, np.ndarray) and one.dtype == np.float64 and one.shape == (1,)
    grid = np.linspace(0.1, 2.0, 12).reshape(3, 4)
    assert np.array_equal(harness.special("dawson", grid), harness.special("dawson", list(grid.ravel())))
    assert np.array_equal(harness.special("dawson", grid.T), harness.special("dawson", grid.T.copy()))


def test_refusals_are_errors_with_their_sentence(harness):
    with pytest.raises(ValueError, match="glassy_modulus"):
        harness.Material.from_creep(-1.0, [0.9], [1.0])
    with pytest.raises(ValueError, match="not known"):
        harness.special("no such function", 1.0)
    with pytest.raises(ValueError, match="half_width"):
        harness.SlidingContact(harness.Material.from_creep(10.0, [0.9], [1.0]), 1.0, 4.0, 0.0, "mean_pressure", 0.1)


def test_the_closure_takes_any_two_fields(harness):
    # (1/2) int d^(-1/2) (1 - d)^(1/2) dd = pi/4
    value, bar = harness.closure(lambda d: d ** -0.5, lambda s: s ** 0.5, 1.0, 1e-13)
    assert abs(value - 0.7853981633974483) <= bar + 1e-15
    with pytest.raises(ZeroDivisionError):
        harness.closure(lambda d: 1.0 / 0.0, lambda s: s, 1.0, 1e-9)


SCENE = """
[material]
relaxed_modulus = "1 MPa"
glassy_modulus = "100 MPa"
creep = [{ fraction = 1.0, retardation_time = "10 ms" }]

[adhesion]
work_of_adhesion = "60 J/m²"
process_zone = { length = "0.1 mm" }

[crack]
body = "against_rigid"
plane = "stress"
speed = "1 mm/s"
"""


def test_a_scene_gives_what_the_solver_gives(harness):
    found = harness.run_scene(SCENE)
    assert found["rows"]["total"] == found["rows"]["solved"] == 1
    material = harness.Material.from_creep(1e8, [1e-6 - 1e-8], [1e-2])
    direct = harness.steady_crack(material, "opening", "virtual_work", 60.0, "constant", [1e-4], speed=1e-3)["energy_release_rate_ratio"][0]
    ratio = found["results"][0]["values"]["energy_release_rate_ratio"]["value"]
    assert abs(ratio / direct - 1.0) < 1e-12
    with pytest.raises(ValueError, match="no_such_key"):
        harness.run_scene(SCENE + "no_such_key = 1")


def test_one_state_by_several_doors(harness):
    """A contact in balance is found again by its half-width alone; the elastic doors agree with one another."""
    material = harness.Material.from_creep(10.0, [0.9], [1.0])
    edges = [0.003, 0.003, 0.005, 0.005]
    found = harness.sliding_equilibrium(material, 0.6, edges, "half_width", 1.0, [0.25, 0.0])
    rows = harness.sliding_contacts_of_width(material, 0.6, edges, 1.0)
    assert min(abs(row[1] - found["eccentricity"]) + abs(row[2] - found["mean_pressure"]) for row in rows) < 1e-4
    branches = harness.sliding_every_branch(material, 0.6, edges, 1e-6)
    assert branches and branches[0][0] > 10
    strength = harness.sliding_strength(material, 0.6, edges, 1e-6)
    turns = [value for quantity, value, _ in harness.sliding_branch(material, 0.6, edges, 1e-6)["folds"] if quantity == "MeanPressure"]
    assert any(abs(strength["pull_off"][0] - value) < 1e-6 for value in turns)
    half_width, penetration = harness.westergaard_wave(1.0, 6.283185307179586, 0.1, 0.02)
    held = harness.johnson_wave(1.0, 6.283185307179586, 0.1, 1e-16, "half_width", half_width)
    assert abs(held[2] / 0.02 - 1.0) < 1e-5 and abs(held[3] / penetration - 1.0) < 1e-5
    assert harness.tabor_number(1.0, 1.0, 1.0, 0.5) == pytest.approx(2.0)
