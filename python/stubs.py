#!/usr/bin/env python3
"""Writes rayclock/_rayclock.pyi, the types of the compiled module: stubs.py [FILE].

The attributes of Config come from the module, which has them from the model's table of parameters.
"""
import sys
from pathlib import Path

sys.path.remove(str(Path(__file__).parent))   # which has the package without its compiled module
import rayclock   # noqa: E402

HEAD = '''"""Types of the compiled module. Written by python/stubs.py; do not edit."""
from typing import Any, ClassVar, List, Optional, Tuple

import numpy

__version__: str

class Error(ValueError):
    """Input that makes no sense, in one sentence."""

def config_names() -> List[str]:
    """The names of the configurations that come with rayclock."""

def scene_names() -> List[str]:
    """The names of the built-in scenes."""

class Config:
    """A machine: a configuration by name or from a file, with parameters overridden."""

    parameters: ClassVar[Tuple[str, ...]]
    """The names of all parameters, in the order of the documents."""
    __hash__: ClassVar[None]   # type: ignore[assignment]
'''

TAIL = '''
    @property
    def name(self) -> str:
        """The name of the configuration."""
    def __init__(self, name: str = ..., **settings: Any) -> None: ...
    def replace(self, **settings: Any) -> Config:
        """Returns a copy with some parameters set. Raises Error for an illegal value."""
    def check(self) -> None:
        """Raises Error unless all values are legal together."""
    def __eq__(self, other: object) -> bool: ...
    def _json(self) -> str: ...

# The rest is used by the package only.
class SceneData:
    name: str
    notes: List[str]
    triangles: int
    vertices: numpy.ndarray
    indices: numpy.ndarray
    camera: Optional[str]
    @staticmethod
    def load(spec: str) -> SceneData: ...
    @staticmethod
    def of_arrays(*arguments: Any) -> SceneData: ...
    def _json(self) -> str: ...

View: Any
Finish: Any
Frames: Any
FrameOptions: Any

class SimulatedFrame:
    json: str
    notes: List[str]
    def take_picture(self) -> numpy.ndarray: ...
    def take_hits(self) -> numpy.ndarray: ...

class SimulatedStream:
    json: str
    notes: List[str]
    def take_hits(self) -> numpy.ndarray: ...

def simulate(*arguments: Any) -> SimulatedFrame: ...
def simulate_stream(*arguments: Any) -> SimulatedStream: ...
def trace(*arguments: Any) -> SimulatedStream: ...
def continuing_work() -> int: ...
def sweep(*arguments: Any) -> Tuple[str, List[str]]: ...
def sweep_stream(*arguments: Any) -> Tuple[str, List[str]]: ...
def explain(*arguments: Any) -> Tuple[str, str, List[str]]: ...
def explain_stream(*arguments: Any) -> Tuple[str, str, List[str]]: ...
def make_rays(*arguments: Any) -> numpy.ndarray: ...
def unit_names() -> List[str]: ...
def unit_dtype(name: str, is_response: bool, config: Config) -> numpy.dtype: ...
def unit_fields(name: str, is_response: bool, config: Config) -> List[Tuple[str, int, int, bool]]: ...
def unit_bits(name: str, is_response: bool, config: Config) -> int: ...
def unit_answer(name: str, requests: numpy.ndarray, responses: numpy.ndarray, config: Config, threads: int) -> None: ...
def unit_loop_seconds(name: str, requests: numpy.ndarray, config: Config, is_new: bool) -> float: ...
def unit_pack(name: str, is_response: bool, rows: numpy.ndarray, config: Config) -> numpy.ndarray: ...
def unit_unpack(name: str, is_response: bool, words: numpy.ndarray, config: Config) -> numpy.ndarray: ...
'''


def stubs() -> str:
    usual = rayclock.Config()
    text = HEAD
    for name in rayclock.Config.parameters:
        kind = type(getattr(usual, name)).__name__
        text += f'    {name}: {kind}\n    """{getattr(rayclock.Config, name).__doc__.splitlines()[0]}"""\n'
    return text + TAIL


if __name__ == "__main__":
    if len(sys.argv) > 1:
        with open(sys.argv[1], "w") as file:
            file.write(stubs())
    else:
        sys.stdout.write(stubs())
