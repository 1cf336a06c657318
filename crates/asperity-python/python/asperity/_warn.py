"""Warnings of answers, one for each cause and line."""

from __future__ import annotations

import re
import sys
import warnings

from asperity._asperity import ContactWarning

#: Numbers in a message, not the digits of names: one cause has others at every load.
_NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(\.\d+)?(e[-+]?\d+)?")
#: File, line and message without numbers of messages shown under these filters.
_shown: set[tuple[str, int, str]] = set()
_filters: list[object] = []
_snapshot: list[object] = []


def warn(message: str, above: int) -> None:
    """Emits a ``ContactWarning`` at the line ``above`` frames above the caller.

    Python shows a message once for a line that runs often, unless its filters say otherwise. Messages
    that differ only in their numbers, as those of a loop over loads, count as one message here.
    """
    frame = sys._getframe(above + 1)
    module = frame.f_globals.get("__name__") or "<unknown>"
    place = frame.f_code.co_filename, frame.f_lineno
    if _once(message, module, place[1]):
        _clear_if_changed()
        cause = *place, _NUMBER.sub("#", message)
        if cause in _shown:
            return
        _shown.add(cause)
    warnings.warn(message, ContactWarning, stacklevel=above + 2)


def _once(message: str, module: str, line: int) -> bool:
    """Whether the first filter that applies shows a message once for a line."""
    for action, text, category, of, number in warnings.filters:
        named = (text is None or re.match(text, message)) and (of is None or re.match(of, module))
        if named and issubclass(ContactWarning, category) and number in (0, line):
            return action in ("default", "module", "once")
    return True


def _clear_if_changed() -> None:
    """Clears what was shown when the filters have changed, as Python does."""
    global _filters, _snapshot
    if warnings.filters is not _filters or warnings.filters != _snapshot:
        _shown.clear()
        _filters, _snapshot = warnings.filters, list(warnings.filters)  # type: ignore[assignment]
