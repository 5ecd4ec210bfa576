"""The command line of ``python3 -m limn.study``: that of ``limn study``, with workers elsewhere."""

from __future__ import annotations

import argparse
import json
import sys
import time
from importlib import import_module
from typing import Any, Optional, Sequence

from ._errors import Error
from ._study import Study, StudyResult, study

_CONNECT_SECONDS = 10


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python3 -m limn.study", description=__doc__)
    parser.add_argument("STUDY", help="a study file (.toml)")
    parser.add_argument("-o", "--output", required=True, metavar="FOLDER", help="where it is kept")
    parser.add_argument("--dask", metavar="SCHEDULER", help="as tcp://host:8786; else threads here")
    parser.add_argument("--csv", action="store_true", help="also write all points to points.csv")
    parser.add_argument("--best", type=int, default=12, help="so many scheme files (%(default)s)")
    parser.add_argument("--time", type=float, default=0, help="stop after so many seconds; 0: never")
    parser.add_argument("--restart", action="store_true", help="throw away what the folder holds")
    parser.add_argument("--json", action="store_true", help="print one JSON object")
    parser.add_argument("--quiet", action="store_true", help="errors alone on standard error")
    return parser


class _Progress:
    """A line that rewrites itself, where standard error is a terminal."""

    def __init__(self, wanted: bool) -> None:
        self._wanted = wanted and sys.stderr.isatty()
        self._next = time.monotonic() + 1

    def __call__(self, at: dict[str, Any]) -> None:
        if not self._wanted or time.monotonic() < self._next:
            return
        self._next = time.monotonic() + 0.2
        line = f"point {at['done']} of {at['most']}, {at['feasible']} feasible"
        sys.stderr.write(f"\r\x1b[K{line}, generation {at['generation']}")
        sys.stderr.flush()

    def end(self) -> None:
        if self._wanted:
            sys.stderr.write("\r\x1b[K")


def _run(options: argparse.Namespace, progress: _Progress) -> StudyResult:
    asked = Study(options.STUDY)
    settings: dict[str, Any] = {
        "seconds": options.time or None,
        "restart": options.restart,
        "csv": options.csv,
        "best": options.best,
        "progress": progress,
    }
    if options.dask is None:
        return study(asked, options.output, **settings)
    try:
        distributed: Any = import_module("distributed")
    except ImportError:
        raise Error("Python has no module distributed", "install python3-distributed") from None
    try:
        client = distributed.Client(options.dask, timeout=_CONNECT_SECONDS)
    except (OSError, ValueError) as error:
        raise Error(
            f"no Dask scheduler answers at '{options.dask}': {error}",
            "start one by `dask-scheduler`, and workers by `dask-worker`",
        ) from error
    with client:
        return study(asked, options.output, client=client, **settings)


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """Exit codes are those of the command: 0 done, 2 bad input."""
    options = _parser().parse_args(arguments)
    progress = _Progress(not options.quiet)
    try:
        found = _run(options, progress)
    except (Error, OSError) as error:
        progress.end()
        for line in str(error).splitlines():
            print(f"limn: {line}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        progress.end()
        print("limn: interrupted: the same command goes on from here", file=sys.stderr)
        return 130
    progress.end()
    if options.json:
        print(json.dumps(found, ensure_ascii=False, separators=(",", ":")))
    else:
        print(found, end="")
    return 0
