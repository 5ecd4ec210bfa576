"""tools/check_floors finds each kind of fault, on its line, and nothing in a sound tree."""

import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

PROJECT = pathlib.Path(__file__).parents[2]


class CheckFloors(unittest.TestCase):
    def faults(self, files):
        """The output for a tree of these files, {path: text}."""
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder) / "tree"
            (root / "tools").mkdir(parents=True)
            shutil.copy(PROJECT / "tools/floors.txt", root / "tools")
            for name, text in files.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text.replace("ROOT", str(root.resolve())))
            run = subprocess.run([sys.executable, PROJECT / "tools/check_floors", root],
                                 capture_output=True, text=True)
            self.assertEqual(run.stderr, "")
            self.assertEqual(run.returncode, 1 if run.stdout else 0)
            return run.stdout.splitlines()

    def assert_fault(self, name, text, line, words):
        found = self.faults({name: text})
        self.assertEqual(len(found), 1, found)
        self.assertTrue(found[0].startswith(f"{name}:{line}: "), found)
        self.assertIn(words, found[0])

    def test_sound(self):
        self.assertEqual(self.faults({
            "src/limn/mesh/a.h": '#include <vector>\n#include "limn/base/b.h"\n#include "limn/mesh/c.h"\n',
            "src/limn/number/ball.cpp": "#include <flint/arb.h>\n",
            "apps/limn/main.cpp": '#include "options.h"\n#include "limn/report/table.h"\n',
            "tests/mesh/a_test.cpp": '#include <gtest/gtest.h>\n#include "limn/report/table.h"\n',
            "tests/peers/a_test.cpp": "#include <CGAL/Surface_mesh.h>\n",
        }), [])

    def test_higher_floor(self):
        self.assert_fault("src/limn/mesh/io/a.cpp", '\n#include "limn/scheme/b.h"\n', 2, "floor 2")

    def test_same_floor(self):
        self.assert_fault("src/limn/mesh/a.h", '# include "limn/number/b.h"\n', 1, "floor 1")

    def test_unknown_folders(self):
        self.assert_fault("src/limn/attic/a.h", "#include <vector>\n", 1, "no floor")
        self.assert_fault("src/limn/mesh/a.h", '#include "limn/attic/a.h"\n', 1, "no floor")

    def test_spelling(self):
        self.assert_fault("src/limn/mesh/a.cpp", '#include "a.h"\n', 1, 'from "limn/" on')
        self.assert_fault("src/limn/mesh/a.cpp", "#include <limn/mesh/a.h>\n", 1, "with quotes")

    def test_front(self):
        self.assert_fault("src/limn/report/a.cpp", '#include "limn/limn.h"\n', 1, "those who use")
        self.assertEqual(self.faults({
            "src/limn/limn.h": '#include "limn/report/a.h"\n#include "limn/base/a.h"\n',
            "examples/a.cpp": '#include "limn/limn.h"\n'}), [])

    def test_reserved_headers(self):
        self.assert_fault("src/limn/refine/a.cpp", "#include <flint/arb.h>\n", 1, "only")
        self.assert_fault("tests/mesh/a_test.cpp", "#include <CGAL/Surface_mesh.h>\n", 1, "only")
        self.assert_fault("src/limn/base/a.h", "#include <gtest/gtest.h>\n", 1, "only")

    def test_machine_paths(self):
        self.assert_fault("docs/a.md", "fine\nsee ROOT/docs\n", 2, "path of one machine")
        self.assert_fault("docs/a.md", "see /home/" "someone/docs\n", 1, "path of one machine")


if __name__ == "__main__":
    unittest.main()
