"""Studies: many points, evaluated here or by the workers of a Dask scheduler."""

from __future__ import annotations

import hashlib
import math
import os
import tempfile
import time
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from importlib import import_module
from typing import TYPE_CHECKING, Any, Callable, Generator, Optional, Union

from . import _limn
from ._errors import Error
from ._results import _Told

if TYPE_CHECKING:
    from ._limn import Outcome

    Parts = tuple[str, bytes, dict[str, bytes], str]
    Points = list[tuple[int, list[str]]]
    Outcomes = Generator[tuple[int, Outcome], None, None]

Path = Union[str, "os.PathLike[str]"]

_RETRIES = 3  # of a point whose evaluation raised; workers that die are the scheduler's matter


class StudyResult(_Told):
    """What a study found: a dict as ``limn study --json``, whose ``str`` is what the command says."""


class Study:
    """A study file, read: ``Study("loop-family.toml")``, or its text (a string with a line feed).

    It pickles with the schemes and meshes that it names, so that it needs no file elsewhere.
    """

    def __init__(self, source: Path) -> None:
        text = os.fspath(source)
        if "\n" in text:
            self._data = _limn.StudyData("study.toml", text)
        else:
            self._data = _limn.StudyData(text)
        self._parts: Optional[Parts] = None  # of one that came from another process

    def __repr__(self) -> str:
        return f"<limn.Study {self.title or self.file}: {len(self.coordinates)} coordinates>"

    @property
    def title(self) -> str:
        """What the file calls it; may be empty."""
        return self._data.title

    @property
    def file(self) -> str:
        """The path that it was read from."""
        return os.fsdecode(self._data.file)

    @property
    def coordinates(self) -> list[str]:
        """What is free: ``"b"``, or ``"beta@5"`` at a valence."""
        return self._data.coordinates

    def forecast(self, sample: int = 8) -> dict[str, Any]:
        """What it costs: ``limn study --dry-run --json``, by ``sample`` points that are measured."""
        return self._data.forecast(sample)

    def evaluate(self, point: list[str]) -> dict[str, Any]:
        """One point, its numbers as fractions ("3/8"), one for each coordinate.

        A dict: feasible, reason, violation, objectives, demands ("yes", "no", "undecided", None where
        it was not looked for), seconds. A pure function: the same in every process.
        """
        names = ("feasible", "reason", "violation", "objectives", "demands", "seconds")
        found: dict[str, Any] = dict(zip(names, self._data.evaluate([str(number) for number in point])))
        found["reason"] = found["reason"].decode("utf-8", "replace")
        return found

    def _token(self) -> str:
        """What two studies share only if their points have the same outcomes."""
        return hashlib.sha256(_limn.__version__.encode() + self._data.identity).hexdigest()[:32]

    def _all_parts(self) -> Parts:
        """Its text and the files that it was read from: what another process needs."""
        if self._parts is not None:
            return self._parts
        files = {}
        for name in self._data.files:
            with open(name, "rb") as file:
                files[os.path.abspath(os.fsdecode(name))] = file.read()
        return os.path.abspath(self.file), self._data.text, files, self._token()

    def __reduce__(self) -> tuple[Any, ...]:
        return _study_of, (self._all_parts(),)


def _study_of(parts: Parts) -> Study:
    """A study from its files, which are laid out anew round it while it is read."""
    path, text, files, token = parts
    study = Study.__new__(Study)
    with tempfile.TemporaryDirectory(prefix="limn-study-") as root:
        for name, content in files.items():
            place = root + name
            os.makedirs(os.path.dirname(place), exist_ok=True)
            with open(place, "wb") as file:
                file.write(content)
        study._data = _limn.StudyData(root + path, text.decode())
    study._parts = parts
    if study._token() != token:
        raise Error(
            "a study is not the same in two processes",
            "see that all have the same version of limn, and that it names files by relative paths",
        )
    return study


def _evaluate(study: Study, point: list[str]) -> Outcome:
    return study._data.evaluate(point)


_last: dict[str, Study] = {}  # of a worker, by its token


def _evaluate_there(parts: Parts, point: list[str]) -> Outcome:
    """On a worker. What goes wrong with the study does so in the task, which is then told."""
    token = parts[3]
    if token not in _last:
        _last.clear()
        _last[token] = _study_of(parts)
    return _evaluate(_last[token], point)


