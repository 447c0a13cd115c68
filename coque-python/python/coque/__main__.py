"""The command `coque`, as `python -m coque` too."""

from __future__ import annotations

import signal
import sys

from ._coque import command_line


def main() -> None:
    """Obeys the words of the command line and ends with the exit code of the command."""
    # The command has its own way with Ctrl-C; Python's would raise behind it.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    sys.exit(command_line(["coque", *sys.argv[1:]]))


if __name__ == "__main__":
    main()
