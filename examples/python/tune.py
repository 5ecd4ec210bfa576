"""Tune a scheme: solve for a weight, draw what depends on it, refine with the result.

    PYTHONPATH=build/release/python python3 examples/python/tune.py [FOLDER]

The weight beta of a vertex's neighbours is 3/(8n), Warren's choice for Loop's scheme. It is solved
for so that the cup's eigenvalue is the square of the tangent's, at each valence; the surfaces of
both are compared.
"""

import pathlib
import sys

import matplotlib.pyplot as plt
import numpy as np

import limn

EXAMPLES = pathlib.Path(__file__).resolve().parents[1]
folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
path = folder / "warren.toml"
path.write_text(
    """name = "warren"
split = "triangle-dyadic"
let.beta = "3/(8*n)"
vertex = { self = "1 - n*beta", ring = "beta" }
edge   = { end = "3/8", wing = "1/8" }
boundary = { vertex = { self = "3/4", next = "1/8" }, edge = { end = "1/2" } }
"""
)
scheme = limn.Scheme(path)
valences = range(3, 13)

# %% For which beta is the surface C1, as far as eigenvalues tell?
print("can be solved for:", scheme.tunable())
ranges = scheme.tune("beta", "c1", valences)

# %% The solutions, and a scheme file that has them.
found = scheme.tune("beta", "cup = tangent^2", valences)
tuned = found.scheme()
print(found["text"])
solutions = {
    entry["valence"]: [one["value"] for one in entry["solutions"] if one["holds"]]
    for entry in found["valences"]
}
for valence, values in solutions.items():
    components = tuned.eigen(valence)["components"]
    print(valence, [round(value, 6) for value in values],
          f"cup - tangent² = {components['cup'] - components['tangent'] ** 2:+.1e}")

# %% The range and the solutions in one picture, and the energies of two surfaces.
figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4), constrained_layout=True)
for entry in ranges["valences"]:
    for part in entry["parts"]:
        ends = [part["low"]["value"], part["high"]["value"]]
        left.plot([entry["valence"]] * 2, ends, color="lightsteelblue", linewidth=8,
                  solid_capstyle="butt", label="C1 by the eigenvalues")
for valence, values in solutions.items():
    left.plot([valence] * len(values), values, "o", color="darkred", label="cup = tangent²")
left.plot(valences, [3 / (8 * n) for n in valences], "x", color="black", label="Warren")
left.set_xlabel("valence")
left.set_ylabel("beta")
handles = dict(zip(*reversed(left.get_legend_handles_labels())))
left.legend(handles.values(), handles.keys())

V, F = limn.read_mesh(EXAMPLES / "bracket.obj")
fairness = limn.fairness(V, F, {"Warren": scheme, "tuned": tuned})
for one, style in zip(fairness["schemes"], ("s-", "o--")):
    levels = [level["level"] for level in one["levels"]]
    right.plot(levels, [level["thin_plate"] for level in one["levels"]], style, label=one["scheme"])
right.set_xlabel("level")
right.set_ylabel("thin-plate energy")
right.legend()
figure.savefig(folder / "tune.png", dpi=120)
fine, faces = tuned.refine(V, F, 3)
assert np.isfinite(fine).all()
limn.write_mesh(folder / "tuned.ply", fine, faces)
