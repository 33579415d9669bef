"""What the package is built with: `build_package.py`, next to this folder."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).resolve().parent.parent


@pytest.mark.parametrize(
    ("compiled", "wanted", "chosen"),
    [
        ((), None, "None"),
        (("release/deps/recede", "debug/recede"), None, "None"),
        (("release/recede",), None, "--features command"),
        (("release/recede.exe",), None, "--features command"),
        (("release/recede",), "--profile dev", "--profile dev"),
    ],
)
def test_the_features_of_a_command_that_was_compiled_are_chosen(
    tmp_path: Path, compiled: tuple[str, ...], wanted: str | None, chosen: str
) -> None:
    (tmp_path / "maturin.py").touch()
    for name in compiled:
        file = tmp_path / "target" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.touch()
    environment = {**os.environ, "CARGO_TARGET_DIR": str(tmp_path / "target")}
    environment["PYTHONPATH"] = os.pathsep.join([str(tmp_path), str(HERE)])
    environment.pop("MATURIN_PEP517_ARGS", None)
    if wanted is not None:
        environment["MATURIN_PEP517_ARGS"] = wanted
    program = "import os, build_package; print(os.environ.get('MATURIN_PEP517_ARGS'))"
    answer = subprocess.run([sys.executable, "-c", program], env=environment, stdout=subprocess.PIPE, text=True, check=True)
    assert answer.stdout.strip() == chosen
