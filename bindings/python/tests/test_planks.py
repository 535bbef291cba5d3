"""Planks: what may be given for lines, and what is answered."""

import numpy as np
import pytest

import pforms as pf

SPHERE = pf.sphere(1)
LINE = pf.geodesic(SPHERE, (0.3, 0.2), (1, 0.4), 1.0)


def test_lines_come_in_many_ways():
    between = pf.geodesic_between(SPHERE, (0.3, 0.2), (0.4, 0.3))
    for given in (LINE, LINE.parameters, between):
        assert isinstance(pf.planks(SPHERE, given, 0.1), pf.records.Plank)
        assert len(SPHERE.planks([given], 0.1)) == 1
    flat = pf.Form([[(0, 0, 0), (0, 1, 0)], [(1, 0, 0), (1, 1, 0)]])
    one = pf.planks(flat, [(0, 0.5), (1, 0.5)], 0.1)
    two = pf.planks(flat, [[(0, 0.5), (1, 0.5)], [(0.5, 0), (0.5, 1)]], 0.1)
    net = pf.planks(flat, pf.Form([[(0, 0.5), (1, 0.5)], [(0.5, 0), (0.5, 1)]]), 0.1)
    mixed = pf.planks(flat, [pf.Form([(0, 0.5), (1, 0.5)]), [(0.5, 0), (0.5, 1)]], 0.1)
    assert one.length == two[0].length == net[0].length == mixed[0].length
    assert two[1].marks.others == net[1].marks.others == mixed[1].marks.others == [0]


@pytest.mark.parametrize(
    "lines",
    [
        None,
        3,
        "line",
        [],
        [None],
        ["x"],
        pf.geodesic(SPHERE, [(0.3, 0.2)], (1, 0), 1),
        {},
        (LINE, 1),
    ],
)
def test_what_is_no_line_is_refused(lines):
    with pytest.raises(pf.PformsError):
        pf.planks(SPHERE, lines, 0.1)


def test_marks_can_be_left_out_and_the_same_line_overlaps():
    boards = pf.planks(SPHERE, [LINE, LINE], 0.1)
    assert boards[0].overlaps == [1]
    assert boards[1].overlaps == [0]
    assert pf.planks(SPHERE, [LINE, LINE], 0.1, marks=False)[0].overlaps == []


def test_the_strip_and_its_outline_are_isometric():
    torus = pf.torus(3, 1.5)
    board = pf.planks(torus, pf.geodesic(torus, (0.1, 0.05), 1.3, 6), 0.5)
    corners = board.outline.net.poles[:4]
    at = np.linspace(0, board.length, 20001)
    for side, ends in ((0.0, (0, 1)), (1.0, (3, 2))):
        edge = board.strip(at, np.full_like(at, side))
        long = np.linalg.norm(np.diff(edge, axis=0), axis=1).sum()
        assert abs(long - np.linalg.norm(corners[ends[1]] - corners[ends[0]])) < 1e-6
