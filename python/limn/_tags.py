"""What is sharp, as keywords: one list for all that take them."""

from __future__ import annotations

from typing import Any, Mapping

TAGS = (
    "creases",
    "crease_sharpness",
    "corners",
    "corner_sharpness",
    "holes",
    "boundary",
    "crease_method",
    "triangles",
)


def tags_of(arguments: Mapping[str, Any]) -> dict[str, Any]:
    """Those of a function's arguments, which are its ``locals()``, that say what is sharp."""
    return {name: arguments[name] for name in TAGS}
