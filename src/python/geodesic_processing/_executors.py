# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Calls of functions in the workers of an executor: threads, processes, or other machines."""

from __future__ import annotations

import os
import pickle
import socket
import threading
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Executor, Future, wait
from typing import Any, NamedTuple

from ._base import Base
from ._core import Cancelled
from ._types import Callback

# The surfaces that this process has received, by their hashes. A worker of a pool can serve many
# surfaces; it keeps the last ones.
_received: dict[str, Base] = {}
_max_received = 4
# The surfaces whose tasks this process distributes. Its threads, and processes that are forked from
# it, do not need to receive them.
_distributed: dict[str, Base] = {}


class _Reply(NamedTuple):
    """What a task returns."""

    process: str
    """The process of the worker, different from all others."""
    thread: int
    """The thread of the worker in this process."""
    is_missing: bool
    """Whether the worker does not have the surface."""
    result: Any


class _Task(NamedTuple):
    position: int
    """That of its arguments."""
    has_surface: bool
    """Whether the surface is sent with the task."""


def _call(
    content_hash: str | None, content: bytes | None, function: Callable[..., Any], arguments: Any
) -> _Reply:
    """Calls a function in a worker. Without the surface of this hash, only says that it is missing.

    If there is no hash, the function needs no surface.
    """
    if content_hash is not None:
        surface = _surface_of(content_hash, content)
        is_missing = surface is None
        result = None if is_missing else function(surface, *arguments)
    else:
        is_missing, result = False, function(*arguments)
    process = f"{socket.gethostname()}:{os.getpid()}"
    return _Reply(process, threading.get_ident(), is_missing, result)


def _surface_of(content_hash: str, content: bytes | None) -> Base | None:
    surface = _distributed.get(content_hash) or _received.get(content_hash)
    if surface is None and content is not None:
        surface = pickle.loads(content)
        _received[content_hash] = surface
        for oldest in list(_received)[:-_max_received]:
            _received.pop(oldest, None)
    return surface


class _Distribution:
    """Distributes tasks to workers, and surfaces to workers that do not have them.

    An executor does not let us choose the worker of a task. Therefore a task only has the hash of
    its surface at first. If a worker says that the surface is missing, the next task has the surface
    and this worker, which is idle, receives it. While a surface is on its way, the queue is short, so
    that no other worker takes this task.
    """

    def __init__(
        self,
        executor: Executor,
        surface: Base | None,
        function: Callable[..., Any],
        arguments: Sequence[Sequence[Any]],
    ) -> None:
        self._executor = executor
        self._surface = surface
        self._function = function
        self._arguments = arguments
        self._waiting = deque(range(len(arguments)))
        self._running: dict[Future[_Reply], _Task] = {}
        self._threads: set[tuple[str, int]] = set()  # that have replied
        self._processes: set[str] = set()  # of these threads
        self._lacking: set[str] = set()  # processes that do not have the surface yet
        self._content: bytes | None = None
        self._number_of_transfers = 0
        self._number_of_missing_replies = 0  # since the last transfer or result

    def results(self) -> Iterator[tuple[int, Any]]:
        """Yields the positions of the arguments, and the results, in the order of completion."""
        content_hash = None if self._surface is None else self._surface.content_hash
        if content_hash is not None and self._surface is not None:
            _distributed[content_hash] = self._surface
        try:
            while self._waiting or self._running:
                try:
                    self._submit_tasks(content_hash)
                except BrokenExecutor:
                    while self._running:  # tasks can be completed
                        yield from self._completed()
                    raise
                yield from self._completed()
        finally:
            for future in self._running:
                future.cancel()
            if content_hash is not None:
                _distributed.pop(content_hash, None)

    def _submit_tasks(self, content_hash: str | None) -> None:
        while self._waiting and len(self._running) < self._max_running():
            task = _Task(self._waiting.popleft(), self._is_surface_needed())
            content = None
            if task.has_surface:
                self._content = self._content or pickle.dumps(self._surface)
                self._number_of_transfers += 1
                self._number_of_missing_replies = 0
                content = self._content
            future = self._executor.submit(
                _call, content_hash, content, self._function, self._arguments[task.position]
            )
            self._running[future] = task

    def _max_running(self) -> int:
        """Returns the number of tasks that are submitted, but not completed.

        The number of workers is not known, because executors do not tell it. One task more than the
        known threads finds new workers. If all of them have the surface, each has a second task,
        and some more find new workers faster.
        """
        threads = len(self._threads)
        return threads + 1 if self._lacking else 2 * threads + 16

    def _is_surface_needed(self) -> bool:
        """Returns whether the next task has the surface.

        One transfer for each process suffices, unless another worker takes the task. This can happen
        once. If it happens again, the surface is sent only if workers without it take all tasks: the
        others compute for a long time, or have ended.
        """
        on_the_way = sum(task.has_surface for task in self._running.values())
        is_taken = self._number_of_missing_replies > 2 * len(self._threads)
        is_allowed = self._number_of_transfers <= len(self._processes) or is_taken
        return on_the_way < len(self._lacking) and is_allowed

    def _completed(self) -> Iterator[tuple[int, Any]]:
        """Yields results that exist. Raises the exception of a task after the other results."""
        done, _ = wait(self._running, return_when=FIRST_COMPLETED)
        failed: Future[_Reply] | None = None
        for future in done:
            task = self._running.pop(future)
            if future.cancelled() or future.exception() is not None:
                failed = future
                continue
            reply = future.result()
            self._threads.add((reply.process, reply.thread))
            self._processes.add(reply.process)
            if reply.is_missing:
                self._lacking.add(reply.process)
                self._waiting.appendleft(task.position)
                self._number_of_missing_replies += 1
            else:
                self._lacking.discard(reply.process)
                self._number_of_missing_replies = 0
                yield task.position, reply.result
        if failed is not None:
            failed.result()


