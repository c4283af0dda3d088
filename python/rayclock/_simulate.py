"""simulate(), trace(), make_rays(), sweep() and explain()."""
from __future__ import annotations

import json
from typing import Any, Iterable, Mapping, Optional, Tuple, Union, overload

import numpy as np

from . import _arrays, _rayclock
from ._rayclock import Config, Error
from ._reports import ExplainRayReport, ExplainReport, SimulateReport, StreamReport, SweepReport
from ._scene import Scene, Vector, scene_data, warn_notes, vector

Size = Union[str, Tuple[int, int]]
Clock = Union[str, float, Iterable[float]]

hit_dtype = np.dtype([("primitive", "<u4"), ("depth", "<f4"), ("u", "<f4"), ("v", "<f4")])
"""The type of SimulateReport.hits."""

_most_rays = 2**28 - 1   # that a chip can number


def config_of(config: Union[str, Config]) -> Config:
    if isinstance(config, str):
        return Config(config)
    if not isinstance(config, Config):
        raise Error(f"{config!r:.80} is not a Config or the name of one")
    return config


def whole(name: str, value: Any, least: int, most: int) -> int:
    """Returns a whole number in this range."""
    try:
        number = value.__index__()
    except AttributeError:
        raise Error(f"{name}: {value!r:.80} is not a whole number") from None
    if not least <= number <= most:
        raise Error(f"{name} must lie in {least}..{most}, not {number}")
    return number


def size_of(size: Size) -> Tuple[int, int]:
    sides = size.split("x") if isinstance(size, str) else size
    try:
        width, height = (int(s) if isinstance(s, str) else s.__index__() for s in sides)
    except (TypeError, ValueError, AttributeError):
        raise Error(f"size: {size!r:.80} is not (width, height) or 'WIDTHxHEIGHT'") from None
    limit = 2**31 - 1
    return whole("width", width, -limit, limit), whole("height", height, -limit, limit)


def clocks_of(clock: Clock) -> str:
    if isinstance(clock, str):
        return clock
    try:
        clocks = [float(clock)]   # type: ignore[arg-type]
    except TypeError:
        try:
            clocks = [float(c) for c in clock]   # type: ignore[union-attr]
        except (TypeError, ValueError):
            raise Error(f"clock: {clock!r:.80} is not a number of MHz, or several") from None
    except ValueError:
        raise Error(f"clock: {clock!r:.80} is not a number of MHz, or several") from None
    return ",".join(f"{c:.3f}".rstrip("0").rstrip(".") for c in clocks)


def _number(name: str, value: Any) -> Optional[float]:
    if value is None:
        return None
    try:
        return float(value)
    except (TypeError, ValueError):
        raise Error(f"{name}: {value!r:.80} is not a number") from None


def _view(eye: Optional[Vector], at: Optional[Vector], fov: Optional[float], orbit: Optional[float], ground: bool,
          material: Optional[str]) -> Any:
    def text(name: str, value: Any) -> Optional[str]:
        return None if value is None else ",".join(repr(x) for x in vector(name, value))

    view = _rayclock.View()
    view.eye, view.at = text("eye", eye), text("at", at)
    view.fov, view.orbit = _number("fov", fov), _number("orbit", orbit)
    view.ground = bool(ground)
    view.material = None if material is None else str(material)
    return view


def _options(*, engine: str = "model", reference: bool = True, size: Any = None, depth: Any = None, aa: Any = None,
             threshold: Any = None, contrast: Any = None, jittered: bool = False, fresnel: bool = False, eye: Any = None,
             at: Any = None, fov: Any = None, orbit: Any = None, ground: bool = False, material: Any = None,
             frames: int = 1, pan: float = 0, fps: Any = None, time: str = "", uploads: str = "between",
             rebuild: Any = None) -> Any:
    """Checks the arguments that a picture takes."""
    if engine not in ("model", "rtl"):
        raise Error(f"engine: {engine!r:.80} is not model or rtl")
    most = 2**31 - 1
    finish = _rayclock.Finish()
    finish.depth = None if depth is None else whole("depth", depth, -most, most)
    finish.aa = None if aa is None else whole("aa", aa, -most, most)
    finish.threshold, finish.contrast = _number("threshold", threshold), _number("contrast", contrast)
    finish.jittered, finish.fresnel = bool(jittered), bool(fresnel)
    film = _rayclock.Frames()
    film.frames, film.pan, film.fps = whole("frames", frames, -most, most), _number("pan", pan), _number("fps", fps)
    film.time, film.uploads = str(time), str(uploads)
    if rebuild is not None:
        film.rebuild = _number("rebuild", rebuild)
    view = _view(eye, at, fov, orbit, ground, material)
    return _rayclock.FrameOptions(*size_of((512, 384) if size is None else size), finish, view, film, engine,
                                  bool(reference))


