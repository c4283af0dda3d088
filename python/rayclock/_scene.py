"""Scenes: built in, from files, and from arrays."""
from __future__ import annotations

import dataclasses
import json
import warnings
from typing import Any, Optional, Sequence, Tuple, Union

import numpy as np

from . import _arrays, _rayclock
from ._rayclock import Error

Vector = Sequence[float]
_most = 2**32 - 1   # vertices, and triangles


class Note(UserWarning):
    """A note of the program: content that is changed or not drawn, or an option without effect."""


def warn_notes(notes: Sequence[str]) -> None:
    for note in notes:
        warnings.warn(note, Note, stacklevel=3)


@dataclasses.dataclass(frozen=True)
class Material:
    """A surface, in the terms of Haines' NFF. scenes/README.md has the same keys."""

    name: str = ""
    colour: Tuple[float, float, float] = (0.8, 0.8, 0.8)
    """Diffuse reflectance, linear RGB, 0 to 1."""
    ambient: float = 0.1
    """Weight of the surrounding light."""
    diffuse: float = 0.9
    """Weight of Lambert's term."""
    highlight: float = 0.0
    """Weight of the Phong highlight."""
    shine: float = 1.0
    """Phong's exponent."""
    mirror: float = 0.0
    """Weight of the reflected ray."""
    transmit: float = 0.0
    """Weight of the refracted ray."""
    index: float = 1.0
    """Refractive index of the inside."""


@dataclasses.dataclass(frozen=True)
class Light:
    """A point light without attenuation."""

    position: Tuple[float, float, float]
    colour: Tuple[float, float, float] = (1.0, 1.0, 1.0)


@dataclasses.dataclass(frozen=True)
class Camera:
    """A pin-hole camera. `fov_degrees` is the angle between the picture's upper and lower edge."""

    eye: Tuple[float, float, float]
    at: Tuple[float, float, float] = (0.0, 0.0, 0.0)
    up: Tuple[float, float, float] = (0.0, 1.0, 0.0)
    fov_degrees: float = 45.0


def vector(name: str, value: Any) -> Tuple[float, float, float]:
    """Returns three numbers."""
    try:
        three = tuple(float(x) for x in value)
    except (TypeError, ValueError):
        three = ()
    if len(three) != 3:
        raise Error(f"{name}: {value!r:.80} is not three numbers")
    return three   # type: ignore[return-value]


class Scene:
    """A scene of triangles from arrays. load_scene() returns scenes of other origins.

    vertices: n x 3 numbers, in scene units.
    indices: m x 3 whole numbers, the corners of each triangle, counter-clockwise seen from outside.
    normals: n x 3 numbers, the normals of the vertices; without them every triangle is flat.
    materials: the materials; `material` has the index of one of them for each triangle, 0 without it.
    lights: None adds two lights, as for a file without lights. An empty list means no lights.
    camera: None shows the whole scene.
    background: linear RGB.

    The arrays are copied. Raises Error if the scene cannot be traced.
    """

    __slots__ = ("_data",)

    def __init__(self, vertices: Any, indices: Any, *, normals: Any = None, material: Any = None,
                 materials: Sequence[Material] = (Material(),), lights: Optional[Sequence[Light]] = None,
                 camera: Optional[Camera] = None, background: Optional[Vector] = None, name: str = "scene") -> None:
        corners = _arrays.table("vertices", vertices, (3,), "fi", _most, np.float64)
        triangles = _arrays.table("indices", indices, (3,), "i", _most, np.uint32)
        shading = None
        if normals is not None:
            shading = _arrays.table("normals", normals, (3,), "fi", _most, np.float64)
            if len(shading) != len(corners):
                raise Error(f"normals: there must be {len(corners)}, one for each vertex, not {len(shading)}")
        surfaces = None if material is None else _arrays.column("material", material, len(triangles), "i", np.uint32)
        self._data = _rayclock.SceneData.of_arrays(
            str(name), corners, triangles, shading, surfaces,
            [_material(m) for m in materials],
            None if lights is None else [(vector("position", x.position), vector("colour", x.colour)) for x in lights],
            None if camera is None else (vector("eye", camera.eye), vector("at", camera.at), vector("up", camera.up),
                                         float(camera.fov_degrees)),
            None if background is None else vector("background", background))

    @property
    def name(self) -> str:
        return self._data.name

    @property
    def vertices(self) -> np.ndarray:
        """n x 3 float64; a view that cannot be written."""
        return self._data.vertices

    @property
    def indices(self) -> np.ndarray:
        """m x 3 uint32; a copy."""
        return self._data.indices

    @property
    def camera(self) -> Optional[Camera]:
        """The scene's own camera, or None if rayclock finds one for each picture."""
        text = self._data.camera
        if text is None:
            return None
        c = json.loads(text)
        return Camera(tuple(c["eye"]), tuple(c["at"]), tuple(c["up"]), c["fov_degrees"])

    def to_dict(self) -> dict:
        """The key `scene` of reports."""
        return json.loads(self._data._json())

    def __repr__(self) -> str:
        return f"<rayclock.Scene {self.name}: {self._data.triangles} triangles>"


def _material(m: Material) -> dict:
    values = dataclasses.asdict(m)
    values["colour"] = vector("colour", m.colour)
    try:
        return {k: v if k in ("name", "colour") else float(v) for k, v in values.items()}
    except (TypeError, ValueError):
        raise Error(f"material {m.name!r}: every weight is a number") from None


def load_scene(spec: str) -> Scene:
    """Loads a scene: a built-in name with an optional size ("gears:8"), or a file.

    Files are those of the program: .json, .obj .ply .stl .off .3ds .dae .glb .gltf, these also with .gz.
    Warns with a Note about content that is changed or not drawn. Raises Error.
    """
    scene = Scene.__new__(Scene)
    scene._data = _rayclock.SceneData.load(str(spec))
    warn_notes(scene._data.notes)
    return scene


def scene_data(scene: Union[str, Scene]) -> Any:
    if isinstance(scene, str):
        scene = load_scene(scene)
    if not isinstance(scene, Scene):
        raise Error(f"{scene!r:.80} is not a Scene or the name of one")
    return scene._data