def distribute(
    executor: Executor | None,
    surface: Base | None,
    function: Callable[..., Any],
    arguments: Sequence[Sequence[Any]],
    callback: Callback | None = None,
) -> Iterator[tuple[int, Any]]:
    """Calls ``function(surface, *a)`` for each ``a`` of the arguments in the workers of an executor.

    Yields the position of ``a`` and the result, in the order of completion. Without a surface, calls
    ``function(*a)``. Without an executor, this thread calls the function. After each result is used,
    the callback receives the completed fraction. Raises the exception of a call, and that of a broken
    executor, after all results that exist. Raises ``Cancelled`` if the callback returns a false value
    other than ``None``.
    """
    results: Iterator[tuple[int, Any]]
    if executor is None:
        first = () if surface is None else (surface,)
        results = ((i, function(*first, *a)) for i, a in enumerate(arguments))
    else:
        results = _Distribution(executor, surface, function, arguments).results()
    for number_of_results, result in enumerate(results, 1):
        yield result
        if callback is not None:
            answer = callback(number_of_results / len(arguments))
            if answer is not None and not answer:
                raise Cancelled("The callback has cancelled the computation.")


def map(  # noqa: A001 - as the function of Python
    function: Callable[[Any], Any],
    shapes: Iterable[Any],
    *,
    executor: Executor | None = None,
    callback: Callback | None = None,
) -> list[Any]:
    """Calls ``function(shape)`` for each shape of a collection, in the workers of an executor.

    Parameters
    ----------
    function
        A function that a worker can import, because it is sent by its name.
    shapes
        Surfaces, or other objects that can be pickled. File names are smaller than surfaces: if
        workers have access to the files, let the function read them.
    executor
        Any ``concurrent.futures.Executor``, for example a ``ProcessPoolExecutor``, the executor of a
        Dask client, or an ``MPIPoolExecutor``. By default, this thread calls the function.
    callback
        A function that takes the completed fraction. It is called in this thread.

    Returns
    -------
    The results, in the order of the shapes. Each shape is sent once.

    Raises the exception of a call, or that of the executor if a worker has died; other results are
    then lost. Raises ``Cancelled`` if the callback returns a false value.
    """
    arguments = [(shape,) for shape in shapes]
    results: list[Any] = [None] * len(arguments)
    for index, result in distribute(executor, None, function, arguments, callback):
        results[index] = result
    return results
