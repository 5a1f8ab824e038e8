# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Calls of the extension that the main thread leaves at once when Ctrl-C is pressed.

Python runs signal handlers in the main thread only. Some steps of the library cannot be interrupted,
for example the factorization of a matrix. Therefore another thread runs a call that can take long,
while the main thread waits. If a signal handler raises an exception, the call is canceled, and the
exception leaves although a step of the call may still run.
"""

from __future__ import annotations

import functools
import threading
from collections.abc import Callable
from queue import SimpleQueue
from typing import Any

from . import _core

# Steps on a smaller surface take less than half a second. Another thread takes 0.1 ms.
_MIN_POINTS = 50_000
# Most computations end in this time after they are canceled. Seconds.
_MAX_WAIT = 0.2


def interruptible(function: Callable[..., Any]) -> Callable[..., Any]:
    """Returns a function that calls another one beside the main thread.

    A method of an object with few points, and a function with a callback, are called directly:
    users expect that a callback is called by their thread.
    """

    @functools.wraps(function)
    def call(*arguments: Any) -> Any:
        is_direct = (
            threading.current_thread() is not threading.main_thread()
            or getattr(next(iter(arguments), None), "number_of_points", _MIN_POINTS) < _MIN_POINTS
            or _has_callback(arguments)
        )
        return function(*arguments) if is_direct else _call_beside(function, arguments)

    return call


def _has_callback(arguments: tuple[Any, ...]) -> bool:
    return any(
        _has_callback(argument) if isinstance(argument, tuple)
        else callable(argument) and not isinstance(argument, type)  # as the type of an array
        for argument in arguments
    )


def _call_beside(function: Callable[..., Any], arguments: tuple[Any, ...]) -> Any:
    outcome: SimpleQueue[tuple[Any, BaseException | None]] = SimpleQueue()
    cancellation = _core.Cancellation()

    def run() -> None:
        try:
            outcome.put((cancellation.call(function, *arguments), None))
        except BaseException as error:  # noqa: BLE001 - the main thread raises it
            outcome.put((None, error))

    thread = threading.Thread(target=run, name="geodesic_processing")
    thread.start()
    try:
        result, error = outcome.get()
    except BaseException:
        cancellation.cancel()
        thread.join(_MAX_WAIT)
        raise
    if error is not None:
        raise error
    return result


def _wrap_extension() -> None:
    """Replaces the methods, and functions whose steps take long, by interruptible ones."""
    for name in ("make_cloud", "cloud_of_content", "decode_wavelets", "read"):
        setattr(_core, name, interruptible(getattr(_core, name)))
    for cls in (
        _core.Mesh, _core.Cloud, _core.Mesh_solver, _core.Cloud_solver, _core.Volumetric_metric,
        _core.Mesh_base_map, _core.Cloud_base_map, _core.Wavelet,
    ):
        for name, function in list(vars(cls).items()):
            if not name.startswith("__") and callable(function):
                setattr(cls, name, interruptible(function))


_wrap_extension()
