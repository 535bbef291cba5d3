"""What can go wrong: one family, the same names in every face of pforms.

Every message names the argument, what was received for it and what was expected.

>>> import pforms as pf
>>> try:
...     pf.Form([(0, 0), (1, 1)]).sub(2, 0.5)
... except pf.ShapeError as error:
...     print(error)
axis: received 2, expected 0 to 0 for a pL2
"""

__all__ = [
    "AccuracyError",
    "ArgumentError",
    "DegenerateError",
    "DomainError",
    "FormatError",
    "LimitError",
    "PformsError",
    "ShapeError",
]


class PformsError(ValueError):
    """The family: whatever pforms raises about the values it was given."""

    __module__ = "pforms"


class ShapeError(PformsError):
    """Numbers of axes, orders or dimensions that do not fit together; ragged lists."""

    __module__ = "pforms"


class ArgumentError(ShapeError, TypeError):
    """An argument that is no number, array or form at all: also a ``TypeError``."""

    __module__ = "pforms"


class DomainError(PformsError):
    """A value outside the range where the answer exists: NaN, infinity, a vanishing weight."""

    __module__ = "pforms"


class DegenerateError(PformsError):
    """Data too special for the question: coincident nodes, the frame of a straight line."""

    __module__ = "pforms"


class AccuracyError(PformsError):
    """The accuracy asked for was not reached."""

    __module__ = "pforms"


class FormatError(PformsError):
    """A text or file that is not what it claims to be; the message has line and column."""

    __module__ = "pforms"


class LimitError(PformsError):
    """A result larger than the cap on allocations, or more work than anybody waits for."""

    __module__ = "pforms"
