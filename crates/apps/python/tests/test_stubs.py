"""Stubs, docstrings and types of the compiled part."""

from __future__ import annotations

import doctest
import inspect
import os
import re
import sys
from pathlib import Path
from typing import Any

import asperity
import mypy.stubtest
import pytest
from asperity import _asperity, _records

CLASSES = [value for value in vars(_asperity).values() if inspect.isclass(value)]


def numbers(section: str) -> str:
    """The numbers of a section of scene files in the stub of its record."""
    call, attributes = "", ""
    for name, unit, required, _ in _asperity.numbers_of(section):
        kind, none = "_Number" if unit else "_Float", "" if required else " | None"
        call += f"        {name}: {kind}{none}{none and ' = None'},\n"
        attributes += f"    {name}: Final[float{none}]\n"
    return f"    def __init__(\n        self,\n{call}    ) -> None: ...\n{attributes}"


def test_the_stub_of_records_has_the_numbers_of_scene_files() -> None:
    """ASPERITY_BLESS=1 writes it."""
    stub = Path(_records.__file__).with_suffix(".pyi")
    text = stub.read_text()
    for name in ("Body", "Interface", "Surface"):
        part = re.compile(f"(    # numbers of {name}\\n).*?(    # end\\n)", re.DOTALL)
        text = part.sub(lambda found: found[1] + numbers(name.lower()) + found[2], text)  # noqa: B023
    if os.environ.get("ASPERITY_BLESS"):
        stub.write_text(text)
    assert stub.read_text() == text


def test_stubs_are_those_of_the_module(capsys: pytest.CaptureFixture[str]) -> None:
    options = mypy.stubtest.parse_options(["asperity._asperity", "asperity._records", "--concise"])
    findings = mypy.stubtest.test_stubs(options)
    assert findings == 0, capsys.readouterr().out


def test_everything_public_has_a_docstring() -> None:
    for owner in [*CLASSES, asperity, *(getattr(asperity, name) for name in asperity.__all__)]:
        assert inspect.getdoc(owner), owner
        if not inspect.isclass(owner):
            continue
        for name, member in vars(owner).items():
            public = not name.startswith("_")
            if public and (callable(member) or inspect.isdatadescriptor(member)):
                assert inspect.getdoc(member), f"{owner.__name__}.{name}"


@pytest.mark.parametrize(
    "owner", [*CLASSES, asperity.random_surface], ids=lambda owner: str(owner.__name__)
)
def test_examples_in_docstrings_of_the_compiled_part(owner: Any) -> None:
    runner = doctest.DocTestRunner(verbose=False)
    parser = doctest.DocTestParser()
    for name, member in [(owner.__name__, owner), *getattr(owner, "__dict__", {}).items()]:
        text = inspect.getdoc(member) if member is owner or not name.startswith("_") else None
        if text:
            runner.run(parser.get_doctest(text, {}, name, None, None), out=sys.stdout.write)
    assert runner.failures == 0
