"""tools/scheme_table: the page that it makes of a program's answers, and that it sees a difference."""

import importlib.machinery
import importlib.util
import json
import pathlib
import stat
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
TOOL = ROOT / "tools/scheme_table"

# answers `schemes` and `show NAME` as limn does
FAKE = """#!{python}
import json, sys
schemes = json.loads({schemes!r})
words = sys.argv[1:]
if words == ["schemes", "--json"]:
    print(json.dumps({{"schemes": [{{"name": one["name"]}} for one in schemes]}}))
elif words[0] == "show" and words[2] == "--json":
    print(json.dumps(next(one for one in schemes if one["name"] == words[1])))
else:
    sys.exit("limn: unknown")
"""
SCHEMES = [
    {"name": "one", "title": "One", "split": "sqrt3", "source": "A. Author, 2000", "parameters": [],
     "notes": "By A. Author, of |two| kinds. More of it."},
    {"name": "two", "title": "Two", "split": "midedge", "parameters": [
        {"name": "w", "value": "1/16"}, {"name": "b", "value": "2"}]},
]


def tool():
    loader = importlib.machinery.SourceFileLoader("scheme_table", str(TOOL))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("scheme_table", loader))
    sys.dont_write_bytecode = True
    loader.exec_module(module)
    return module


class SchemeTable(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.limn = pathlib.Path(folder.name) / "limn"
        self.limn.write_text(FAKE.format(python=sys.executable, schemes=json.dumps(SCHEMES)))
        self.limn.chmod(self.limn.stat().st_mode | stat.S_IXUSR)

    def run_tool(self, *arguments):
        return subprocess.run([sys.executable, TOOL, *arguments], capture_output=True, text=True)

    def test_a_line_for_each_scheme(self):
        made = self.run_tool(self.limn)
        self.assertEqual(made.returncode, 0, made.stderr)
        self.assertIn("limn ships 2 schemes", made.stdout)
        self.assertIn("| [one](../schemes/one.toml) | sqrt3 | One: By A. Author, of \\|two\\| kinds |  | A. Author, 2000 |\n",
                      made.stdout)
        self.assertTrue(made.stdout.endswith(
            "| [two](../schemes/two.toml) | midedge | Two | w = 1/16, b = 2 |  |\n"))

    def test_a_page_of_other_schemes_is_seen(self):
        made = self.run_tool(self.limn, "--check")
        self.assertEqual(made.returncode, 1)
        self.assertRegex(made.stdout, r"^docs/schemes.md:\d+: is: limn ships \d+ schemes")
        self.assertIn("limn says: limn ships 2 schemes", made.stdout)

    def test_what_limn_refuses_is_told(self):
        self.limn.write_text(f"#!{sys.executable}\nimport sys\nsys.exit('limn: no')\n")
        made = self.run_tool(self.limn)
        self.assertEqual(made.returncode, 1)
        self.assertIn("schemes: limn: no", made.stderr)

    def test_bad_usage(self):
        for arguments in ([], ["--check"], [self.limn, "--wrong"]):
            self.assertEqual(self.run_tool(*arguments).returncode, 1, arguments)

    def test_first_sentences(self):
        first = tool().first_sentence
        self.assertEqual(first("The third of C. Loop's. More."), "The third of C. Loop's")
        self.assertEqual(first("Saddles have 1/4. More."), "Saddles have 1/4")
        self.assertEqual(first("No end"), "No end")


if __name__ == "__main__":
    unittest.main()
