"""Checks of the arrays that the compiled module receives. Each fault raises an Error with one sentence.

All arrays follow one rule. An array of another byte order or layout is copied once. Other types and shapes are
refused. The number of rows is checked before anything is copied.
"""
from __future__ import annotations

from typing import Any

import numpy as np

from ._rayclock import Error


def _array(name: str, value: Any) -> np.ndarray:
    if isinstance(value, np.ndarray):
        array = value
    else:
        try:
            array = np.asarray(value)
        except ValueError:
            raise Error(f"{name}: the rows have different lengths") from None
    if array.dtype == object:
        raise Error(f"{name}: an array of Python objects is not taken")
    return array


def _shape(array: np.ndarray) -> str:
    return " x ".join(map(str, array.shape)) if array.ndim else "a single number"


def table(name: str, value: Any, columns: tuple[int, ...], kinds: str, most: int, dtype: Any = None) -> np.ndarray:
    """Returns an array of rows in C order and native byte order.

    `kinds` has a letter for each accepted kind: f for float32 and float64, i for whole numbers. `most` is the
    largest number of rows. `dtype` is the type of the result; without it the array's own type.
    """
    array = _array(name, value)
    wanted = " or ".join(map(str, columns))
    if array.ndim != 2 or array.shape[1] not in columns:
        raise Error(f"{name}: the shape must be n x {wanted}, not {_shape(array)}")
    check_rows(name, array, most)
    return numbers(name, array, kinds, dtype)


def column(name: str, value: Any, rows: int, kinds: str, dtype: Any) -> np.ndarray:
    """Returns an array of one number for each of `rows`."""
    array = _array(name, value)
    if array.shape != (rows,):
        raise Error(f"{name}: the shape must be {rows}, not {_shape(array)}")
    return numbers(name, array, kinds, dtype)


def check_rows(name: str, array: np.ndarray, most: int) -> None:
    if len(array) > most:
        raise Error(f"{name}: {len(array)} rows are too many; the largest number is {most}")


def numbers(name: str, array: np.ndarray, kinds: str, dtype: Any = None) -> np.ndarray:
    """Returns the numbers in C order, native byte order and the given type."""
    is_float = array.dtype.kind == "f" and array.dtype.itemsize in (4, 8)
    is_whole = array.dtype.kind in "iu"
    if not (is_float and "f" in kinds or is_whole and "i" in kinds):
        words = {"f": "float32 or float64", "i": "whole numbers", "fi": "float32, float64 or whole numbers"}[kinds]
        raise Error(f"{name}: the numbers must be {words}, not {array.dtype}")
    native = np.dtype(dtype) if dtype is not None else array.dtype.newbyteorder("=")
    if is_whole and native.kind in "iu" and array.dtype != native and array.size:
        least, largest = int(array.min()), int(array.max())
        info = np.iinfo(native)
        if least < info.min or largest > info.max:
            wrong = least if least < info.min else largest
            raise Error(f"{name}: {wrong} does not fit in {native}")
    return np.ascontiguousarray(array, dtype=native)


def read_npy(raw: np.ndarray) -> np.ndarray:
    """Returns the array in the bytes of an .npy file that rayclock made. It is a view: nothing is copied."""
    import io

    head = io.BytesIO(raw[:4096].tobytes())
    version = np.lib.format.read_magic(head)
    if version != (1, 0):
        raise AssertionError(f"an array file of version {version}")
    shape, _, dtype = np.lib.format.read_array_header_1_0(head)
    return raw[head.tell():].view(dtype).reshape(shape)
