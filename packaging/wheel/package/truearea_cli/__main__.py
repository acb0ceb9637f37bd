"""Runs the program that is installed beside this Python: ``python -m truearea_cli``."""

import os
import subprocess
import sys
import sysconfig
from pathlib import Path


def program() -> Path:
    """Returns the path of the program, in the scripts of this environment or of the user."""
    name = "truearea" + (sysconfig.get_config_var("EXE") or "")
    schemes = [sysconfig.get_default_scheme(), sysconfig.get_preferred_scheme("user")]
    folders = [sysconfig.get_path("scripts", scheme) for scheme in schemes]
    found = next((Path(folder, name) for folder in folders if Path(folder, name).is_file()), None)
    if found is None:
        sys.exit(f"error: {name} is in none of {', '.join(folders)}; install truearea-cli again")
    return found


def main() -> None:
    """Runs the program with the arguments of this process, and ends with its status."""
    call = [str(program()), *sys.argv[1:]]
    if sys.platform == "win32":
        sys.exit(subprocess.run(call).returncode)
    os.execv(call[0], call)


if __name__ == "__main__":
    main()
