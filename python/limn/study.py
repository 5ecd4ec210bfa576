"""``python3 -m limn.study STUDY.toml -o FOLDER --dask SCHEDULER``: what ``limn study --dask`` starts."""

import sys

from . import _study, _study_command

if __name__ == "__main__":
    sys.exit(_study_command.main(sys.argv[1:]))

sys.modules[__name__] = _study.study  # type: ignore[assignment]  # `import limn.study` is limn.study
