"""The pure functions of the units, on batches: what the RTL of a unit must answer.

    import rayclock.unit as unit
    answers = unit.tri(o=[0, 0, -9], d=[0, 0, 1 << 18], a=[-9, -9, 0], b=[9, -9, 0], c=[0, 9, 0], prim=7)
    answers["closer"], answers["t"]

A request is a row of a structured array whose fields are those of the unit's port, in their order
(model/core/payloads.hpp). Numbers are integers as the chip holds them. `config` is a Config or its name.

request_dtype(name, config), response_dtype(name, config): the types of these rows.
pack(name, requests, config), unpack(name, words, config): the bits of the ports, for a test bench.
"""
from __future__ import annotations

from typing import Any, Dict, List, NamedTuple, Optional, Union

import numpy as np

from . import _arrays, _rayclock
from ._rayclock import Config, Error
from ._simulate import config_of, whole

_Config = Union[str, Config]
_most_rows = 2**31 - 1


class Field(NamedTuple):
    """A field of a port."""

    name: str
    bits: int
    """Width of a number in the chip."""
    numbers: int
    """Numbers in an array; 0 for a single number."""
    signed: bool


def names() -> List[str]:
    """Returns the names of all units that have a function."""
    return _rayclock.unit_names()


def request_dtype(name: str, config: _Config = "default") -> np.dtype:
    """Returns the type of a unit's requests in this configuration."""
    return _rayclock.unit_dtype(name, False, config_of(config))


def response_dtype(name: str, config: _Config = "default") -> np.dtype:
    """Returns the type of a unit's answers in this configuration."""
    return _rayclock.unit_dtype(name, True, config_of(config))


def request_fields(name: str, config: _Config = "default") -> List[Field]:
    """Returns the fields of the request port, the most significant first."""
    return [Field(*f) for f in _rayclock.unit_fields(name, False, config_of(config))]


def response_fields(name: str, config: _Config = "default") -> List[Field]:
    """Returns the fields of the answer port, the most significant first."""
    return [Field(*f) for f in _rayclock.unit_fields(name, True, config_of(config))]


def requests(name: str, config: _Config = "default", **fields: Any) -> np.ndarray:
    """Returns requests with these fields, broadcast against each other. Other fields are 0."""
    dtype = request_dtype(name, config)
    values: Dict[str, np.ndarray] = {}
    rows = 1
    for key, value in fields.items():
        if key not in (dtype.names or ()):
            raise Error(f"{name}: no field is called {key}; there are {', '.join(dtype.names or ())}")
        array = np.asarray(value)
        if array.dtype.kind not in "iub":
            raise Error(f"{name}: {key} must be whole numbers, not {array.dtype}")
        inner = dtype[key].shape
        if not array.ndim:   # one number for all
            array = np.broadcast_to(array, inner)
        outer = array.shape[:array.ndim - len(inner)]
        if array.shape[len(outer):] != inner or len(outer) > 1:
            shown = " x ".join(["n", *map(str, inner)])
            raise Error(f"{name}: {key} must have the shape {shown}, not {' x '.join(map(str, array.shape)) or '1'}")
        if outer and outer[0] != 1:
            if rows not in (1, outer[0]):
                raise Error(f"{name}: {key} has {outer[0]} rows, and another field has {rows}")
            rows = outer[0]
        base = dtype[key].base
        if array.size and (int(array.min()) < np.iinfo(base).min or int(array.max()) > np.iinfo(base).max):
            raise Error(f"{name}: {key} has a number that does not fit in {base}")
        values[key] = array
    made = np.zeros(rows, dtype)
    for key, array in values.items():
        made[key] = array
    return made


def _rows(name: str, given: Any, config: Config, is_response: bool) -> np.ndarray:
    dtype = _rayclock.unit_dtype(name, is_response, config)
    what = "answers" if is_response else "requests"
    if not isinstance(given, np.ndarray):
        raise Error(f"{name}: {what} are a structured array, for example from rayclock.unit.requests()")
    if given.dtype.names is None and given.ndim == 2 and given.dtype.kind in "iu":
        return _from_plain(name, given, dtype, what)
    if given.ndim != 1:
        raise Error(f"{name}: {what} have one dimension, not {given.ndim}")
    _arrays.check_rows(name, given, _most_rows)
    if given.dtype != dtype:
        if given.dtype.names != dtype.names:
            raise Error(f"{name}: the fields must be {', '.join(dtype.names or ())}, "
                        f"not {', '.join(given.dtype.names or (str(given.dtype),))}")
        if given.dtype.newbyteorder("=") != dtype and given.dtype.newbyteorder("<") != dtype:
            for field in dtype.names or ():
                if given.dtype[field].newbyteorder("<") != dtype[field]:
                    raise Error(f"{name}: the field {field} must be {dtype[field]}, not {given.dtype[field]}")
        given = given.astype(dtype)
    return np.require(given, None, ["C", "A"])


