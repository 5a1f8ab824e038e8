# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the modules share."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from typing import Any, NoReturn


def not_covered(name: str) -> NotImplementedError:
    """Returns the exception for a function, a method, or an option."""
    return NotImplementedError(f"{name} is not covered by geodesic_processing.")


def missing_method(name: str) -> Callable[..., NoReturn]:
    """Returns a method that raises NotImplementedError with its name."""

    def method(*_: Any, **__: Any) -> NoReturn:
        raise not_covered(name)

    method.__doc__ = "Raises ``NotImplementedError``."
    method.__qualname__ = name
    method.__name__ = name.rpartition(".")[2]
    return method


def missing_names(module: str, *names: str) -> Callable[[str], NoReturn]:
    """Returns the function ``__getattr__`` of a module in which names are missing."""

    def __getattr__(name: str) -> NoReturn:
        if name in names:
            raise not_covered(f"{module.rpartition('.')[2]}.{name}")
        raise AttributeError(f"module {module!r} has no attribute {name!r}")

    return __getattr__


def require_default(name: str, value: Any, default: Any) -> None:
    """Raises NotImplementedError with the name of an option that has another value."""
    if value != default:
        raise not_covered(f"{name} = {value!r}")


def scipy_sparse() -> Any:
    """Returns the module ``scipy.sparse``. It has no type hints, and only matrices need it."""
    return import_module("scipy.sparse")
