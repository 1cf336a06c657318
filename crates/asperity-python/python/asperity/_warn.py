"""Warnings of answers, one for each cause and line."""

from __future__ import annotations

import re
import sys
import warnings

from asperity._asperity import ContactWarning

#: Numbers in a message, not the digits of names: one cause has others at every load.
_NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(\.\d+)?(e[-+]?\d+)?")


def warn(message: str, above: int) -> None:
    """Emits a ``ContactWarning`` at the line ``above`` frames above the caller.

    Python shows a message once for a line that runs often, unless its filters say otherwise. Messages
    that differ only in their numbers, as those of a loop over loads, count as one message here.
    """
    frame = sys._getframe(above + 1)
    name, line = frame.f_globals.get("__name__") or "<unknown>", frame.f_lineno
    # What Python has shown; it clears this dict when the filters have changed.
    shown = frame.f_globals.setdefault("__warningregistry__", {})
    this = message, ContactWarning, line
    cause = _NUMBER.sub("#", message), *this[1:]
    if cause in shown:
        shown[this] = True
    warnings.warn_explicit(*this[:2], frame.f_code.co_filename, line, name, shown)
    if this in shown:
        shown[cause] = True