@overload
def simulate(scene: Union[str, Scene], config: Union[str, Config] = ..., *, rays: None = ..., size: Optional[Size] = ...,
             clock: Clock = ..., depth: Optional[int] = ..., aa: Optional[int] = ..., threshold: Optional[float] = ...,
             contrast: Optional[float] = ..., jittered: bool = ..., fresnel: bool = ..., eye: Optional[Vector] = ...,
             at: Optional[Vector] = ..., fov: Optional[float] = ..., orbit: Optional[float] = ..., ground: bool = ...,
             material: Optional[str] = ..., frames: int = ..., pan: float = ..., fps: Optional[float] = ...,
             time: str = ..., uploads: str = ..., rebuild: Optional[float] = ..., engine: str = ...,
             reference: bool = ..., judge: bool = ..., seed: int = ..., jitter: int = ..., stall: int = ...,
             threads: int = ...) -> SimulateReport: ...
@overload
def simulate(scene: Union[str, Scene], config: Union[str, Config] = ..., *, rays: Any, any_hit: bool = ...,
             outside: str = ..., clock: Clock = ..., judge: bool = ..., seed: int = ..., jitter: int = ...,
             stall: int = ..., threads: int = ...) -> StreamReport: ...


def simulate(scene: Any, config: Any = "default", *, rays: Any = None, any_hit: bool = False, outside: str = "clip",
             size: Any = None, clock: Any = (66, 90, 200), depth: Any = None, aa: Any = None, threshold: Any = None,
             contrast: Any = None, jittered: bool = False, fresnel: bool = False, eye: Any = None, at: Any = None,
             fov: Any = None, orbit: Any = None, ground: bool = False, material: Any = None, frames: int = 1,
             pan: float = 0, fps: Any = None, time: str = "", uploads: str = "between", rebuild: Any = None,
             engine: str = "model", reference: bool = True, judge: bool = True, seed: int = 1, jitter: int = 0,
             stall: int = 0, threads: int = 0) -> Any:
    """Counts the cycles, frames per second, work and stalls of a picture or of a stream of rays.

    The arguments are the options of `rayclock simulate`, with the same meaning. `reference=False` is
    --no-reference, `judge=False` is --no-judge. The default size is 512 x 384.

    With `rays`, the machine traces these rays in place of a camera's, and the result is a StreamReport. `rays` is
    an array of float32 or float64. Its rows have 6 numbers (origin, direction), 7 (and t_max), 8 (t_min and t_max)
    or 9 (and 1 for any hit). An array in C order and native byte order is read in place. Other arrays are copied
    once.

    Other Python threads run meanwhile. Ctrl-C stops the work. Raises Error for input that makes no sense.
    """
    data, machine = scene_data(scene), config_of(config)
    common = (clocks_of(clock), whole("seed", seed, 1, 1 << 30), whole("jitter", jitter, 0, 100000),
              whole("stall", stall, 0, 99), bool(judge), whole("threads", threads, 0, 1024))
    odd = {name: given for name, given in [
        ("size", size is not None), ("depth", depth is not None), ("aa", aa is not None),
        ("threshold", threshold is not None), ("contrast", contrast is not None), ("jittered", jittered),
        ("fresnel", fresnel), ("eye", eye is not None), ("at", at is not None), ("fov", fov is not None),
        ("orbit", orbit is not None), ("ground", ground), ("material", material is not None),
        ("frames", frames != 1), ("pan", pan != 0), ("fps", fps is not None), ("time", time != ""),
        ("uploads", uploads != "between"), ("rebuild", rebuild is not None), ("engine", engine != "model"),
        ("reference", not reference)] if given}
    stream = _stream(rays, any_hit, outside, odd, machine)
    if stream is not None:
        traced = _rayclock.simulate_stream(data, machine, *stream, *common)
        warn_notes(traced.notes)
        return StreamReport(**json.loads(traced.json), hits=_arrays.read_npy(traced.take_hits()))
    options = _options(engine=engine, reference=reference, size=size, depth=depth, aa=aa, threshold=threshold,
                       contrast=contrast, jittered=jittered, fresnel=fresnel, eye=eye, at=at, fov=fov, orbit=orbit,
                       ground=ground, material=material, frames=frames, pan=pan, fps=fps, time=time, uploads=uploads,
                       rebuild=rebuild)
    made = _rayclock.simulate(data, machine, options, *common)
    warn_notes(made.notes)
    hits = made.take_hits()
    return SimulateReport(**json.loads(made.json), picture=made.take_picture(),
                          hits=hits.view(hit_dtype)[..., 0])


