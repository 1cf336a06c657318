"""Stubs, docstrings and types of the compiled part."""

from __future__ import annotations

import doctest
import inspect
import sys
from typing import Any

import asperity
import mypy.stubtest
import pytest
from asperity import _asperity

CLASSES = [value for value in vars(_asperity).values() if inspect.isclass(value)]


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
