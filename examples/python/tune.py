"""Tune a scheme: solve for a parameter, draw what depends on it, refine with the result.

    PYTHONPATH=build/release/python python3 examples/python/tune.py [FOLDER]

The centre's weight alpha of √3 is solved for so that the cup's eigenvalue is the square of the
tangent's, at each valence, and the surfaces are compared.
"""

import pathlib
import sys

import matplotlib.pyplot as plt
import numpy as np

import limn

EXAMPLES = pathlib.Path(__file__).resolve().parents[1]
folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
sqrt3 = limn.Scheme("sqrt3")
valences = range(3, 13)

# %% Where is the surface C1 at all, as far as eigenvalues tell?
print("can be solved for:", sqrt3.tunable())
ranges = sqrt3.tune("alpha", "c1", valences)
print("c1 is possible at all valences for alpha in", ranges["common"])

# %% The solutions, and a scheme that has them.
found = sqrt3.tune("alpha", "cup = tangent^2", valences)
tuned = found.scheme()
solutions = {
    entry["valence"]: [one["value"] for one in entry["solutions"] if one["holds"]]
    for entry in found["valences"]
}
for valence, values in solutions.items():
    components = tuned.eigen(valence)["components"]
    print(valence, [round(value, 6) for value in values],
          f"cup - tangent² = {components['cup'] - components['tangent'] ** 2:+.1e}")

# %% The range and the solutions in one picture, and the energies of a surface.
figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4), constrained_layout=True)
for entry in ranges["valences"]:
    for part in entry["parts"]:
        ends = [part["low"]["value"], part["high"]["value"]]
        left.plot([entry["valence"]] * 2, ends, color="lightsteelblue", linewidth=8,
                  solid_capstyle="butt")
for valence, values in solutions.items():
    left.plot([valence] * len(values), values, "o", color="darkred")
left.set_xlabel("valence")
left.set_ylabel("alpha: C1 as far as eigenvalues tell; dots: cup = tangent²")

V, F = limn.read_mesh(EXAMPLES / "bracket.obj")
fairness = limn.fairness(V, F, {"sqrt3": sqrt3, "tuned": tuned})
for scheme in fairness["schemes"]:
    levels = [level["level"] for level in scheme["levels"]]
    right.plot(levels, [level["thin_plate"] for level in scheme["levels"]], "o-",
               label=scheme["scheme"])
right.set_xlabel("level")
right.set_ylabel("thin-plate energy")
right.legend()
figure.savefig(folder / "tune.png", dpi=120)
fine, faces = tuned.refine(V, F, 3)
assert np.isfinite(fine).all()
limn.write_mesh(folder / "tuned.ply", fine, faces)
