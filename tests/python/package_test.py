"""The package as a whole: its names, its documentation and its types."""
import inspect
import os
import subprocess
import sys
import unittest
from pathlib import Path

import rayclock
from support import Case

SOURCE = Path(os.environ["RAYCLOCK_SOURCE"])


class Package(Case):
    def test_every_public_name_has_a_description(self):
        for name in rayclock.__all__:
            value = getattr(rayclock, name)
            if not isinstance(value, (str,)) and not name.endswith("dtype"):
                self.assertTrue(inspect.getdoc(value), name)

    def test_the_types_of_the_compiled_module_are_up_to_date(self):
        made = subprocess.run([sys.executable, SOURCE / "python/stubs.py"], check=True, capture_output=True, text=True)
        self.assertEqual(made.stdout, (SOURCE / "python/rayclock/_rayclock.pyi").read_text(),
                         "write it anew: python/stubs.py python/rayclock/_rayclock.pyi")
        self.assertTrue((Path(rayclock.__file__).parent / "py.typed").exists())

    def test_the_version_is_that_of_the_project(self):
        self.assertIn(f"VERSION {rayclock.__version__} ", (SOURCE / "CMakeLists.txt").read_text())
        self.assertIn(f'version = "{rayclock.__version__}"', (SOURCE / "pyproject.toml").read_text())

    def test_the_package_runs_without_pandas(self):
        code = "import sys; sys.modules['pandas'] = None; import rayclock; rayclock.simulate('tetra:2', size=(8, 8), clock=66)"
        subprocess.run([sys.executable, "-c", code], check=True)


if __name__ == "__main__":
    unittest.main()
