"""Sweeps, and the ways of their rows to other programs."""

import os
import pathlib
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor

import numpy as np
import pytest

import recede


@pytest.fixture
def swept(scene):
    return recede.sweep(scene, {"force": np.geomspace(1e-3, 1e-2, 30), "layer[1].thickness": [0.5, 1.0]})


VARY = {"force": np.geomspace(1e-3, 1e-2, 30), "layer[1].thickness": [0.5, 1.0]}


def test_rows_are_those_of_single_scenes(scene, swept):
    assert swept.rows == 60 and swept.solved.all()
    one = scene.with_number("force", VARY["force"][3]).with_number("layer[1].thickness", 0.5).solve()
    assert swept["contact_1_2_half_length"][6] == one.contacts[1].half_length
    assert swept["force"][6] == VARY["force"][3] and swept["layer_1_thickness"][7] == 1.0
    assert "punch_half_length" in swept._repr_html_() and "60 rows" in repr(swept)


def test_executors_of_all_kinds_make_the_same_bits(scene, swept):
    with ThreadPoolExecutor(2) as threads, ProcessPoolExecutor(2) as processes:
        for executor in (threads, processes):
            assert recede.sweep(scene, VARY, executor=executor, chunk=7) == swept


def test_progress_is_shown_and_changes_nothing(scene, swept, capsys):
    assert recede.sweep(scene, VARY, progress=True) == swept
    assert "60" in capsys.readouterr().err
    assert recede.sweep(scene, VARY) == swept and not capsys.readouterr().err


def test_a_cluster_makes_the_same_bits(scene, swept):
    distributed = pytest.importorskip("dask.distributed")
    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster,
        distributed.Client(cluster) as client,
    ):
        assert recede.sweep(scene, VARY, executor=client.get_executor(), chunk=7) == swept


def test_other_programs_take_tables_as_they_are(swept):
    pyarrow = pytest.importorskip("pyarrow")
    table = pyarrow.table(swept)
    assert table.column_names == list(swept) and table.num_rows == 60
    column = table["force"].chunks[0]
    # the same memory
    swept_again = recede.Columns(swept, swept.metadata)
    assert column.buffers()[1].address == swept["force"].ctypes.data
    del swept
    assert column[0].as_py() == 1e-3
    polars = pytest.importorskip("polars")
    assert polars.DataFrame(table)["status"].to_list() == ["solved"] * 60
    pandas = pytest.importorskip("pandas")
    assert pandas.DataFrame(swept_again).shape == pandas.DataFrame.from_arrow(table).shape == (60, len(table.column_names))


def test_parquet_files_know_their_scene(scene, swept, tmp_path):
    parquet = pytest.importorskip("pyarrow.parquet")
    swept.to_parquet(tmp_path / "rows.parquet")
    read = parquet.read_table(tmp_path / "rows.parquet")
    assert read["force"].to_pylist() == swept["force"].tolist() and list(tmp_path.iterdir()) == [tmp_path / "rows.parquet"]
    assert recede.Scene.from_ron(read.schema.metadata[b"scene"].decode()) == scene
    assert read.schema.metadata[b"tolerance"] == b"1e-10" and read.schema.metadata[b"version"].decode() == recede.__version__
    with pytest.raises(OSError):
        swept.to_parquet(tmp_path / "nowhere" / "rows.parquet")


def test_files_keep_links_and_permissions_and_pipes(swept, tmp_path):
    file, link = tmp_path / "rows.csv", tmp_path / "link.csv"
    file.write_text("old")
    file.chmod(0o600)
    link.symlink_to(file)
    swept.to_csv(link)
    assert link.is_symlink() and file.stat().st_mode & 0o777 == 0o600
    assert file.read_text().count("\n") == 61 and len(list(tmp_path.iterdir())) == 2
    pipe = tmp_path / "pipe.csv"
    os.mkfifo(pipe)
    read = []
    reader = threading.Thread(target=lambda: read.append(pipe.read_text()))
    reader.start()
    swept.to_csv(pipe)
    reader.join(10)
    assert read == [file.read_text()] and pipe.is_fifo()


def test_arrow_keeps_the_memory_alive(scene):
    pyarrow = pytest.importorskip("pyarrow")
    table = pyarrow.table(recede.sweep(scene, {"force": [0.001, 0.002]}))
    assert table["force"].to_pylist() == [0.001, 0.002]


def test_rows_without_solution_say_why(scene):
    found = recede.sweep(scene, {"force": [1e9, 0.002]})
    assert list(found.solved) == [False, True] and found["message"][0] and np.isnan(found["punch_half_length"][0])


