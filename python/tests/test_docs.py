"""What docs/python.md shows is run, block after block."""

import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).parents[2]


def test_blocks_of_the_page_run(tmp_path):
    text = (ROOT / "docs" / "python.md").read_text(encoding="utf-8")
    blocks = re.findall(r"^```python\n(.*?)^```", text, re.DOTALL | re.MULTILINE)
    assert len(blocks) > 5
    # as a file, since other processes read it again
    program = "import warnings\n" + "\n".join(blocks)
    (tmp_path / "page.py").write_text(program, encoding="utf-8")
    ran = subprocess.run([sys.executable, "page.py"], cwd=tmp_path, capture_output=True, text=True, timeout=300)
    assert ran.returncode == 0, ran.stderr
    assert "caret" not in ran.stderr and "thickness" in ran.stdout
    readme = re.findall(r"^```python\n(.*?)^```", (ROOT / "python" / "README.md").read_text(), re.DOTALL | re.MULTILINE)
    assert subprocess.run([sys.executable, "-c", readme[0]], capture_output=True).returncode == 0


def test_the_example_of_the_package_is_right():
    import doctest

    import recede

    assert doctest.testmod(recede).failed == 0
