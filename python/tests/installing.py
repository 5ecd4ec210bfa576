"""Installs the module as a user would, by pip into a virtual environment and as a wheel.

    installing.py BUILD    with the extension of that build folder; no network is needed
"""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
TRIED = """
import pathlib, sys, limn
assert pathlib.Path(limn.__file__).is_relative_to(sys.prefix), limn.__file__
assert limn.Scheme("loop").eigen(6)["components"]["tangent"] == 0.5
assert (pathlib.Path(limn.__file__).parent / "py.typed").is_file()
print(limn.__version__)
"""


def run(*words):
    environment = {**os.environ, "LIMN_BUILT": str(pathlib.Path(sys.argv[1]).resolve())}
    environment.pop("PYTHONPATH", None)
    done = subprocess.run(
        list(map(str, words)), env=environment, capture_output=True, text=True, check=False
    )
    if done.returncode != 0:
        sys.exit(f"{words}\n{done.stdout}\n{done.stderr}")
    return done.stdout.strip()


def copy_of_the_tree(folder):
    """pip writes into the tree that it installs: into a copy here."""
    for name in ("setup.py", "pyproject.toml", "CMakeLists.txt", "README.md", "LICENSE"):
        shutil.copy(ROOT / name, folder)
    shutil.copytree(ROOT / "python" / "limn", folder / "python" / "limn")


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        tree = folder / "tree"
        tree.mkdir()
        copy_of_the_tree(tree)
        offline = ["--no-build-isolation", "--no-index", "--no-deps", "-q"]
        versions = []
        for kind in ("install", "wheel"):
            run(sys.executable, "-m", "venv", "--system-site-packages", folder / kind)
            python = folder / kind / "bin" / "python"
            what = tree
            if kind == "wheel":
                run(python, "-m", "pip", "wheel", *offline, "-w", folder / "wheels", tree)
                (what,) = (folder / "wheels").glob("limn-*.whl")
            run(python, "-m", "pip", "install", *offline, what)
            versions.append(run(python, "-c", TRIED))
        assert versions[0] == versions[1] and versions[0] in (ROOT / "CMakeLists.txt").read_text()
    print("limn", versions[0], "installed, and from a wheel")


main()
