"""Maps of forms, of immersed forms and of lists of them."""

import numpy as np
import pytest

import pforms as pf

FACET = pf.Form([[(0, 0, 0), (0, 1, 1)], [(1, 0, 1), (1, 1, 0)]])
MAPS = [
    lambda f: f.transform(np.diag([2.0, 1, 1, 1])),
    lambda f: f.translate((1, 2, 3)),
    lambda f: f.rotate(0.5, (1, 1, 0), centre=(0, 0, 1)),
    lambda f: f.rotate((10, 20, 30), unit="degrees"),
    lambda f: f.rotate(2, plane=(2, 0), unit="half tangent"),
    lambda f: f.scale(2, centre=(1, 1, 1)),
    lambda f: f.shear(2, (1, 0, 0)),
    lambda f: f.mirror((1, 2, 2)),
    lambda f: f.project_to_plane((0, 0, 1), direction=(1, 0, 1)),
    lambda f: f.project_to_plane((0, 0, 1), lamp=(0, 0, 5)),
]


@pytest.mark.parametrize("move", MAPS)
def test_an_immersed_form_moves_with_its_host(move):
    lazy = pf.immerse(pf.Form([(0, 0), (1, 1)]), FACET, lazy=True)
    assert isinstance(move(lazy), pf.Immersed)
    np.testing.assert_allclose(move(lazy)(0.3), move(FACET)(0.3, 0.3), rtol=0, atol=1e-15)


def test_a_list_gives_a_list():
    both = pf.translate([FACET, pf.Form((0, 0, 0))], (1, 0, 0))
    assert both == [FACET.translate((1, 0, 0)), pf.Form((1.0, 0, 0))]
    assert pf.rotate([], 1) == []


def test_a_point_will_do_for_a_vector():
    assert FACET.translate(pf.Form((1, 2, 3))) == FACET.translate((1, 2, 3))


def test_matrices_compose():
    a, b = np.arange(16.0).reshape(4, 4), np.eye(4)[::-1]
    assert FACET.transform(a).transform(b) == FACET.transform(b @ a)
    assert FACET.transform(np.eye(3, 4)).ambient == 2


@pytest.mark.parametrize(
    "wrong",
    [
        lambda: FACET.translate((1, 2)),
        lambda: FACET.rotate((1, 2)),
        lambda: FACET.rotate(1, (0, 0, 1), plane=(0, 1)),
        lambda: FACET.rotate(1, plane=(0, 3)),
        lambda: FACET.rotate(1, plane=(0, 1, 2)),
        lambda: FACET.transform([1, 2, 3]),
        lambda: FACET.project_to_plane((0, 0, 1), direction=(0, 0, 1), lamp=(0, 0, 1)),
        lambda: pf.translate("form", (1, 2, 3)),
        lambda: pf.translate([FACET, 1], (1, 2, 3)),
        lambda: pf.translate(None, (1, 2, 3)),
    ],
)
def test_what_does_not_fit_is_a_shape_error(wrong):
    with pytest.raises(pf.ShapeError):
        wrong()


def test_words_are_known():
    with pytest.raises(pf.DomainError, match="half tangent"):
        FACET.rotate(1, unit="turns")
    with pytest.raises(pf.DegenerateError):
        FACET.mirror((0, 0, 0))
    with pytest.raises(pf.DomainError):
        FACET.scale(np.nan)
