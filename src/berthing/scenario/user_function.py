"""Functions of the user's own, called so that what goes wrong in them is told as their mistake."""

from __future__ import annotations

import traceback
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from berthing.errors import BerthingError, InputError
from berthing.xp import Namespace, Scalar, Vector

Parameters = Mapping[str, Any]


def called(label: str, function: Callable[..., Any], *arguments: Any) -> Any:
    """``function(*arguments)``; InputError naming ``label`` where it raises."""
    try:
        return function(*arguments)
    except BerthingError:
        raise
    except Exception as error:
        last = traceback.extract_tb(error.__traceback__)[-1]
        found = f"{type(error).__name__}: {error}".removesuffix(": ")
        place = f"{Path(last.filename).name}, line {last.lineno}"
        raise InputError(label, f"raises {found} ({place})") from None


def sized(label: str, value: Any, size: int | None, xp: Namespace) -> Vector:
    """``value`` as a vector of ``size`` entries (any number, if None); InputError for others."""
    if value is None:
        raise InputError(label, "gives nothing", "a value")
    column = called(label, xp.vector, value)
    found = xp.size(column)
    if size is not None and found != size:
        raise InputError(label, f"gives {found} values", str(size))
    return column


@dataclass(frozen=True, eq=False)
class UserFunction:
    """f(t, x, u, p, xp) with its parameters.

    Attributes:
        label: what errors call it.
        function: of the time (s), the native state and control, ``parameters``, and the
            vocabulary of ``berthing.xp`` in the form asked for. It must not depend on anything
            else.
        parameters: p, as the function wants them.
    """

    label: str
    function: Callable[[Scalar, Vector, Vector, Any, Namespace], Any]
    parameters: Parameters = field(default_factory=dict)

    def __call__(
        self, t: Scalar, x: Vector, u: Vector, xp: Namespace, size: int | None = None
    ) -> Vector:
        """The values as a vector of ``size`` entries, or as many as there are.

        Raises:
            InputError: the function raises, or gives another number of values.
        """
        value = called(self.label, self.function, t, x, u, self.parameters, xp)
        return sized(self.label, value, size, xp)
