"""What the package raises, and what it warns of."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Optional

if TYPE_CHECKING:
    from .result import Result


class SceneError(ValueError):
    """A scene that is refused; `str()` is the message with the place drawn below it."""

    code: str
    """Word for the kind of refusal, such as `scene::value`."""
    key: str
    """Path of the key, such as `section.homogeneous.thickness`; empty for the scene as a whole."""
    value: str
    """What was found there, as text."""
    bound: str
    """What is allowed there."""
    repair: str
    """What to do about it."""
    origin: str
    """Name of the text: its file, or `scene`."""
    line: Optional[int]
    """Line of the text, from 1; none where something is missing altogether."""
    column: Optional[int]
    """Column of that line, from 1."""
    drawn: str
    """The refusal as the command draws it: message, place in the scene, repair."""

    def __init__(
        self,
        message: str,
        code: str,
        fault: tuple[str, str, str, str],
        place: tuple[str, Optional[int], Optional[int]],
        drawn: str,
    ) -> None:
        super().__init__(message, code, fault, place, drawn)
        self.code = code
        self.key, self.value, self.bound, self.repair = fault
        self.origin, self.line, self.column = place
        self.drawn = drawn
        if sys.version_info >= (3, 11):
            self.add_note(drawn)

    def __str__(self) -> str:
        return f"{self.args[0]}; {self.repair}" if self.repair else str(self.args[0])


class CoqueError(RuntimeError):
    """What is no fault of the scene: a folder that is in use, a disk without room, a fault of the program."""

    result: Optional[Result] = None
    """What was found before, if there is anything."""


class Diverged(RuntimeError):
    """A run that did not reach its end."""

    def __init__(self, message: str, result: Result) -> None:
        super().__init__(message)
        self.result = result
        """What was found before."""


class Interrupted(KeyboardInterrupt):
    """A run that was ended by Ctrl-C."""

    def __init__(self, message: str, result: Result) -> None:
        super().__init__(message)
        self.result = result
        """What was found before."""


class CoqueWarning(UserWarning):
    """What may be wrong with a number. `warnings.simplefilter("error", coque.CoqueWarning)` makes a script strict."""

    def __init__(self, message: str, word: str = "") -> None:
        super().__init__(message)
        self.word = word
        """The word that `summary.json` has for it, such as `coarse-bending`; empty for what concerns the machine."""


class NotSettled(CoqueWarning):
    """A load level that was left before the motion had died: it is no equilibrium."""
