"""Warnings of answers, one for each cause and line."""

from __future__ import annotations

import re
import sys
import warnings
from typing import Any

from asperity._asperity import ContactWarning

#: Numbers in a message, not the digits of names: one cause has others at every load.
_NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(\.\d+)?(e[-+]?\d+)?")

#: What has been shown under a list of filters, kept so that no other list has its id: file, line and
#: cause. Python forgets what it has shown when any library changes the filters, as NumPy and SciPy do
#: in passing; each context of warnings has a list of its own.
_shown: dict[int, tuple[Any, set[tuple[str, int, str]]]] = {}


def _action(message: str, module: str, line: int) -> str:
    """What Python's filters do with a warning."""
    filters: Any = warnings.filters
    for action, text, category, where, number in filters:
        if (
            issubclass(ContactWarning, category)
            and number in (0, line)
            and all(of is None or re.match(of, it) for of, it in ((text, message), (where, module)))
        ):
            return str(action)
    return "default"


def warn(message: str, above: int) -> None:
    """Emits a ``ContactWarning`` at the line ``above`` frames above the caller.

    A message is shown once for a line that runs often, unless the filters of Python say otherwise.
    Messages that differ only in their numbers, as those of a loop over loads, count as one message
    here.
    """
    frame = sys._getframe(1)
    for _ in range(above):
        # A pickle may be read at the top of a program.
        frame = frame.f_back or frame
    name, line = frame.f_globals.get("__name__") or "<unknown>", frame.f_lineno
    file = frame.f_code.co_filename
    registry: dict[Any, Any] = {}
    if _action(message, name, line) == "default":
        cause = file, line, _NUMBER.sub("#", message)
        filters = warnings.filters
        shown = _shown.setdefault(id(filters), (filters, set()))[1]
        if cause in shown:
            return
        shown.add(cause)
    else:
        registry = frame.f_globals.setdefault("__warningregistry__", {})
    warnings.warn_explicit(message, ContactWarning, file, line, name, registry)
