"""The cocotb example: rc_tri under Icarus Verilog answers what the function answers, and a fault is found."""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from support import Case

SOURCE = Path(os.environ["RAYCLOCK_SOURCE"])


class Example(Case):
    def run_example(self, rtl):
        # ./bootstrap test puts cocotb into an environment of its own.
        places = [str(p) for p in SOURCE.glob("build/cocotb/lib/python3*/site-packages")]
        with tempfile.TemporaryDirectory() as folder:
            example = SOURCE / "docs/examples/cocotb/run.py"
            done = subprocess.run([sys.executable, example, folder], capture_output=True, text=True,
                                  env={**os.environ, "COUNT": "200", "RTL": str(rtl),
                                       "PYTHONPATH": os.pathsep.join([os.environ["PYTHONPATH"], *places])})
        if done.returncode == 77:
            self.skipTest(done.stdout.strip())
        return done

    def test_rc_tri_answers_what_the_function_answers(self):
        done = self.run_example(SOURCE / "rtl")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertRegex(done.stdout, r"200 answers in \d+ cycles are those of rayclock.unit.tri")

    def test_swapped_signals_are_found(self):
        with tempfile.TemporaryDirectory() as folder:
            rtl = shutil.copytree(SOURCE / "rtl", Path(folder) / "rtl")
            file = rtl / "unit/tri/rc_tri.sv"
            text = file.read_text()
            changed = text.replace(".u_i(pre.u), .v_i(pre.v)", ".u_i(pre.v), .v_i(pre.u)")
            self.assertNotEqual(changed, text)
            file.write_text(changed)
            done = self.run_example(rtl)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("expected", done.stdout)


if __name__ == "__main__":
    unittest.main()
