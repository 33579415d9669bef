"""The notebooks run, and show what is stored in them. To store it anew, run this file by `python`."""

import base64
import io
import pathlib
import re

import pytest

nbformat = pytest.importorskip("nbformat")
nbclient = pytest.importorskip("nbclient")
pictures = pytest.importorskip("PIL.Image")
NOTEBOOKS = sorted((pathlib.Path(__file__).parents[2] / "examples" / "notebooks").glob("*.ipynb"))
#: Bytes of a notebook, at most.
LARGEST = 150_000
NUMBER = re.compile(r"-?\d+\.?\d*(?:e[-+]?\d+)?")


def executed(path):
    """A notebook with new outputs, small and without traces of the machine."""
    notebook = nbformat.read(path, as_version=4)
    where = {"metadata": {"path": str(path.parent)}}
    nbclient.NotebookClient(notebook, timeout=300, record_timing=False, coalesce_streams=True, resources=where).execute()
    notebook.metadata.language_info = {"name": "python"}
    for data in (output.get("data", {}) for cell in notebook.cells for output in cell.get("outputs", [])):
        if "text/html" in data:
            # the table has the picture
            data.pop("image/svg+xml", None)
        if "image/png" in data:
            data["image/png"] = in_few_colours(data["image/png"])
    return notebook


def in_few_colours(png):
    """A picture with a palette, which takes less room."""
    small = io.BytesIO()
    pictures.open(io.BytesIO(base64.b64decode(png))).convert("RGB").quantize(256, pictures.Quantize.MAXCOVERAGE).save(small, "PNG", optimize=True)
    return base64.b64encode(small.getvalue()).decode()


def kinds(cell):
    """The kinds of the outputs of a cell."""
    return [(output.output_type, *sorted(output.get("data", {})), output.get("name")) for output in cell.get("outputs", [])]


def numbers(cell):
    """The numbers that a cell prints."""
    texts = [output.get("text") or output.data["text/plain"] for output in cell.get("outputs", [])]
    return [float(number) for text in texts for number in NUMBER.findall(text)]


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_notebook(path):
    stored = nbformat.read(path, as_version=4).cells
    assert path.stat().st_size < LARGEST
    assert any("image/png" in kind for cell in stored for kind in kinds(cell))
    for before, now in zip(stored, executed(path).cells, strict=True):
        # warnings would tell where they come from
        assert kinds(before) == kinds(now) and "stderr" not in str(kinds(before)), now.source
        assert numbers(before) == pytest.approx(numbers(now), rel=1e-6), now.source


if __name__ == "__main__":
    for one in NOTEBOOKS:
        nbformat.write(executed(one), one)
