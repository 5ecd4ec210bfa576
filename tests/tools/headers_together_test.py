"""All headers of the library can be included in one source: no two of them define one name.

    headers_together_test.py BUILD      a build folder, whose flags are taken"""

import json
import pathlib
import shlex
import subprocess
import sys

PROJECT = pathlib.Path(__file__).resolve().parents[2]
ANY_SOURCE = "src/limn/refine/refine.cpp"

build = pathlib.Path(sys.argv[1])
commands = json.loads((build / "compile_commands.json").read_text())
flags = shlex.split(next(c["command"] for c in commands if c["file"] == str(PROJECT / ANY_SOURCE)))
headers = sorted(p.relative_to(PROJECT / "src") for p in PROJECT.glob("src/limn/**/*.h"))
text = "".join(f'#include "{header}"\n' for header in headers)
check = flags[:flags.index("-o")] + ["-w", "-fsyntax-only", "-x", "c++", "-"]
run = subprocess.run(check, cwd=build, input=text, text=True, capture_output=True)
sys.stderr.write(run.stderr)
print(f"{len(headers)} headers in one source: {'accepted' if run.returncode == 0 else 'refused'}")
sys.exit(run.returncode)
