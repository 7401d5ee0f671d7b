"""What the tests share."""

from __future__ import annotations

from pathlib import Path

import pytest

REPOSITORY = Path(__file__).parents[2]

SLIDING = """title = "Friction for tests"
[material]
relaxed_modulus = "1 MPa"
glassy_modulus = "10 MPa"
poisson_ratio = 0.49
creep = [{ fraction = 1, retardation_time = "10 ms" }]
[adhesion]
work_of_adhesion = "20 mJ/m²"
process_zone = { length = "0.16 µm" }
[sliding]
contacts = ["adhesive"]
speed = "1 mm/s"
mean_pressure = "6 kPa"
[sliding.wave]
wavelength = "100 µm"
amplitude = "3 µm"
[fields]
points = 40
"""

CRACK = """
[material]
relaxed_modulus = "1 MPa"
glassy_modulus = "100 MPa"
creep = [{ fraction = 1, retardation_time = "1 s" }]
[adhesion]
work_of_adhesion = "1 J/m²"
process_zone = { cohesive_stress = "1 MPa" }
[crack]
body = "against_rigid"
plane = "stress"
speed = "1 mm/s"
"""


@pytest.fixture
def sliding(tmp_path: Path) -> Path:
    """The file of a sliding scene."""
    path = tmp_path / "sliding.toml"
    path.write_text(SLIDING, encoding="utf-8")
    return path


@pytest.fixture
def crack(tmp_path: Path) -> Path:
    """The file of a scene whose states take a fraction of a millisecond."""
    path = tmp_path / "crack.toml"
    path.write_text(CRACK, encoding="utf-8")
    return path