def _from_plain(name: str, given: np.ndarray, dtype: np.dtype, what: str) -> np.ndarray:
    """Returns rows from a plain array of integers: one column for each number, in the order of the fields."""
    fields = [(f, dtype[f]) for f in dtype.names or ()]
    columns = sum(int(np.prod(t.shape)) for _, t in fields)
    if given.shape[1] != columns:
        raise Error(f"{name}: {what} are n x {columns} numbers, not {given.shape[0]} x {given.shape[1]}")
    _arrays.check_rows(name, given, _most_rows)
    rows = np.empty(len(given), dtype)
    at = 0
    for field, kind in fields:
        count = int(np.prod(kind.shape))
        part = given[:, at:at + count]
        info = np.iinfo(kind.base)
        if part.size and (int(part.min()) < info.min or int(part.max()) > info.max):
            raise Error(f"{name}: {field} has a number that does not fit in {kind.base}")
        rows[field] = part.reshape((len(given), *kind.shape))
        at += count
    return rows


def answer(name: str, given: Any = None, config: _Config = "default", *, threads: int = 0,
           out: Optional[np.ndarray] = None, **fields: Any) -> np.ndarray:
    """Returns the answers of a unit to a batch of requests.

    `given` is a structured array of requests, or a plain array of integers with a column for each number. In
    place of it, fields may be given by name. Raises Error if the configuration lacks the unit, or if a number
    is wider than its field in the chip. `threads` is the number of threads; 0 means one for each core. `out` is
    an array of response_dtype() with a row for each request. It receives the answers and is returned, which saves
    the time to allocate a new array. After an Error its rows may hold some of the answers.
    """
    machine = config_of(config)
    if given is None:
        given = requests(name, machine, **fields)
    elif fields:
        raise Error(f"{name}: give an array of requests or fields, not both")
    rows = _rows(name, given, machine, False)
    dtype = _rayclock.unit_dtype(name, True, machine)
    if out is None:
        out = np.empty(len(rows), dtype)
    elif (not isinstance(out, np.ndarray) or out.dtype != dtype or out.shape != rows.shape
          or not out.flags.carray):
        raise Error(f"{name}: out must be a writable array in C order of {len(rows)} rows of "
                    f"response_dtype({name!r}, config)")
    elif np.may_share_memory(out, rows):
        raise Error(f"{name}: out shares memory with the requests")
    _rayclock.unit_answer(name, rows, out, machine, whole("threads", threads, 0, 1024))
    return out


def pack(name: str, rows: np.ndarray, config: _Config = "default", *, response: bool = False) -> np.ndarray:
    """Returns the bits of a port for each row: n x words of 32 bits, the lowest first."""
    machine = config_of(config)
    return _rayclock.unit_pack(name, response, _rows(name, rows, machine, response), machine)


def unpack(name: str, words: Any, config: _Config = "default", *, response: bool = True) -> np.ndarray:
    """Returns the rows in the bits of a port: the reverse of pack()."""
    machine = config_of(config)
    width = (_rayclock.unit_bits(name, response, machine) + 31) // 32
    table = _arrays.table("words", words, (width,), "i", _most_rows, np.uint32)
    return _rayclock.unit_unpack(name, response, table, machine)


def port_values(name: str, rows: np.ndarray, config: _Config = "default", *, response: bool = False) -> List[int]:
    """Returns each row as the integer that the port holds, for a test bench that drives it as one number."""
    words = pack(name, rows, config, response=response).astype("<u4")
    return [int.from_bytes(row.tobytes(), "little") for row in words]


def from_port_values(name: str, values: Any, config: _Config = "default", *, response: bool = True) -> np.ndarray:
    """Returns rows from the integers of a port: the reverse of port_values()."""
    width = 4 * ((_rayclock.unit_bits(name, response, config_of(config)) + 31) // 32)
    try:
        raw = b"".join(int(v).to_bytes(width, "little") for v in values)
    except (OverflowError, TypeError, ValueError):
        raise Error(f"{name}: a port's value is a whole number of at most {8 * width} bits") from None
    return unpack(name, np.frombuffer(raw, "<u4").reshape(-1, width // 4), config, response=response)


def _make(name: str) -> Any:
    def call(given: Any = None, config: _Config = "default", *, threads: int = 0, out: Optional[np.ndarray] = None,
             **fields: Any) -> np.ndarray:
        return answer(name, given, config, threads=threads, out=out, **fields)

    call.__name__ = call.__qualname__ = name
    call.__doc__ = f"Returns the answers of the unit {name}: answer({name!r}, given, config, out=out, **fields)."
    return call


for _name in names():
    globals()[_name] = _make(_name)


def __getattr__(name: str) -> Any:   # tells type checkers that there are such functions
    raise AttributeError(f"no unit is called {name}")
