"""Files of forms and sheets, and pictures of them."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, NamedTuple, TypeAlias

from pforms._pforms import Form, Sheet, Spline, _draw_forms, _read_forms, _write_forms

if TYPE_CHECKING:
    from collections.abc import Iterable

    from pforms.records import Mesh

_Path: TypeAlias = str | os.PathLike[str]


class _Look(NamedTuple):
    name: str
    library: str
    style: str
    camera: str
    axes: bool


def load(path: _Path) -> Form | Spline | list[Form | Spline] | Sheet:
    """What a file holds: a sheet (``.pfs``), a form or spline, or a list of several.

    Forms are read from ``.json`` and ``.bpt``.

    Raises
    ------
    FormatError
        When the file is damaged, with line and column where they are known.
    OSError
        When it cannot be read.

    Examples
    --------
    >>> pf.save([pf.Form((0, 0)), pf.Form((1, 1))], "two.json")
    >>> pf.load("two.json")
    [<pforms.Form pP in 2D>, <pforms.Form pP in 2D>]
    """
    from pathlib import Path

    file = Path(path)
    if file.suffix.lower() == ".pfs":
        return Sheet.load(file)
    forms = [form for _, form in _read_forms(file.name, file.read_bytes())]
    return forms[0] if len(forms) == 1 else forms


def save(what: Form | Spline | Iterable[Form | Spline] | Sheet, path: _Path) -> None:
    """Writes a sheet (``.pfs``), or forms and splines (``.json`` exactly, ``.bpt`` patches).

    Raises FormatError when the name ends in something else, OSError when writing fails.

    >>> pf.save(pf.Form((1, 2)), "point.json")
    >>> pf.load("point.json").poles
    array([1., 2.])
    """
    from pathlib import Path

    if isinstance(what, Sheet):
        what.save(path)
        return
    file = Path(path)
    file.write_bytes(_write_forms(file.name, what))


def draw(
    what: _Path | Form | Spline | Mesh | Iterable[Form | Spline | Mesh] | Sheet,
    out: _Path,
    *,
    axes: bool = True,
    camera: dict[str, Any] | None = None,
    **style: Any,  # noqa: ANN401
) -> None:
    """Draws forms, meshes, a sheet or a file into ``.glb``, ``.obj``, ``.stl`` or ``.pov``.

    Parameters
    ----------
    what : path, Form, Spline, Mesh, iterable of them, or Sheet
        A sheet is drawn as it says, with its styles and its camera.
    out : path
        The file to write; beside an OBJ stands one with its colours.
    axes : bool, optional
        Draw the axes of space.
    camera : dict, optional
        ``view`` and the other keys a sheet has for its camera.
    **style
        The keys a sheet has for a shown cell: ``draw=["surface", "net"]``, ``color="#f2c14e"``,
        ``fineness=5``, ``shading``, ``opacity``, ``radius``, ``count``, …

    Raises
    ------
    FormatError
        For an ending or a key that is unknown.
    ShapeError
        When what is asked for cannot be drawn.
    OSError
        When a file cannot be read or written.

    Examples
    --------
    >>> pf.draw(pf.Form([(0, 0, 0), (1, 2, 0), (2, 0, 1)]), "curve.glb", color="#f2c14e")
    """
    import json
    from pathlib import Path

    file = Path(out)
    if isinstance(what, str | os.PathLike):
        what = load(what)
    library = file.with_suffix(".mtl")
    look = _Look(file.name, library.name, json.dumps(style), json.dumps(camera or {}), axes)
    drawn = what._draw(look) if isinstance(what, Sheet) else _draw_forms(what, look)
    for path, content in zip((file, library), drawn, strict=False):
        path.write_bytes(content)
