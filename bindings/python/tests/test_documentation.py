"""Every public name says what it does, with an example that runs."""

import doctest
import importlib
import inspect

import numpy as np
import pytest

import pforms as pf

MODULES = [
    "pforms",
    "pforms.either",
    "pforms.errors",
    "pforms.files",
    "pforms.records.drawn",
    "pforms.records.geodesics",
    "pforms.records.made",
    "pforms.records.measures",
    "pforms.records.searches",
]
CLASSES = [pf.Form, pf.Spline, pf.Immersed, pf.Sheet]


def documented():
    for name in pf.__all__:
        thing = getattr(pf, name)
        if callable(thing) and not (inspect.isclass(thing) and issubclass(thing, Exception)):
            yield name, thing.__doc__
    for cls in CLASSES:
        for name, member in vars(cls).items():
            if name.startswith("_") or isinstance(member, type):
                continue
            yield f"{cls.__name__}.{name}", member.__doc__


DOCUMENTED = dict(documented())


@pytest.mark.parametrize("name", DOCUMENTED)
def test_every_example_runs(name):
    text = DOCUMENTED[name]
    assert text, f"{name} says nothing"
    examples = doctest.DocTestParser().get_doctest(text, {"pf": pf, "np": np}, name, None, None)
    assert examples.examples, f"{name} shows nothing"
    said = []
    doctest.DocTestRunner(verbose=False).run(examples, out=said.append)
    assert not said, "".join(said)


@pytest.mark.parametrize("module", MODULES)
def test_every_example_of_a_module_runs(module):
    assert (
        doctest.testmod(importlib.import_module(module), extraglobs={"pf": pf, "np": np}).failed
        == 0
    )


def test_calls_are_documented():
    for cls in (pf.Form, pf.Spline, pf.Immersed):
        assert len(cls.__call__.__doc__) > 20


@pytest.mark.parametrize(
    ("name", "signature"),
    [
        ("interpolate", "(net, nodes='uniform', homogeneous=False)"),
        ("immerse", "(inner, host, lazy=False)"),
        ("stretch", "(self, /, a, b)"),
        ("diagonal", "(self, /, axes=None)"),
        ("evaluate", "(self, /, *parameters, derivative=None, out=None)"),
    ],
)
def test_signatures_can_be_read(name, signature):
    assert str(inspect.signature(getattr(pf, name))) == signature
