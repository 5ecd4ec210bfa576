"""What limn refuses, and what it remarks on."""

from __future__ import annotations

from typing import Any


class Error(ValueError):
    """Bad input: where it is, what is wrong, and what to do.

    ``str`` of it is the line that the command prints: ``file:line:column: message (hint)``.
    """

    message: str
    """What is wrong and what was expected; several faults of a file have a line each."""
    hint: str
    """What to do; may be empty."""
    file: str
    """The file as it was named; empty where no file is involved."""
    line: int
    """From 1; 0 where none is known."""
    column: int
    """From 1, in bytes; 0 where none is known."""

    def __init__(
        self, message: str, hint: str = "", file: str = "", line: int = 0, column: int = 0
    ) -> None:
        super().__init__(message, hint, file, line, column)
        self.message = message
        self.hint = hint
        self.file = file
        self.line = line
        self.column = column

    def __str__(self) -> str:
        from . import _limn

        return _limn.error_text(self.message, self.hint, self.file, self.line, self.column)

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.message, self.hint, self.file, self.line, self.column)


class SchemeError(Error):
    """A scheme that cannot be read, or has no answer to what is asked of it."""


class MeshError(Error):
    """A mesh, its file or its arrays."""


class LimnWarning(UserWarning):
    """A remark on input that was taken all the same."""