def _ray_table(rays: Any, machine: Config) -> np.ndarray:
    fits = 2 << machine.addr_bits   # two rays in a line of the chip's memory
    return _arrays.table("rays", rays, (6, 7, 8, 9), "f", min(_most_rays, fits))


def trace(scene: Union[str, Scene], rays: Any, any_hit: bool = False, *, config: Union[str, Config] = "default",
          engine: str = "model", outside: str = "clip", threads: int = 0) -> np.ndarray:
    """Returns the hit of each ray without timing, like `rayclock render --rays --hits`.

    `rays` has n x 6, 7, 8 or 9 numbers, float32 or float64, as for simulate(rays=...). With any_hit every ray
    requests any hit. engine: model and rtl give the machine's exact hits, reference those of the tracer in
    double precision. outside: clip or refuse rays that begin outside the lattice.

    The result is a structured array with the fields of simulate(rays=...).hits. The field cycle is 0. It is a
    view of the simulator's result, not a copy. Raises Error.
    """
    data, machine = scene_data(scene), config_of(config)
    traced = _rayclock.trace(data, machine, _ray_table(rays, machine), "rays", bool(any_hit), str(outside), str(engine),
                             whole("threads", threads, 0, 1024))
    warn_notes(traced.notes)
    return _arrays.read_npy(traced.take_hits())


def make_rays(scene: Union[str, Scene], *, kind: str = "camera", size: Size = (256, 192), bounce: int = 1,
              samples: int = 1, radius: Optional[float] = None, order: str = "recorded", seed: int = 1,
              config: Union[str, Config] = "default", eye: Optional[Vector] = None, at: Optional[Vector] = None,
              fov: Optional[float] = None, orbit: Optional[float] = None, threads: int = 0) -> np.ndarray:
    """Makes the rays that a renderer sends, with the reference tracer: what `rayclock rays` writes.

    kind: camera, shadow, mirror, ao (ambient occlusion) or diffuse. order: recorded, morton or random.
    Returns n x 6 or n x 9 float64, for simulate(rays=...). Raises Error.
    """
    width, height = size_of(size)
    most = 2**31 - 1
    return _arrays.read_npy(_rayclock.make_rays(
        scene_data(scene), config_of(config), width, height, str(kind), str(order), whole("bounce", bounce, -most, most),
        whole("samples", samples, -most, most), _number("radius", radius), whole("seed", seed, 1, 1 << 30),
        _view(eye, at, fov, orbit, False, None), whole("threads", threads, 0, 1024)))


def _axis(key: str, values: Any) -> str:
    if isinstance(values, str):
        return f"{key}={values}"
    try:
        words = [v if isinstance(v, str) else repr(v.item() if hasattr(v, "item") else v) for v in values]
    except TypeError:
        raise Error(f"axis {key}: {values!r:.80} is not a list of values") from None
    words = [{"True": "1", "False": "0"}.get(w, w) for w in words]
    return f"{key}={','.join(words)}"


