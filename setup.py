"""Builds the Python module by CMake: pip install --no-build-isolation .

The compiler, CMake, Ninja and the libraries of packages.txt ([product]) must be there. The build
folder is build/wheel, and stays. LIMN_BUILT=FOLDER: another one, whose module is taken as it is.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent
BUILD = ROOT / "build" / "wheel"


class CMakeBuild(build_ext):
    """The extension, made by the target limn_python."""

    def build_extension(self, ext):
        built = os.environ.get("LIMN_BUILT")
        folder = pathlib.Path(built).resolve() if built else BUILD
        if not built:
            configure = ["cmake", "--preset", "release", "-B", str(folder)]
            configure += [f"-DLIMN_PYTHON_EXECUTABLE={sys.executable}", "-DLIMN_PYTHON=ON"]
            subprocess.run(configure, cwd=ROOT, check=True)
            jobs = os.environ.get("LIMN_JOBS", str(os.cpu_count() or 1))
            build = ["cmake", "--build", str(folder), "--target", "limn_python"]
            subprocess.run([*build, "--parallel", jobs], cwd=ROOT, check=True)
        made = pathlib.Path(self.get_ext_fullpath(ext.name)).resolve()
        made.parent.mkdir(parents=True, exist_ok=True)
        found = folder / "python" / "limn" / made.name
        if not found.is_file():
            sys.exit(f"CMake made no {found}: are pybind11 and NumPy there?")
        shutil.copyfile(found, made)


def version():
    """That of CMakeLists.txt, its one place."""
    return re.search(r"VERSION (\d+\.\d+\.\d+)", (ROOT / "CMakeLists.txt").read_text())[1]


setup(
    version=version(),
    packages=["limn"],
    package_dir={"": "python"},
    package_data={"limn": ["*.pyi", "py.typed"]},
    ext_modules=[Extension("limn._limn", sources=[])],
    cmdclass={"build_ext": CMakeBuild},
    zip_safe=False,
)
