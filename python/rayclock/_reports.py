"""Reports: dataclasses whose fields are the keys of the program's JSON. docs/guide/report.md explains them."""
from __future__ import annotations

import dataclasses
import json
from typing import TYPE_CHECKING, Any, Dict, List, Optional

import numpy as np

if TYPE_CHECKING:
    import pandas

Json = Dict[str, Any]


def _keys(cls: Any) -> List[str]:
    return [f.name for f in dataclasses.fields(cls) if f.metadata.get("key", True)]


def _array() -> Any:
    return dataclasses.field(repr=False, compare=False, metadata={"key": False})


class _Keys:
    def to_dict(self) -> Json:
        """Returns the report as the program writes it with --json."""
        return {key: getattr(self, key) for key in _keys(type(self))}

    def to_json(self, **options: Any) -> str:
        """Returns the report as text. `options` are those of json.dumps()."""
        return json.dumps(self.to_dict(), **options)


class _Report(_Keys):
    clocks: List[Json]

    def to_pandas(self) -> "pandas.DataFrame":
        """Returns a table with a row for each clock. Needs pandas."""
        import pandas

        return pandas.json_normalize(self.clocks)

    def accounts(self) -> "pandas.DataFrame":
        """Returns a table with a row for each unit: its cycles by cause, at the first clock. Needs pandas."""
        import pandas

        units: Json = getattr(self, "units")
        rows = [{"unit": unit, "busy": u["busy"], "starved": u["starved"], **u["stalled"]} for unit, u in units.items()]
        return pandas.DataFrame(rows).set_index("unit").fillna(0)


@dataclasses.dataclass(frozen=True)
class SimulateReport(_Report):
    """What simulate() found about a picture."""

    scene: Json
    config: Json
    frame: Json
    camera: Json
    frames: int
    pan: float
    film: Optional[List[Json]]
    engine: str
    partial: bool
    sampling: None
    compile: Json
    rays: Json
    work: Json
    work_by_kind: Optional[Json]
    clocks: List[Json]
    units: Json
    memory: Json
    error: Optional[Json]
    limits: Optional[Json]
    judge: Optional[Json]
    host: Json
    digest: str
    picture: np.ndarray = _array()
    """height x width x 3 float32, linear RGB, the last frame as the machine drew it."""
    hits: np.ndarray = _array()
    """height x width of primitive (2^32 - 1: none), depth, u, v: the camera rays of the last frame."""


@dataclasses.dataclass(frozen=True)
class StreamReport(_Report):
    """What simulate() found about a stream of rays."""

    scene: Json
    stream: Json
    config: Json
    partial: bool
    compile: Json
    rays: Json
    work: Json
    clocks: List[Json]
    units: Json
    memory: Json
    judge: Optional[Json]
    host: Json
    digest: str
    hits: np.ndarray = _array()
    """A row for each ray, with the fields of --hits: hit, back, primitive, instance, t, u, v, cycle."""


@dataclasses.dataclass(frozen=True)
class SweepReport(_Keys):
    """What sweep() found: a figure for each point of a grid."""

    scene: Json
    config: Json
    frame: Optional[Json]
    sweep: Json
    shard: Json
    partial: bool
    front: Json
    knee: Optional[Json]
    limits: Json
    points: List[Json]

    def to_pandas(self) -> "pandas.DataFrame":
        """Returns a table with a row for each point: columns values.*, clock.*, error.* and others. Needs pandas."""
        import pandas

        return pandas.json_normalize(self.points)


@dataclasses.dataclass(frozen=True)
class ExplainReport(_Keys):
    """What explain() found about a pixel."""

    scene: Json
    config: Json
    frame: Json
    mhz: float
    cycles: int
    pixel: List[int]
    pipeline: int
    context: int
    cost: Json
    rays: List[Json]
    colour: Optional[Json]
    limits: Optional[Json]
    text: str = dataclasses.field(default="", repr=False, metadata={"key": False})
    """The story that the program prints with --steps."""

    def __str__(self) -> str:
        return self.text


@dataclasses.dataclass(frozen=True)
class ExplainRayReport(_Keys):
    """What explain() found about a ray of a stream."""

    scene: Json
    stream: Json
    config: Json
    mhz: float
    cycles: int
    ray: int
    pipeline: int
    context: int
    cost: Json
    rays: List[Json]
    text: str = dataclasses.field(default="", repr=False, metadata={"key": False})
    """The story that the program prints with --steps."""

    def __str__(self) -> str:
        return self.text
