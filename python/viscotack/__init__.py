"""viscotack in Python: the program does the work, and its tables come back as pandas data frames.

>>> import viscotack as vt
>>> result = vt.run("scene.toml", {"sliding.speed": "1 mm/s"})
>>> result.states[["friction_coefficient", "friction_coefficient_error"]]
"""

from ._calls import explain, fit, material, problems, run, scene, schema, sweep
from ._errors import (
    AccuracyWarning,
    MachineError,
    NoSuchStateError,
    ProgramNotFoundError,
    SceneError,
    ViscotackError,
)
from ._program import program, version
from ._results import FitResult, MaterialResult, Plot, Result

__all__ = [
    "AccuracyWarning",
    "FitResult",
    "MachineError",
    "MaterialResult",
    "NoSuchStateError",
    "Plot",
    "ProgramNotFoundError",
    "Result",
    "SceneError",
    "ViscotackError",
    "explain",
    "fit",
    "material",
    "problems",
    "program",
    "run",
    "scene",
    "schema",
    "sweep",
    "version",
]
