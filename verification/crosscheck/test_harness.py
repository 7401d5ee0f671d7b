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
