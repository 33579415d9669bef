"""Builds the package: with maturin, and with the crates that the command `recede` was compiled from, where it has been.

They are those of the package if the features are the same; `tests/install.rs` sees to that. A package that is built on its own does
without the crates that only the command needs.
"""

import json
import os
import shutil
import subprocess
from pathlib import Path

from maturin import *  # noqa: F403


def command_is_compiled() -> bool:
    """Whether the target folder of the workspace has the command `recede`, optimised."""
    cargo = shutil.which("cargo")
    if cargo is None:
        return False
    question = [cargo, "metadata", "--locked", "--no-deps", "--format-version=1", "--manifest-path"]
    answer = subprocess.run([*question, str(Path(__file__).with_name("Cargo.toml"))], stdout=subprocess.PIPE)
    if answer.returncode != 0:
        # cargo has written why, and will again for maturin
        return False
    target = Path(json.loads(answer.stdout)["target_directory"])
    return any((target / "release" / name).is_file() for name in ("recede", "recede.exe"))


if command_is_compiled():
    # `--config-settings=build-args=...`, where given, is what maturin takes instead
    os.environ.setdefault("MATURIN_PEP517_ARGS", "--features command")
