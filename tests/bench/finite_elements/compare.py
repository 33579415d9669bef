"""Error against time of `recede`, of the biquadratic program and of CalculiX on the same strip, as a table.

    cargo build --release --locked
    python tests/bench/finite_elements/compare.py target/release/recede [--docs]

Needs numpy, scipy and ccx (Debian: calculix-ccx). With --docs the table in docs/benchmark.md is remade. Everything runs on one
thread; times are those of the processor, from reading the input to the half-lengths, for `recede` the start of the command included.
"""
import json
import os
import resource
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
SCENE = "table1_R500_load1000"
MARKS = ["<!-- finite elements: begin -->", "<!-- finite elements: end -->"]


def python(script, element):
    environment = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")
    run = subprocess.run([sys.executable, HERE / script, str(element)], capture_output=True, text=True, env=environment)
    if run.returncode != 0:
        raise SystemExit(run.stdout + run.stderr)
    a, b, unknowns, seconds = run.stdout.split()
    return float(a), float(b), unknowns, float(seconds)


def children():
    """Time that the processor has spent on programs started from here."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def recede(command, *arguments):
    scene = ROOT / "tests/data/scenes" / f"{SCENE}.ron"
    count, start = 10, children()
    for _ in range(count):
        run = subprocess.run([command, "solve", scene, "--format", "json", *arguments], capture_output=True, text=True, check=True)
    seconds = (children() - start) / count
    answer = json.loads(run.stdout)
    a, b = [contact["half_length"] for contact in answer["contacts"]]
    return a, b, 2 * answer["modes"], seconds


def main():
    command = sys.argv[1]
    known = json.loads((ROOT / "tests/data/contact.json").read_text())[SCENE]["half_length"]
    rows = [("`recede solve`", recede(command))]
    rows += [(f"biquadratic elements, {e}", python("q9.py", e)) for e in (0.1, 0.05, 0.025)]
    rows += [(f"CalculiX, {e}", python("calculix.py", e)) for e in (0.05, 0.025)]
    table = ["| method, element length / thickness | unknowns | time | error of a | error of b |", "|---|---|---|---|---|"]
    for name, (a, b, unknowns, seconds) in rows:
        errors = [max(abs(found / true - 1), 1e-15) for found, true in zip((a, b), known)]
        table.append(f"| {name} | {unknowns} | {seconds:.2g} s | {errors[0]:.0e} | {errors[1]:.0e} |")
    text = "\n".join(table)
    print(text)
    if "--docs" in sys.argv:
        path = ROOT / "docs/benchmark.md"
        document = path.read_text()
        before, rest = document.split(MARKS[0])
        after = rest.split(MARKS[1])[1]
        path.write_text(f"{before}{MARKS[0]}\n\n{text}\n\n{MARKS[1]}{after}")


main()
