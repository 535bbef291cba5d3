"""Files of forms, and pictures of forms and sheets."""

import struct
from pathlib import Path

import numpy as np
import pytest

import pforms as pf

CASES = Path(__file__).parents[3] / "cases"


@pytest.mark.parametrize("orders", [(), (3,), (2, 3), (2, 2, 2)])
def test_a_form_survives_its_file_to_the_bit(make, tmp_path, orders):
    form = make(*orders)
    form.save(tmp_path / "form.json")
    assert pf.load(tmp_path / "form.json") == form
    pf.save([form, form], str(tmp_path / "forms.json"))
    assert pf.load(str(tmp_path / "forms.json")) == [form, form]


def test_the_teapot_is_read(tmp_path):
    [path] = CASES.glob("models/*teapot*.bpt")
    patches = pf.load(path)
    assert len(patches) == 32
    assert {patch.kind for patch in patches} == {"pS44"}
    pf.save(patches, tmp_path / "teapot.bpt")
    again = pf.load(tmp_path / "teapot.bpt")
    for patch, same in zip(patches, again, strict=True):
        np.testing.assert_allclose(same.poles, patch.poles, rtol=1e-12)


@pytest.mark.parametrize("ending", ["glb", "obj", "stl", "pov"])
def test_forms_and_sheets_are_drawn(make, tmp_path, ending):
    forms = [make(3, 3), make(3)]
    sheet = pf.Sheet.load(CASES / "sheets" / "octant.pfs")
    forms[0].save(tmp_path / "form.json")
    subjects = [
        forms[0],
        forms,
        iter(forms),
        sheet,
        CASES / "sheets" / "octant.pfs",
        tmp_path / "form.json",
    ]
    for subject in subjects:
        path = tmp_path / f"picture.{ending}"
        pf.draw(subject, path)
        content = path.read_bytes()
        assert len(content) > 100
        path.unlink()
    if ending == "obj":
        assert (tmp_path / "picture.mtl").exists()
    if ending == "stl":
        assert len(content) == 84 + 50 * struct.unpack_from("<I", content, 80)[0]
    if ending == "glb":
        assert content[:4] == b"glTF"


def test_a_style_and_a_camera_are_heeded(make, tmp_path):
    form, path = make(3, 3), tmp_path / "form.stl"
    pf.draw(form, path, fineness=2)
    coarse = path.stat().st_size
    pf.draw(form, path, fineness=4)
    assert path.stat().st_size > 10 * coarse
    pf.draw(form, tmp_path / "a.pov", camera={"view": "OX"}, color="#102030", axes=False)
    assert (tmp_path / "a.pov").stat().st_size > 0
    for options in ({"colour": "red"}, {"color": 7}, {"camera": {"lens": 1}}, {"draw": ["smoke"]}):
        with pytest.raises(pf.PformsError):
            pf.draw(form, path, **options)


def test_what_cannot_be_read_or_written_is_said(make, tmp_path):
    form = make(2)
    with pytest.raises(FileNotFoundError, match="nowhere"):
        pf.load(tmp_path / "nowhere.json")
    with pytest.raises(pf.FormatError, match="should end in"):
        form.save(tmp_path / "form.xyz")
    with pytest.raises(pf.FormatError):
        form.save(tmp_path / "form.stl")
    with pytest.raises(pf.PformsError):
        form.save(tmp_path / "form.bpt")
    with pytest.raises(OSError, match="nowhere"):
        form.save(tmp_path / "nowhere" / "form.json")
    with pytest.raises(pf.ArgumentError, match="path: received"):
        form.save(7)
    with pytest.raises(pf.ArgumentError, match="forms: received"):
        pf.save([1, 2], tmp_path / "form.json")
    with pytest.raises(pf.ShapeError, match="what: received"):
        pf.draw([], tmp_path / "form.glb")
    for content in (
        b"",
        b"{",
        b'{"pforms": 1}',
        b"\xff\xfe",
        b"[1, 2]",
        b'{"pforms": 1, "forms": [{}]}',
    ):
        (tmp_path / "damaged.json").write_bytes(content)
        with pytest.raises(pf.FormatError):
            pf.load(tmp_path / "damaged.json")
    assert not (tmp_path / "form.xyz").exists()
