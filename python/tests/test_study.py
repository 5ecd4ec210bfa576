"""Studies: by threads here, by the command, and by Dask's workers, one of which is killed."""

import os
import pathlib
import pickle
import signal
import sqlite3
import subprocess
import sys

import distributed
import pytest

import limn

SCHEME = """
split   = "triangle-dyadic"
extends = "loop-type"
[parameter.b]
default = "3/8"
range   = ["0", "1/2"]
"""

STUDY = """
title    = "Loop type"
scheme   = "{scheme}"
valences = "3..5"
[[free]]
name = "b"
low  = "1/4"
high = "7/16"
[[free]]
name     = "beta"
valences = "3..5"
low      = 0
high     = "3/(5*n)"
[[objective]]
value = "worst_artifact(4)"
goal  = "min"
[[objective]]
value = "holder_lower()"
goal  = "max"
[[require]]
that      = "c1"
certified = true
[method]
kind   = "pareto"
points = 40
batch  = 8
[[compare]]
scheme = "loop"
"""


def written(folder):
    (folder / "in").mkdir()
    (folder / "in" / "mine.toml").write_text(SCHEME)
    path = folder / "in" / "s.toml"
    path.write_text(STUDY.format(scheme="mine.toml"))
    return path


@pytest.fixture
def study_file(tmp_path):
    return written(tmp_path)


class Whole:
    """The study made once, here, by threads: what all others, in folders beside it, have to give."""

    def __init__(self, folder):
        self.folder = folder
        self.file = written(folder)
        self.seen = []
        self.found = limn.study(self.file, folder / "whole", csv=True, progress=self.seen.append)
        self.kept = kept(folder / "whole")


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    return Whole(tmp_path_factory.mktemp("whole"))


def kept(folder):
    """All that a folder has but the seconds that points took, and the folder's name in proofs."""
    with sqlite3.connect(folder / "study.sqlite") as store:
        cursor = store.execute("select * from points order by key")
        names = [column[0] for column in cursor.description]
        rows = [tuple(v for k, v in zip(names, row) if k != "seconds") for row in cursor]
    files = {}
    for path in folder.rglob("*"):
        if path.is_file() and "study.sqlite" not in path.name:
            text = path.read_text("utf-8", "replace")
            for name in (str(folder), str(folder.relative_to(folder.parents[1]))):
                text = text.replace(name, "FOLDER")
            files[path.relative_to(folder)] = text
    return rows, files


def test_is_what_the_command_does(whole, command, monkeypatch):
    monkeypatch.chdir(whole.folder.parent)
    found, last = whole.found, whole.seen[-1]
    printed = command("study", whole.file, "-o", f"{whole.folder.name}/again", "--csv")
    assert found["points"] == printed["points"] >= 40
    assert kept(whole.folder / "again") == whole.kept
    assert [point["objectives"] for point in found["best"]] == [
        point["objectives"] for point in printed["best"]
    ]
    assert last["done"] == found["points"] and last["feasible"] == found["feasible"]
    assert str(found).startswith("Loop type: ")
    assert limn.study_quantities() == command("study", "--quantities")["quantities"]


def test_stops_and_goes_on(whole):
    parts = whole.folder / "parts"
    nothing = limn.study(whole.file, parts, seconds=0)
    assert not nothing["finished"] and nothing["evaluated"] == 0

    class Enough(Exception):
        pass

    def stop(at):
        if at["done"] == 13:
            raise Enough

    with pytest.raises(Enough):
        limn.study(whole.file, parts, progress=stop)
    rest = limn.study(whole.file, parts, csv=True)
    assert 0 < rest["evaluated"] <= whole.found["evaluated"] - 13
    assert kept(parts) == whole.kept


def test_pickles_with_its_files(study_file, tmp_path):
    study = limn.Study(study_file)
    point = ["3/8", "3/16", "1/10", "1/12"]
    here = study.evaluate(point)
    assert here["feasible"] and study.coordinates == ["b", "beta@3", "beta@4", "beta@5"]
    packed = pickle.dumps(study)
    for path in study_file.parent.iterdir():
        path.unlink()
    script = (
        "import pickle, sys, limn\n"
        f"found = pickle.load(sys.stdin.buffer).evaluate({point!r})\n"
        "found.pop('seconds')\nprint(repr(found))\n"
    )
    done = subprocess.run([sys.executable, "-c", script], input=packed, capture_output=True, check=True)
    here.pop("seconds")
    assert eval(done.stdout) == here


def test_says_what_is_wrong(study_file, tmp_path):
    with pytest.raises(limn.Error) as caught:
        limn.Study("scheme = \"loop\"\nx = 1\n")
    assert (caught.value.line, caught.value.column) == (2, 1)
    with pytest.raises(limn.Error, match="cannot read"):
        limn.Study(STUDY.format(scheme="nowhere.toml"))
    limn.study(study_file, tmp_path / "out", seconds=0)
    study_file.write_text(STUDY.format(scheme="mine.toml").replace("7/16", "13/32"))
    with pytest.raises(limn.Error, match="another study"):
        limn.study(study_file, tmp_path / "out", seconds=0)


@pytest.fixture(scope="module")
def cluster():
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None
    ) as made:
        yield made


@pytest.mark.filterwarnings("ignore")
def test_a_worker_is_killed_and_nothing_changes(whole, cluster):
    alone, many = whole.found, whole.folder / "many"
    killed = []

    with distributed.Client(cluster) as client:

        def kill(at):
            if at["done"] == 11:
                killed.extend(list(client.run(os.getpid).values())[:1])
                os.kill(killed[0], signal.SIGKILL)

        found = limn.study(whole.file, many, client=client, csv=True, progress=kill)
        assert killed and killed[0] not in client.run(os.getpid).values()
    assert found["points"] == alone["points"] and found["evaluated"] == alone["evaluated"]
    assert kept(many) == whole.kept


@pytest.mark.filterwarnings("ignore")
def test_the_command_leaves_it_to_workers(whole, cluster):
    there = whole.folder / "there"
    environment = {**os.environ, "LIMN_PYTHON": sys.executable}
    words = [os.environ["LIMN_COMMAND"], "study", str(whole.file), "--csv"]
    done = subprocess.run(
        [*words, "-o", there, "--dask", cluster.scheduler_address],
        env=environment,
        capture_output=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr.decode()
    assert kept(there) == whole.kept


def test_the_command_says_what_is_missing(study_file, tmp_path):
    words = [os.environ["LIMN_COMMAND"], "study", str(study_file), "-o", str(tmp_path / "out")]
    nowhere = subprocess.run(
        [*words, "--dask", "tcp://127.0.0.1:9"],
        env={**os.environ, "LIMN_PYTHON": sys.executable},
        capture_output=True,
        check=False,
    )
    assert nowhere.returncode == 2 and b"no Dask scheduler answers" in nowhere.stderr
    no_python = subprocess.run(
        [*words, "--dask", "tcp://127.0.0.1:9"],
        env={**os.environ, "LIMN_PYTHON": "/bin/false"},
        capture_output=True,
        check=False,
    )
    assert no_python.returncode == 2 and b"no Python here can import limn" in no_python.stderr
    assert not pathlib.Path(tmp_path / "out" / "best").exists()
