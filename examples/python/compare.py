"""Compare schemes by their artifacts.

    PYTHONPATH=build/release/python python3 examples/python/compare.py [FOLDER]

An artifact is a ripple of the limit surface that no movement of control points removes. For waves
of every frequency: how large are a scheme's artifacts, in percent of the wave that is wanted?
"""

import pathlib
import sys

import matplotlib.pyplot as plt
import numpy as np

import limn

NAMES = ["loop", "butterfly", "catmull-clark"]
folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")

# %% Maps over the frequencies of the Nyquist region, on one scale.
maps = {name: limn.Scheme(name).artifact_map(256) for name in NAMES}
figure, axes = plt.subplots(1, len(NAMES), figsize=(12, 4), constrained_layout=True)
for axis, (name, found) in zip(axes, maps.items()):
    region = plt.Polygon(found.nyquist_region, fill=False, linewidth=0.8)
    axis.add_patch(region)
    shown = axis.imshow(
        np.clip(found.percent_of_signal, 0, 100), origin="lower", extent=found.extent, vmax=100
    )
    shown.set_clip_path(region)
    axis.set_title(name)
    axis.set_xlabel("cycles per control edge")
figure.colorbar(shown, ax=axes, label="artifacts, percent of the signal")
figure.savefig(folder / "compare-maps.png", dpi=120)

# %% How densely must one sample? Control edges per wavelength, in the worst direction.
tolerances = [0.1, 0.3, 1, 3, 10]
figure, axis = plt.subplots(figsize=(6, 4), constrained_layout=True)
for name in NAMES:
    scheme = limn.Scheme(name)
    densities = [
        scheme.sampling_density(tolerance)["sampling"]["total_energy"]["worst"]["edges_per_wavelength"]
        for tolerance in tolerances
    ]
    print(name, [round(density, 2) for density in densities])
    axis.semilogx(tolerances, densities, "o-", label=name)
axis.set_xlabel("artifacts allowed, percent of the signal")
axis.set_ylabel("control edges per wavelength")
axis.legend()
figure.savefig(folder / "compare-density.png", dpi=120)

# %% All that limn knows of two, side by side.
print(limn.compare("loop", "butterfly", valence=range(4, 8)))
