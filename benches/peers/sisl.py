"""SISL: C, through the loops of `sisl.c`. The first parameter runs fastest in its arrays."""

from __future__ import annotations

import ctypes
import sys
from pathlib import Path

import numpy as np

from bernstein import Net
from contest import Array, MissingError

Argument = Array | int | float

SHIM = Path(sys.prefix) / "lib" / "libsisl_shim.so"


class Surface:
    """A surface of SISL, and the calls on it."""

    def __init__(self, net: Net) -> None:
        self._library = library()
        poles = np.ascontiguousarray(np.swapaxes(net.homogeneous, 0, 1))
        make = self._library.surface
        make.restype = ctypes.c_void_p
        n, m = net.orders
        self.pointer = ctypes.c_void_p(make(address(poles), poles.shape[-1], n, m))

    def call(self, name: str, *arguments: Argument) -> None:
        """Calls a function of the shim: arrays by address, floats as double, integers as long."""
        checked(self._library[name](self.pointer, *map(passed, arguments)))


def grids(surfaces: list[Surface], at: Array, points: Array) -> None:
    """Fills the points of many surfaces on the same grid."""
    pointers = (ctypes.c_void_p * len(surfaces))(*(surface.pointer.value for surface in surfaces))
    family: list[Argument] = [at, len(at), points, len(surfaces)]
    checked(library().grids(pointers, *map(passed, family)))


def library() -> ctypes.CDLL:
    if not SHIM.exists():
        raise MissingError("libsisl-dev is not installed")
    return ctypes.CDLL(str(SHIM))


def checked(status: int) -> None:
    if status < 0:
        raise RuntimeError(f"SISL says {status}")


def passed(argument: Argument) -> ctypes.c_void_p | ctypes.c_long | ctypes.c_double:
    if isinstance(argument, np.ndarray):
        return address(argument)
    return ctypes.c_long(argument) if isinstance(argument, int) else ctypes.c_double(argument)


def address(array: Array) -> ctypes.c_void_p:
    return ctypes.c_void_p(array.ctypes.data)
