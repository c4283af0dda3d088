"""run.py FILE: runs the tests in a file. Exit code 77, with the reason: none of them can run here."""
import sys
import unittest
from pathlib import Path

try:
    import numpy   # noqa: F401
except ImportError as error:
    print(f"skipped: {error}; python3-numpy is not installed for {sys.executable}")
    sys.exit(77)
file = Path(sys.argv[1])
sys.path.insert(0, str(file.parent))
result = unittest.main(module=file.stem, argv=["run.py", "-v", *sys.argv[2:]], exit=False).result
if result.testsRun == len(result.skipped) > 0:
    sys.exit(77)
sys.exit(not result.wasSuccessful())
