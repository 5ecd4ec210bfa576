"""Animate a surface: topology is worked out once, positions are evaluated for every frame.

    PYTHONPATH=build/release/python python3 examples/python/animate.py [FOLDER]

`refiner.evaluate` writes into an array of one's own: nothing is allocated from frame to frame.
"""

import pathlib
import sys
import time

import matplotlib.pyplot as plt
import numpy as np

import limn

EXAMPLES = pathlib.Path(__file__).resolve().parents[1]
folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")

# %% The control mesh and its refiner.
V, F = limn.read_mesh(EXAMPLES / "bracket.obj")
refiner = limn.Refiner("loop", F, 4, vertices=len(V))
print(refiner)

# %% Frames: the mesh bends about its middle.
centre = (V.min(axis=0) + V.max(axis=0)) / 2
size = np.ptp(V, axis=0).max()


def bent(angle):
    """V turned about the z axis by an angle that grows along x."""
    local = V - centre
    turn = angle * local[:, 0] / size
    x = np.cos(turn) * local[:, 0] - np.sin(turn) * local[:, 1]
    y = np.sin(turn) * local[:, 0] + np.cos(turn) * local[:, 1]
    return np.column_stack([x, y, local[:, 2]])


frames = np.linspace(0, np.pi / 2, 60)
fine = np.empty((refiner.vertex_count, 3))
start = time.perf_counter()
for angle in frames:
    refiner.evaluate(bent(angle), fine)
seconds = time.perf_counter() - start
print(f"{len(frames)} frames of {refiner.vertex_count} vertices: "
      f"{1000 * seconds / len(frames):.2f} ms a frame")

# %% Three of them, coloured by a value at the control vertices that is refined, too.
heat = refiner.evaluate(V[:, 2])
assert np.isclose(heat.mean(), refiner.evaluate(V)[:, 2].mean())
figure = plt.figure(figsize=(12, 4))
for place, angle in enumerate(frames[[0, 30, 59]], 1):
    points = refiner.evaluate(bent(angle))
    axis = figure.add_subplot(1, 3, place, projection="3d")
    surface = axis.plot_trisurf(*points.T, triangles=refiner.faces, linewidth=0)
    surface.set_array(heat[refiner.faces].mean(axis=1))
    axis.set_box_aspect(np.ptp(points, axis=0))
    axis.set_axis_off()
figure.tight_layout()
figure.savefig(folder / "animate.png", dpi=120)
