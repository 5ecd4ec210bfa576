"""What calling limn from Python costs, beside the command in the same run.

    ./dev build && PYTHONPATH=build/release/python /usr/bin/python3 bench/python.py

Rows: refinement by `Scheme.refine` and by `Refiner.evaluate` against the seconds that `limn refine
--json` states of the same mesh, scheme and levels, with edges that turn by more than an angle sharp
where one is named; and a call that evaluates next to nothing. Times are the least of several runs.
The command refines once, in a process of its own, and so does the column "first"; the others have
their memory and their tables from the run before.
LIMN_COMMAND names another command than that of the release build.
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

import numpy as np

import limn

ROOT = pathlib.Path(__file__).resolve().parents[1]
COMMAND = os.environ.get("LIMN_COMMAND", ROOT / "build" / "release" / "bin" / "limn")
RUNS = 7


def least(call):
    times = []
    for _ in range(RUNS):
        start = time.perf_counter()
        call()
        times.append(time.perf_counter() - start)
    return min(times)


def seconds_of_command(mesh, scheme, levels, angle, folder):
    # the seconds are those of refinement alone, though PLY is written while it goes on
    words = [COMMAND, "refine", mesh, "-s", scheme, "-n", str(levels), "--json"]
    words += ["-o", folder / "fine.ply"]
    if angle is not None:
        words += ["--crease-angle", str(angle)]
    runs = [subprocess.run(words, capture_output=True, check=True) for _ in range(RUNS)]
    return min(json.loads(run.stdout)["seconds"] for run in runs)


FIRST = """
import sys, time, limn
V, F = limn.read_mesh(sys.argv[1])
scheme, angle = limn.Scheme(sys.argv[2]), float(sys.argv[4])
start = time.perf_counter()
scheme.refine(V, F, int(sys.argv[3]), crease_angle=angle if angle >= 0 else None)
print(time.perf_counter() - start)
"""


def seconds_of_first(mesh, scheme, levels, angle):
    words = [sys.executable, "-c", FIRST, str(mesh), scheme, str(levels)]
    words.append("-1" if angle is None else str(angle))
    runs = [subprocess.run(words, capture_output=True, check=True) for _ in range(RUNS)]
    return min(float(run.stdout) for run in runs)


def refinement(folder):
    print(f"{'scheme':>18} {'levels':>6} {'vertices':>9}   {'limn refine':>11} {'first':>9} {'refine':>9}"
          f" {'float32':>9} {'Refiner':>9}   [ms]")
    for name, scheme, levels, angle in (
        ("bracket.obj", "loop", 6, None),
        ("bracket.obj", "loop", 6, 60),
        ("bracket.obj", "butterfly", 6, None),
        ("bracket.obj", "sqrt3", 8, None),
        ("bracket-quads.obj", "catmull-clark", 6, None),
        ("bracket-quads.obj", "catmull-clark", 6, 60),
        ("bracket-quads.obj", "doo-sabin", 6, None),
    ):
        mesh = ROOT / "examples" / name
        V, F = limn.read_mesh(mesh)
        small = V.astype(np.float32)
        data = limn.Scheme(scheme)
        tags = {} if angle is None else data.refine(V, F, 0, crease_angle=angle).tags
        refiner = limn.Refiner(data, F, levels, len(V), **tags)
        out = np.empty((refiner.vertex_count, 3))
        times = [
            seconds_of_command(mesh, scheme, levels, angle, folder),
            seconds_of_first(mesh, scheme, levels, angle),
            least(lambda: data.refine(V, F, levels, crease_angle=angle)),
            least(lambda: data.refine(small, F, levels, crease_angle=angle)),
            least(lambda: refiner.evaluate(V, out)),
        ]
        row = "  ".join(f"{1000 * seconds:8.2f}" for seconds in times)
        label = scheme if angle is None else f"{scheme}, {angle}°"
        print(f"{label:>18} {levels:>6} {refiner.vertex_count:>9}      {row}")


def overhead():
    V = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]], dtype=float)
    F = np.array([[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]], dtype=np.int32)
    loop = limn.Scheme("loop")
    refiner, out = limn.Refiner(loop, F, 0), np.empty((4, 3))
    count = 20_000

    def many(call):
        def run():
            for _ in range(count):
                call()

        return 1e9 * least(run) / count

    print(f"{many(lambda: refiner.evaluate(V, out)):8.0f} ns  refiner.evaluate(V, out), no levels")
    print(f"{many(lambda: refiner.evaluate(V)):8.0f} ns  refiner.evaluate(V), no levels")
    print(f"{many(lambda: loop.name):8.0f} ns  scheme.name")


with tempfile.TemporaryDirectory() as temporary:
    refinement(pathlib.Path(temporary))
overhead()
