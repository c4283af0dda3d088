"""Types of the compiled module. Written by python/stubs.py; do not edit."""
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
    coord_bits: int
    """Widths: N: width of a signed lattice coordinate."""
    dir_bits: int
    """Widths: M: width of a signed direction component; 2 N + M is at most 62."""
    t_frac_bits: int
    """Widths: F: fraction bits of a distance t."""
    recip_bits: int
    """Widths: R: precision of a reciprocal direction component."""
    box_bits: int
    """Widths: width of a child's box plane relative to its node."""
    bary_bits: int
    """Widths: fraction bits of the barycentric coordinates u and v of a hit."""
    origin_bits: int
    """Widths: B: fraction bits of a secondary ray's origin (docs/proofs/origins.md)."""
    addr_bits: int
    """Widths: width of a memory address, in lines of 64 bytes."""
    prim_bits: int
    """Widths: width of a primitive's number."""
    pixel_bits: int
    """Widths: width of a pixel coordinate."""
    primitive_test: str
    """Widths: ray-triangle test; unit24, moller, woop and truncated exist in software only."""
    structure: str
    """Acceleration structure: acceleration structure of the scene; none is a list of all primitives."""
    straddlers: str
    """Acceleration structure: a primitive that a plane cuts is in both leaves, in the inner node (octree), or never cut (bsp)."""
    splits: str
    """Acceleration structure: on: boxes that would overlap may cut a primitive, which is then in several leaves."""
    references: int
    """Acceleration structure: largest mean number of references per primitive; fewer make a smaller image."""
    levels: int
    """Acceleration structure: 2: a tree over instances and one for each mesh; 1: instances are written out."""
    mesh_structure: str
    """Acceleration structure: acceleration structure of each mesh; same: as structure."""
    node_width: int
    """Acceleration structure: W: children of a node."""
    leaf_size: int
    """Acceleration structure: most primitives in a leaf."""
    stack_depth: int
    """Acceleration structure: groups of siblings that a ray's stack holds."""
    shading: bool
    """Units that only some scenes need: 1: the chip computes finished colours, with shadow rays and bounces; the other units need it."""
    source: str
    """Units that only some scenes need: stream: rays come from records in memory, and the chip has no camera and no shade."""
    spheres: bool
    """Units that only some scenes need: 1: tri tests spheres."""
    planes: bool
    """Units that only some scenes need: 1: tri tests infinite planes, and shade has checkers."""
    smooth: bool
    """Units that only some scenes need: 1: normals are interpolated between a triangle's corners."""
    refraction: bool
    """Units that only some scenes need: 1: refracted rays."""
    panes: int
    """Units that only some scenes need: transmitting planes for which a path records its side, for lights beyond the lattice."""
    horizon: bool
    """Units that only some scenes need: 1: bounces that pass by the lattice meet planes beyond it."""
    supersampling: bool
    """Units that only some scenes need: 1: several samples in a pixel."""
    textures: bool
    """Units that only some scenes need: 1: image textures."""
    texels: str
    """Units that only some scenes need: format of texels: rgb888 with 8 bits of alpha, rgb565 with one bit."""
    lights: int
    """Units that only some scenes need: most point lights."""
    bounces: int
    """Units that only some scenes need: most waiting rays of a pixel, which is the largest depth."""
    contexts: int
    """Rays in flight, queues and intervals: T: rays in flight."""
    pipelines: int
    """Rays in flight, queues and intervals: P: pipelines of one machine; the RTL has at most 8."""
    tile_bits: int
    """Rays in flight, queues and intervals: pixels are dispatched in squares of 2^k x 2^k, in Morton order; 0: row by row."""
    timing: str
    """Rays in flight, queues and intervals: stages of the RTL: relaxed has few, fast has many and a shorter clock period."""
    raygen_queue: int
    """Rays in flight, queues and intervals: result queue of raygen."""
    box_queue: int
    """Rays in flight, queues and intervals: result queue of the node unit."""
    tri_queue: int
    """Rays in flight, queues and intervals: result queue of tri."""
    shade_queue: int
    """Rays in flight, queues and intervals: result queue of shade."""
    cache_queue: int
    """Rays in flight, queues and intervals: result queue of a cache."""
    box_lanes: int
    """Rays in flight, queues and intervals: children that box tests in a cycle; a node with more takes several cycles."""
    raygen_interval: int
    """Rays in flight, queues and intervals: cycles between two rays that raygen starts; more cycles let rays share dividers."""
    tri_interval: int
    """Rays in flight, queues and intervals: cycles between two tests that tri starts; more cycles let tests share multipliers."""
    xform_interval: int
    """Rays in flight, queues and intervals: cycles between two rays that xform starts; more cycles let rays share multipliers."""
    shade_interval: int
    """Rays in flight, queues and intervals: cycles between two passes that shade starts; more cycles let passes share multipliers."""
    node_sets: int
    """Caches: node cache of a pipeline: sets."""
    node_ways: int
    """Caches: node cache: ways."""
    node_line: int
    """Caches: node cache: line size, at least one node."""
    node_mshrs: int
    """Caches: node cache: misses in flight."""
    prim_sets: int
    """Caches: primitive cache of a pipeline: sets."""
    prim_ways: int
    """Caches: primitive cache: ways."""
    prim_line: int
    """Caches: primitive cache: line size."""
    prim_mshrs: int
    """Caches: primitive cache: misses in flight."""
    surf_sets: int
    """Caches: surface cache of a pipeline: sets."""
    surf_ways: int
    """Caches: surface cache: ways."""
    surf_line: int
    """Caches: surface cache: line size."""
    surf_mshrs: int
    """Caches: surface cache: misses in flight."""
    stream_sets: int
    """Caches: cache of ray records of a pipeline: sets."""
    stream_ways: int
    """Caches: cache of ray records: ways."""
    stream_line: int
    """Caches: cache of ray records: line size, which is the length of a burst."""
    stream_mshrs: int
    """Caches: cache of ray records: misses in flight."""
    tex_sets: int
    """Caches: texture cache of a pipeline: sets."""
    tex_ways: int
    """Caches: texture cache: ways."""
    tex_line: int
    """Caches: texture cache: line size."""
    tex_mshrs: int
    """Caches: texture cache: misses in flight."""
    l2_sets: int
    """Caches: cache that all pipelines share: sets; 0: no such cache."""
    l2_ways: int
    """Caches: shared cache: ways."""
    l2_line: int
    """Caches: shared cache: line size."""
    l2_mshrs: int
    """Caches: shared cache: misses in flight."""
    dram: str
    """Memory outside the chip: memory, or the path of a JSON file that describes one."""
    dram_channels: int
    """Memory outside the chip: channels that serve neighbouring addresses in turn."""
    mem_latency: int
    """Memory outside the chip: ideal memory: from a request to its answer."""
    mem_interval: int
    """Memory outside the chip: ideal memory: between two requests."""
    scan_out: bool
    """Memory outside the chip: 1: a screen of 640x480 pixels is read 60 times a second."""
    pixel_writes: bool
    """Memory outside the chip: 1: finished pixels are written to the memory; with source=stream, the unit hits writes the answers to rays."""

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
