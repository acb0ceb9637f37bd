"""Prints the versions, and where the command line is: ``python -m truearea``."""

from __future__ import annotations

import shutil

from truearea import show_versions


def main() -> None:
    """Print the versions and the path of the command."""
    show_versions()
    command = shutil.which("truearea")
    print(f"command     {command or 'not on the path; from a checkout: cargo install --path crates/apps/cli'}")


if __name__ == "__main__":
    main()
