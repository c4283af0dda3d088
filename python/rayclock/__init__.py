"""rayclock: a cycle-level simulator of a hardware ray tracer, from Python.

    import rayclock
    report = rayclock.simulate("gears:8", rayclock.Config("default", node_sets=128), clock=66)
    report.clocks[0]["fps"], report.digest

simulate() draws a picture or traces an array of rays, and returns a report with the keys and the digest of
`rayclock simulate --json`. docs/guide/python.md is the guide.
"""
from . import unit
from ._rayclock import Config, Error, __version__, config_names, scene_names
from ._reports import ExplainRayReport, ExplainReport, SimulateReport, StreamReport, SweepReport
from ._scene import Camera, Light, Material, Note, Scene, load_scene
from ._simulate import explain, hit_dtype, make_rays, simulate, sweep, trace

__all__ = [
    "Camera", "Config", "Error", "ExplainRayReport", "ExplainReport", "Light", "Material", "Note", "Scene", "SimulateReport",
    "StreamReport", "SweepReport", "__version__", "config_names", "explain", "hit_dtype", "load_scene", "make_rays",
    "scene_names", "simulate", "sweep", "trace", "unit",
]