def test_files_are_those_of_the_command(scene, swept, tmp_path):
    swept.to_csv(tmp_path / "python.csv")
    command = os.environ.get("RECEDE")
    lines = (tmp_path / "python.csv").read_text().splitlines()
    assert len(lines) == 61 and lines[0].split(",") == list(swept)
    assert list(tmp_path.iterdir()) == [tmp_path / "python.csv"]
    if command:
        (tmp_path / "scene.ron").write_text(scene.to_ron())
        values = ",".join(repr(float(v)) for v in VARY["force"])
        arguments = ["--vary", f"force=[{values}]", "--vary", "layer[1].thickness=[0.5,1]", "--out", "command.csv"]
        subprocess.run([command, "sweep", "scene.ron", *arguments], cwd=tmp_path, check=True, capture_output=True)
        assert (tmp_path / "command.csv").read_text() == (tmp_path / "python.csv").read_text()


def test_approach_and_extremes():
    stack = [recede.Homogeneous(thickness=1.0, young=1.0, poisson=0.3), recede.Bonded(), recede.Rigid()]
    scene = recede.Scene(stack, recede.Parabola(radius=10.0), 0.01)
    found = recede.sweep(scene, {"force": [0.01, 0.02]}, approach=True, extremes=True)
    assert (np.diff(found["approach"]) > 0).all() and any("von_mises" in name for name in found)


@pytest.mark.parametrize(
    ("vary", "message"),
    [
        ({}, "nothing varies"),
        ({"layer[9].beta": [1.0]}, "layer"),
        ({"force": [1.0, -1.0]}, "-1"),
        ({"force": [float("nan")]}, "NaN"),
        ({"force": ["1"]}, "number"),
        ({"force": []}, "force"),
    ],
)
def test_what_cannot_vary_is_refused(scene, vary, message):
    with pytest.raises((recede.InputError, ValueError, TypeError), match=message):
        recede.sweep(scene, vary)
    with pytest.raises(TypeError, match="Scene"):
        recede.sweep("scene.ron", {"force": [1.0]})


LONG = """
import numpy, recede, sys, time
scene = recede.Scene.read(sys.argv[1])
print("begun", flush=True)
try:
    recede.sweep(scene, {"force": numpy.linspace(1e-3, 1e-2, 300_000)}, threads=1)
except recede.Interrupted as stopped:
    table = stopped.table
    print(table.rows, table.solved.all(), table["force"][-1] > 0)
"""


def test_an_interrupted_sweep_keeps_its_rows(tmp_path):
    scene = pathlib.Path(__file__).parents[2] / "examples" / "scenes" / "strip_on_rigid.ron"
    process = subprocess.Popen([sys.executable, "-c", LONG, str(scene)], stdout=subprocess.PIPE, text=True)
    assert process.stdout.readline() == "begun\n"
    time.sleep(1.5)
    interrupted = time.monotonic()
    process.send_signal(signal.SIGINT)
    rows, solved, positive = process.communicate(timeout=60)[0].split()
    # a second is meant; machines that test are busy
    assert time.monotonic() - interrupted < 5
    assert int(rows) > 0 and solved == positive == "True"


def test_several_threads_may_sweep_at_once(scene, swept):
    found = []
    threads = [threading.Thread(target=lambda: found.append(recede.sweep(scene, VARY))) for _ in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == [swept] * 3


def test_each_row_of_a_table_is_a_scene(scene):
    pandas = pytest.importorskip("pandas")
    rows = {"force": [1e-3, 2e-3, 1e-3], "layer[1].thickness": [0.5, 0.25, 1.0]}
    swept = recede.sweep(scene, rows=rows)
    assert swept.rows == 3 and swept.solved.all()
    assert swept == recede.sweep(scene, rows=pandas.DataFrame(rows))
    probed = recede.sweep(scene, rows=rows, at=["0,0=sigma_yy"])
    assert probed["sigma_yy_at_0_0"] == pytest.approx(-swept["punch_central_pressure"], rel=1e-9)
    one = scene.with_number("force", 2e-3).with_number("layer[1].thickness", 0.25).solve()
    assert swept["contact_1_2_half_length"][1] == one.contacts[1].half_length
    with ThreadPoolExecutor(2) as threads:
        assert recede.sweep(scene, rows=rows, executor=threads, chunk=2) == swept
    with pytest.raises(ValueError, match="either `vary` or `rows`, not both"):
        recede.sweep(scene, {"force": [1.0]}, rows=rows)
    with pytest.raises(recede.InputError, match="there is no eps_rr in this geometry"):
        recede.sweep(scene, rows=rows, at=["0,0=eps_rr"])
    with pytest.raises(recede.InputError, match="found 2 values, force has 3"):
        recede.sweep(scene, rows={"force": [1e-3, 2e-3, 3e-3], "layer[1].thickness": [1.0, 2.0]})
