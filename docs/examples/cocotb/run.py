#!/usr/bin/env python3
"""run.py [FOLDER]: builds rc_tri for Icarus Verilog and runs test_tri.py against it, in FOLDER (default: build/cocotb).

Needs Icarus Verilog (Debian: iverilog), cocotb (pip install cocotb) and the module rayclock. RTL in the environment is a
changed copy of the folder rtl. COUNT is the number of requests.
Exit code 77, with the reason: something is not installed.
"""
import os
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
PROJECT = HERE.parents[2]


def skip(reason):
    print("skipped:", reason)
    sys.exit(77)


try:
    import rayclock   # noqa: F401
except ImportError as error:
    skip(f"the module rayclock is not there: {error}")
try:
    import cocotb   # noqa: F401
    try:
        from cocotb_tools.runner import get_runner   # cocotb 2
    except ImportError:
        from cocotb.runner import get_runner
except ImportError as error:
    skip(f"{error}; pip install cocotb")
if not shutil.which("iverilog"):
    skip("iverilog is not installed")

folder = Path(sys.argv[1] if len(sys.argv) > 1 else PROJECT / "build/cocotb").resolve()
rtl = Path(os.environ.get("RTL", PROJECT / "rtl"))
folder.mkdir(parents=True, exist_ok=True)
# One source, since Icarus 11 lacks some of the language: the package first.
sources = [rtl / "rc_pkg.sv"] + sorted(p for p in rtl.rglob("*.sv") if p.name != "rc_pkg.sv")
text = "".join(p.read_text() for p in sources)
changed = subprocess.run(["sed", "-f", PROJECT / "sim/silicon/export/icarus.sed"], input=text, text=True, check=True,
                         capture_output=True).stdout
(folder / "icarus.sv").write_text(changed)

os.environ["PYTHONPATH"] = os.pathsep.join([str(HERE), *sys.path])
os.environ.setdefault("PYGPI_PYTHON_BIN", sys.executable)
runner = get_runner("icarus")
runner.build(verilog_sources=[folder / "icarus.sv"], hdl_toplevel="rc_tri", build_dir=folder, always=True,
             build_args=["-g2012", "-DSYNTHESIS"])
results = runner.test(hdl_toplevel="rc_tri", test_module="test_tri", build_dir=folder, test_dir=folder)
text = Path(results).read_text()
sys.exit("<failure" in text or "<error" in text or "<testcase" not in text)