def _itself(parts: Parts) -> Parts:
    return parts


def _here(study: Study, points: Points, stop: Callable[[], bool]) -> Outcomes:
    """Outcomes by threads of this process, as they come; what is in hand is finished."""
    threads = _limn.thread_limit() or os.cpu_count() or 1
    places: dict[Future[Outcome], int] = {}
    rest = iter(points)
    with ThreadPoolExecutor(threads) as pool:
        while True:
            while len(places) < threads and not stop():
                if (following := next(rest, None)) is None:
                    break
                places[pool.submit(_evaluate, study, following[1])] = following[0]
            if not places:
                return
            for future in wait(places, return_when=FIRST_COMPLETED).done:
                yield places.pop(future), future.result()


class _Workers:
    """The workers of a Dask scheduler. Tasks are pure and named by what they compute."""

    def __init__(self, client: Any, study: Study) -> None:
        self._client = client
        self._token = study._token()
        # sent once, and again where the worker that had it is lost
        key = f"limn-study-{self._token}"
        self._parts = client.submit(_itself, study._all_parts(), key=key, retries=_RETRIES)

    def __call__(self, study: Study, points: Points, stop: Callable[[], bool]) -> Outcomes:
        as_completed: Any = import_module("distributed").as_completed

        places, futures = {}, []
        for place, point in points:
            key = f"limn-point-{self._token}-{hashlib.sha256(' '.join(point).encode()).hexdigest()}"
            places[key] = place
            futures.append(
                self._client.submit(_evaluate_there, self._parts, point, key=key, retries=_RETRIES)
            )
        try:
            for future in as_completed(futures):
                yield places[future.key], _outcome_of(future)
                if stop():
                    break
        finally:
            self._client.cancel([future for future in futures if not future.done()])


def _outcome_of(future: Any) -> Outcome:
    """What a worker found; what it could not do is an Error that says what to do."""
    distributed: Any = import_module("distributed")
    again = "what was found is kept: start the same study again"
    try:
        found: Outcome = future.result()
    except distributed.KilledWorker as error:
        raise Error(f"workers ended, one after another, at one point: {error}", again) from error
    except distributed.CancelledError as error:
        raise Error("the Dask scheduler is lost, or gave the study up", again) from error
    except ImportError as error:
        raise Error(
            f"a worker cannot import limn: {error}", "install limn where the workers run"
        ) from error
    return found


def study(
    study: Study | Path,
    output: Path,
    *,
    client: Any = None,
    seconds: Optional[float] = None,
    restart: bool = False,
    csv: bool = False,
    best: int = 12,
    progress: Optional[Callable[[dict[str, Any]], None]] = None,
) -> StudyResult:
    """Runs a study, or goes on with it: ``limn study STUDY -o OUTPUT``.

    ``output``: the folder with all points and what was found (docs/studies.md); ``client``: a
    ``distributed.Client``, whose workers then evaluate the points; None: threads of this process.
    The results are the same bits whoever evaluates. ``seconds``: begin no point after so long;
    ``restart``: throw away the points that the folder holds; ``csv``: also write points.csv;
    ``best``: so many scheme files at most; ``progress``: called after each point with a dict
    (generation, done, most, feasible, seconds_left).

    Raises Error. Whatever ends it, points that were found are kept, and the same call goes on.
    """
    asked = study if isinstance(study, Study) else Study(study)
    evaluate: Callable[[Study, Points, Callable[[], bool]], Outcomes] = _here
    if client is not None:
        evaluate = _Workers(client, asked)
    end = math.inf if seconds is None else time.monotonic() + seconds
    search = _limn.StudySearch(asked._data, os.fspath(output), restart)
    while (points := search.next()) is not None:
        left = len(points)
        for place, outcome in evaluate(asked, points, lambda: time.monotonic() >= end):
            search.keep(place, outcome)
            left -= 1
            if progress is not None:
                progress(search.progress())
        if left > 0:
            break
        search.tell()
    return StudyResult(*search.conclude(csv, best))


def study_quantities() -> list[dict[str, Any]]:
    """The numbers that a study can ask for: ``limn study --quantities --json``."""
    listed: list[dict[str, Any]] = _limn.study_quantities()["quantities"]
    return listed
