"""What some questions are answered with."""

from pforms.records.drawn import (
    Mesh,
    Polyline,
    Solid,
)
from pforms.records.geodesics import (
    Connection,
    Geodesic,
    Geodesics,
)
from pforms.records.made import (
    Bicubic,
    Fit,
    Joined,
    Minimal,
    Network,
    Parallel,
    Pipe,
    Simplified,
    UnitSpeed,
    Unrolling,
)
from pforms.records.measures import (
    Box,
    Continuity,
    Developability,
    Folds,
    Frame,
    Inertia,
    Length,
    Measure,
    Ratios,
)
from pforms.records.planks import (
    Marks,
    Plank,
)
from pforms.records.searches import (
    Branch,
    Crossings,
    Feet,
    Intersection,
    Inversion,
    Overlap,
    Projection,
)

__all__ = [
    "Bicubic",
    "Box",
    "Branch",
    "Connection",
    "Continuity",
    "Crossings",
    "Developability",
    "Feet",
    "Fit",
    "Folds",
    "Frame",
    "Geodesic",
    "Geodesics",
    "Inertia",
    "Intersection",
    "Inversion",
    "Joined",
    "Length",
    "Marks",
    "Measure",
    "Mesh",
    "Minimal",
    "Network",
    "Overlap",
    "Parallel",
    "Pipe",
    "Plank",
    "Polyline",
    "Projection",
    "Ratios",
    "Simplified",
    "Solid",
    "UnitSpeed",
    "Unrolling",
]