def sweep(scene: Union[str, Scene], axes: Mapping[str, Any], config: Union[str, Config] = "default", *,
          rays: Any = None, any_hit: bool = False, outside: str = "clip", clock: Clock = 66, cost: str = "auto",
          netlist: bool = False, fresh: bool = False, seed: int = 1, threads: int = 0, **picture: Any) -> SweepReport:
    """Runs one scene on many configurations and clocks: what `rayclock sweep` does.

    axes: the values of each parameter, or of "clock": {"pipelines": [1, 2, 4], "dram": ["ddr3", "sdr"]}. A text
    has the form of --axis: {"node_sets": "16,32", "a/b": "1/8,2/4"}. `clock` applies if there is no axis "clock".
    netlist=True counts multipliers and flip-flops with Yosys, as the program does by default. `picture`
    takes the arguments of simulate() for a picture: size, depth, aa, eye, frames and so on.

    With `rays`, every point traces these rays in place of a camera's, as simulate(rays=...) does, and the report's
    frame is None.

    Finished figures are kept in the program's cache, and fresh=True ignores it. Raises Error.
    """
    data, machine = scene_data(scene), config_of(config)
    common = ([_axis(str(key), values) for key, values in axes.items()], str(cost), bool(netlist), bool(fresh),
              whole("threads", threads, 0, 1024))
    stream = _stream(rays, any_hit, outside, picture, machine)
    if stream is not None:
        told, notes = _rayclock.sweep_stream(data, machine, *stream, clocks_of(clock), *common)
    else:
        told, notes = _rayclock.sweep(data, machine, _picture(picture), clocks_of(clock),
                                      whole("seed", seed, 1, 1 << 30), *common)
    warn_notes(notes)
    return SweepReport(**json.loads(told))


@overload
def explain(scene: Union[str, Scene], pixel: Tuple[int, int], config: Union[str, Config] = ..., *, rays: None = ...,
            clock: Clock = ..., judge: bool = ..., seed: int = ..., jitter: int = ..., stall: int = ...,
            threads: int = ..., **picture: Any) -> ExplainReport: ...
@overload
def explain(scene: Union[str, Scene], *, config: Union[str, Config] = ..., rays: Any, ray: int, any_hit: bool = ...,
            outside: str = ..., clock: Clock = ..., seed: int = ..., jitter: int = ..., stall: int = ...,
            threads: int = ...) -> ExplainRayReport: ...


def explain(scene: Any, pixel: Any = None, config: Any = "default", *, rays: Any = None, ray: Any = None,
            any_hit: bool = False, outside: str = "clip", clock: Any = 66, judge: bool = True, seed: int = 1,
            jitter: int = 0, stall: int = 0, threads: int = 0, **picture: Any) -> Any:
    """Follows one pixel ray by ray and cycle by cycle, and says why it differs: what `rayclock explain` does.

    pixel: column and row, from the top left corner. `picture` takes the arguments of simulate() for a picture,
    with reference=False among them.

    With `rays` in place of a pixel, follows the ray with the number `ray`, counted from 0, in the stream of these
    rays. The result is an ExplainRayReport. Raises Error.
    """
    data, machine = scene_data(scene), config_of(config)
    common = (clocks_of(clock), whole("seed", seed, 1, 1 << 30), whole("jitter", jitter, 0, 100000),
              whole("stall", stall, 0, 99))
    workers = whole("threads", threads, 0, 1024)
    odd = {**picture, **({} if pixel is None else {"pixel": pixel}), **({} if judge else {"judge": judge})}
    stream = _stream(rays, any_hit, outside, odd, machine)
    if stream is not None:
        number = whole("ray", ray, 0, len(stream[0]) - 1)
        told, text, notes = _rayclock.explain_stream(data, machine, *stream, number, *common, workers)
        warn_notes(notes)
        return ExplainRayReport(**json.loads(told), text=text)
    if ray is not None:
        raise Error("ray needs rays, a stream of rays")
    options = _picture(picture)
    try:
        x, y = pixel
    except (TypeError, ValueError):
        raise Error(f"pixel: {pixel!r:.80} is not (column, row)") from None
    most = 2**31 - 1
    told, text, notes = _rayclock.explain(data, machine, options, whole("column", x, -most, most),
                                          whole("row", y, -most, most), *common, bool(judge), workers)
    warn_notes(notes)
    return ExplainReport(**json.loads(told), text=text)


def _stream(rays: Any, any_hit: bool, outside: str, odd: Mapping[str, Any],
            machine: Config) -> Optional[Tuple[np.ndarray, str, bool, str]]:
    """Returns the arguments of a stream, or None for a picture. `odd`: what has no meaning for a stream."""
    if rays is None:
        if any_hit or outside != "clip":
            raise Error(f"{'any_hit' if any_hit else 'outside'} needs rays, a stream of rays")
        return None
    if odd:
        raise Error(f"rays take the place of a camera, so {next(iter(odd))} has no meaning here")
    return _ray_table(rays, machine), "rays", bool(any_hit), str(outside)


def _picture(given: Mapping[str, Any]) -> Any:
    try:
        return _options(**given)
    except TypeError as error:
        raise TypeError(str(error).replace("_options()", "this function")) from None
