"""Sheets: values, errors that name their cell, exact arithmetic, names, history, files."""

import pickle
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

import pforms as pf

SHEETS = Path(__file__).parents[3] / "cases" / "sheets"


@pytest.fixture
def sheet():
    return pf.Sheet(
        """
pfs = 1
title = "Facet"
[cells]
A1 = "[(0, 0, 0), (1, 0, 1)]"
A2 = "[(0, 1, 1), (1, 1, 0)]"
A3 = "=MIR(A1, A2)"
A4 = "=DIAG(facet)"
[names]
facet = "A3"
"""
    )


def test_cells_are_computed(sheet):
    assert sheet["A3"].kind == "pS22"
    assert sheet["A4"] == sheet["A3"].diagonal()
    assert sheet["facet"] == sheet["A3"] == sheet["a3"] == sheet["$A$3"]
    assert sheet["Z99"] is None
    assert sheet["A1:A2"] == [sheet["A1"], sheet["A2"]]
    assert len(sheet) == 4
    assert list(sheet) == ["A1", "A2", "A3", "A4"]
    assert "A4" in sheet
    assert "facet" in sheet
    assert "B7" not in sheet
    assert "no place" not in sheet
    assert 7 not in sheet
    assert sheet.cells()["A4"] == "=DIAG(facet)"
    assert sheet.names == {"facet": "A3"}
    assert repr(sheet) == "<pforms.Sheet of 4 cells>"
    assert not sheet.exact


def test_every_kind_of_value(sheet):
    texts = {
        "B1": "=1/4",
        "B2": "=1 < 2",
        "B3": "hello",
        "B4": "[1, [2, 3]]",
        "B5": "=SUBDIVIDE(A1, 1)",
        "B6": "=IMMERSE([(0, 0), (1, 1)], A3, lazy: TRUE)",
        "B7": '=FORECAST("pL2", "pS22")',
        "B8": "(1, 2; 0)",
    }
    for place, text in texts.items():
        sheet[place] = text
    assert sheet.errors() == {}
    assert sheet["B1"] == 0.25
    assert sheet["B2"] is True
    assert sheet["B3"] == "hello"
    assert sheet["B4"] == [1.0, [2.0, 3.0]]
    assert sheet["B5"] == sheet["A1"].subdivide(1)
    assert sheet["B6"].expand() == sheet["A4"]
    assert sheet["B7"]["poles"] == 3
    assert sheet["B8"].homogeneous.tolist() == [1, 2, 0]


def test_setting_a_cell_recalculates(sheet, make):
    sheet["A1"] = "[(0, 0, 0), (1, 0, 9)]"
    assert sheet["A3"].poles[0, 1].tolist() == [1, 0, 9]
    for form in (make(), make(3), make(2, 3), make(2, ambient=1), make(2, 2, 2, rational=False)):
        sheet["C1"] = form
        np.testing.assert_allclose(sheet["C1"].homogeneous, form.homogeneous, rtol=1e-15)
        assert sheet["C1"].orders == form.orders
    sheet["C1"] = pf.Form([(1, 2), (3, 4)], [0, -1])
    assert sheet["C1"].homogeneous.tolist() == [[1, 2, 0], [-3, -4, -1]]
    for number in (7, -0.5, 1e-300, 1e300, np.float32(0.1), Fraction(1, 4), True):
        sheet["C2"] = number
        assert sheet["C2"] == float(number)
    sheet["C2"] = None
    assert "C2" not in sheet
    del sheet["C1"]
    assert sheet["C1"] is None
    sheet["facet"] = "(1, 2, 3)"
    assert sheet["A3"].kind == "pP"


def test_an_error_is_raised_with_the_cell_it_came_from(sheet):
    sheet["A1"] = "=1/0"
    with pytest.raises(pf.DomainError, match="A1"):
        sheet["A4"]
    sheet["A1"] = "=MIR((0, 0), (1, 2, 3))"
    with pytest.raises(pf.ShapeError, match="A1"):
        sheet["A4"]
    sheet["A1"] = "=A4"
    with pytest.raises(pf.PformsError, match="A1 → A4 → A3 → A1"):
        sheet["A4"]
    assert set(sheet.errors()) == {"A1", "A3", "A4"}
    sheet["A1"] = "=MIR(("
    with pytest.raises(pf.FormatError):
        sheet["A1"]
    assert "A2" not in sheet.errors()


