"""docs/meshes.md has a line for every fault, remark and repair that `limn check --json` names."""

import pathlib
import re
import sys

root = pathlib.Path(__file__).resolve().parents[2]
document = (root / "docs/meshes.md").read_text()


def names(pattern, *sources):
    found = set()
    for source in sources:
        for path in root.glob(source):
            found.update(re.findall(pattern, path.read_text()))
    return found


kinds = names(r'"((?:[a-z]+_)+[a-z]+)"', "src/limn/report/mesh_check_faults.cpp")
repairs = names(r'note\(work, "(\w+)"', "src/limn/mesh/repair/*.cpp")
assert len(kinds) > 10 and len(repairs) > 6, "the sources have other names than this test expects"
missing = sorted(name for name in kinds | repairs if f"`{name}`" not in document)
if missing:
    sys.exit("docs/meshes.md says nothing of " + ", ".join(missing))
