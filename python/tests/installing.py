"""Installs the module as a user would, by pip into a virtual environment and as a wheel.

    installing.py BUILD    with the extension of that build folder; no network is needed

Of an install without LIMN_BUILT, which compiles for long, all but the compilation: a `cmake` stands
in that notes how it is called and takes the extension of BUILD.
"""

import json
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
for name in ("py.typed", "_limn.pyi"):
    assert (pathlib.Path(limn.__file__).parent / name).is_file(), name
print(limn.__version__)
"""
CMAKE = """#!/bin/sh
echo "$@" >> "{log}"
[ "$1" = --build ] || exit 0
mkdir -p "$2/python/limn" && cp "{built}"/python/limn/_limn.*.so "$2/python/limn"
"""


def run(*words, **changes):
    environment = {**os.environ, "LIMN_BUILT": str(pathlib.Path(sys.argv[1]).resolve()), **changes}
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


def made_by_cmake(python, folder, tree, offline):
    """pip install without an extension at hand."""
    bin, log = folder / "bin", folder / "cmake.log"
    bin.mkdir()
    (bin / "cmake").write_text(CMAKE.format(log=log, built=pathlib.Path(sys.argv[1]).resolve()))
    (bin / "cmake").chmod(0o755)
    path = f"{bin}{os.pathsep}{os.environ['PATH']}"
    run(python, "-m", "pip", "install", *offline, tree, PATH=path, LIMN_BUILT="", LIMN_JOBS="3")
    configure, build = log.read_text().splitlines()
    assert configure.startswith("--preset release -B ") and "-DLIMN_PYTHON=ON" in configure
    # the environment's interpreter, through whatever link
    assert f"-DLIMN_PYTHON_EXECUTABLE={folder}" in configure, configure
    assert build.endswith("--target limn_python --parallel 3"), build
    presets = json.loads((ROOT / "CMakePresets.json").read_text())["configurePresets"]
    assert any(preset["name"] == "release" for preset in presets)


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        tree = folder / "tree"
        tree.mkdir()
        copy_of_the_tree(tree)
        offline = ["--no-build-isolation", "--no-index", "--no-deps", "-q"]
        versions = []
        for kind in ("install", "wheel", "cmake"):
            run(sys.executable, "-m", "venv", "--system-site-packages", folder / kind)
            python = folder / kind / "bin" / "python"
            if kind == "install":
                run(python, "-m", "pip", "install", *offline, tree)
            elif kind == "wheel":
                run(python, "-m", "pip", "wheel", *offline, "-w", folder / "wheels", tree)
                (wheel,) = (folder / "wheels").glob("limn-*.whl")
                run(python, "-m", "pip", "install", *offline, wheel)
            else:
                made_by_cmake(python, folder, tree, offline)
            versions.append(run(python, "-c", TRIED))
        assert len(set(versions)) == 1
        assert f"VERSION {versions[0]}" in (ROOT / "CMakeLists.txt").read_text()
    print("limn", versions[0], "installed, from a wheel, and with an extension that CMake makes")


main()
