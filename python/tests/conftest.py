"""What the tests share. They need LIMN_COMMAND, the command of the same build."""

import json
import os
import pathlib
import subprocess

import numpy as np
import pytest

import limn

EXAMPLES = pathlib.Path(__file__).parents[2] / "examples"
TRIANGLES = str(EXAMPLES / "bracket.obj")
QUADS = str(EXAMPLES / "bracket-quads.obj")


class Command:
    """The command: command("eigen", "loop") runs `limn eigen loop --json` and gives what it prints."""

    def run(self, *arguments):
        words = [os.environ["LIMN_COMMAND"], *map(str, arguments), "--json"]
        return subprocess.run(words, capture_output=True, check=False)

    def __call__(self, *arguments):
        done = self.run(*arguments)
        assert done.returncode in (0, 3), done.stderr.decode()
        return json.loads(done.stdout)

    def agrees(self, call, *arguments, pick=lambda printed: printed):
        """call() gives what the command prints, or refuses what it refuses in the same words."""
        done = self.run(*arguments)
        if done.returncode != 2:
            assert call() == pick(json.loads(done.stdout))
            return True
        with pytest.raises(limn.Error) as caught:
            call()
        said = ["limn: " + line for line in str(caught.value).splitlines()]
        assert done.stderr.decode().splitlines() == said
        return False


@pytest.fixture(scope="session")
def command():
    return Command()


def tetrahedron():
    vertices = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]], dtype=float)
    return vertices, np.array([[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]], dtype=np.int32)


def cube():
    vertices = np.array(
        [[x, y, z] for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)], dtype=float
    )
    faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
    return vertices, np.array(faces, dtype=np.int32)


def mesh_of(scheme):
    """A closed control mesh that the scheme refines."""
    return tetrahedron() if scheme.split.startswith(("triangle", "sqrt3")) else cube()


SHIPPED = limn.schemes()
# without those of triangles and quads in one mesh, whose analyses are of either lattice
ONE_LATTICE = [name for name in SHIPPED if limn.Scheme(name).split != "quad-triangle"]
