"""Analyse a new scheme: from a text to what can be proved of it.

    PYTHONPATH=build/release/python python3 examples/python/analyse.py [FOLDER]

The scheme is like Loop's, with a weight w of the wings of an edge that is 1/10 instead of 1/8. The
weight of a vertex is chosen so that the cup's eigenvalue is the square of the tangent's, which is
what bounded curvature needs there.
"""

import pathlib
import sys

import matplotlib.pyplot as plt
import numpy as np

import limn

# %% A scheme is a text.
TEXT = """
name = "tighter-loop"
split = "triangle-dyadic"
let.w       = "1/10"
let.tangent = "1/2 - w + 2*w*cos(2*pi/n)"
let.beta    = "(1/2 + w - tangent^2)/n"
vertex = { self = "1 - n*beta", ring = "beta" }
edge   = { end = "1/2 - w", wing = "w" }
boundary = { vertex = { self = "3/4", next = "1/8" }, edge = { end = "1/2" } }
"""
scheme = limn.Scheme(TEXT)
print(scheme)

# A fault is an exception that says where it is.
try:
    limn.Scheme(TEXT.replace('wing = "w"', 'wing = "2*w"'))
except limn.SchemeError as error:
    print("refused:", str(error).splitlines()[0])

# %% How smooth is it, where the mesh is regular?
regularity = scheme.regularity()
print("C1 on the regular lattice:", regularity["c1"], "- C2:", regularity["c2"])
print("Hölder exponent at least", regularity["holder"]["lower"])

# %% And at extraordinary vertices?
valences = range(3, 13)
eigen = scheme.eigen(valences)
for found in eigen:
    components = found["components"]
    gap = components["cup"] - components["tangent"] ** 2
    print(f"valence {found['valence']:2}: cup - tangent² = {gap:+.1e}, c1 necessary: "
          f"{found['verdict']['c1_necessary']}")
    assert abs(gap) < 1e-12 or found["valence"] == 3  # there an eigenvalue of the second ring leads

certificate = scheme.certify(valences)
proved = [claim["valence"] for claim in certificate["valences"] if claim["c1"] == "proved"]
print("C1 proved at the valences", proved)
limn.check_certificate(certificate)

# %% Eigenvalues against Loop's, and a characteristic map.
loop = limn.Scheme("loop").eigen(valences)
figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4.5))
for name, found, style in (("tighter", eigen, "o-"), ("Loop", loop, "s--")):
    for component in ("tangent", "cup", "saddle"):
        values = [one["components"][component] for one in found]
        values = [np.nan if value is None else value for value in values]
        left.plot(valences, values, style, label=f"{component}, {name}", markersize=4)
left.set_xlabel("valence")
left.set_ylabel("eigenvalue")
left.legend(fontsize=8)

V, F = scheme.characteristic_map(7).image
right.triplot(V[:, 0], V[:, 1], F, linewidth=0.3)
right.set_aspect("equal")
right.set_title("characteristic map, valence 7")
folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
figure.tight_layout()
figure.savefig(folder / "analyse.png", dpi=120)
scheme.picture().save(folder / "analyse-stencils.svg")