def test_exact_sheets_hold_fractions(sheet):
    exact = pf.Sheet(str(sheet), exact=True)
    exact["B1"] = "=1/3"
    exact["B2"] = "0.1"
    exact["B3"] = "=POINT(A4, B1)"
    assert exact.exact
    assert exact["B1"] == Fraction(1, 3)
    assert exact["B2"] == Fraction(1, 10)
    point = exact["B3"]
    assert point.dtype == object
    assert point.tolist() == [Fraction(1, 3), Fraction(1, 3), Fraction(4, 9), 1]
    assert exact["A3"].shape == (2, 2, 4)
    exact["B4"] = "=SQRT(2)"
    with pytest.raises(pf.DomainError, match=r"B4, SQRT, x: received 2"):
        exact["B4"]
    exact["B5"] = "=SUBDIVIDE(A1, 1)"
    assert exact["B5"].shape == (3, 4)
    assert repr(exact) == "<pforms.Sheet of 9 cells, exact>"


def test_names_and_history(sheet):
    sheet.set_name("curve", "A4")
    assert sheet["curve"] == sheet["A4"]
    assert sheet.undo()
    with pytest.raises(pf.FormatError, match="curve"):
        sheet["curve"]
    assert sheet.redo()
    sheet.set_name("curve", "")
    assert "curve" not in sheet.names
    before = sheet["A4"]
    sheet["A1"] = "[(5, 5, 5), (6, 6, 6)]"
    sheet.undo()
    assert sheet["A4"] == before
    for name, target in (("A1", "A2"), ("x", "somewhere"), ("1x", "A1"), ("", "A1")):
        with pytest.raises(pf.FormatError):
            sheet.set_name(name, target)


def test_files(sheet, tmp_path):
    path = tmp_path / "facet.pfs"
    sheet.save(path)
    again = pf.Sheet.load(path)
    assert str(again) == str(sheet) == path.read_text()
    assert again["A4"] == sheet["A4"]
    assert pf.Sheet.load(str(path), exact=True).exact
    assert isinstance(pf.load(path), pf.Sheet)
    assert str(pickle.loads(pickle.dumps(sheet))) == str(sheet)
    pf.save(sheet, tmp_path / "copy.pfs")
    assert (tmp_path / "copy.pfs").read_text() == str(sheet)
    with pytest.raises(FileNotFoundError, match="nowhere"):
        pf.Sheet.load(tmp_path / "nowhere.pfs")
    for path in (None, 7, ["a"]):
        with pytest.raises(pf.ArgumentError, match="path: received"):
            pf.Sheet.load(path)


def test_damage_is_told_with_its_place():
    with pytest.raises(pf.FormatError, match="line 3, column 1"):
        pf.Sheet('pfs = 1\n[cells]\nA0 = "1"\n')
    for text in ("x", "pfs = 9", "[cells]", "\0", "pfs = 1\n[cells"):
        with pytest.raises(pf.FormatError):
            pf.Sheet(text)


def test_places_and_values_that_are_none(sheet):
    for place in ("", "A0", "no place", "=A1", "A1:", "é" * 1000):
        with pytest.raises(pf.FormatError):
            sheet[place]
        with pytest.raises(pf.FormatError):
            sheet[place] = 1
    for place in (None, 1, ("A", 1), b"A1"):
        with pytest.raises(pf.ArgumentError, match="cell: received"):
            sheet[place]
    for value in (object(), [1, "a"], b"x", float("nan"), float("inf"), 1j, [1, 2]):
        with pytest.raises(pf.PformsError, match="value: received"):
            sheet["A1"] = value
    with pytest.raises(pf.FormatError):
        sheet["A1:A2"] = 1
    with pytest.raises(TypeError):
        pf.Sheet(7)


def test_threads_may_share_a_sheet(sheet):
    def work(k):
        sheet[f"D{k + 1}"] = f"={k}*2"
        return sheet[f"D{k + 1}"], sheet["A4"].kind

    with ThreadPoolExecutor(4) as pool:
        assert list(pool.map(work, range(40))) == [(2.0 * k, "pL3") for k in range(40)]


@pytest.mark.parametrize("path", sorted(SHEETS.glob("*.pfs")), ids=lambda path: path.stem)
def test_the_gallery_opens(path):
    sheet = pf.Sheet.load(path)
    assert len(sheet) > 0
    assert sheet.errors() == {}
    assert str(pf.Sheet(str(sheet))) == str(sheet)
