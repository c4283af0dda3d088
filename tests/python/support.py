"""What the tests of the Python module share: the program, and small scenes."""
import json
import os
import subprocess
import unittest

import numpy as np

import rayclock

PROGRAM = os.environ["RAYCLOCK"]

OCTAHEDRON = (
    np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], float),
    np.array([[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]]),
)


def program(*words):
    """Returns the JSON report of the program."""
    done = subprocess.run([PROGRAM, *map(str, words), "--json", "-"], check=True, capture_output=True, text=True)
    return json.loads(done.stdout)


def without_times(report):
    """Returns a report without what the host's clock says."""
    if isinstance(report, dict):
        return {k: without_times(v) for k, v in report.items() if k != "host" and "seconds" not in k}
    if isinstance(report, list):
        return [without_times(v) for v in report]
    return report


class Case(unittest.TestCase):
    maxDiff = 2000

    def refused(self, pattern, call, *args, **kwargs):
        """Checks that a call raises Error with one sentence that matches the pattern."""
        with self.assertRaisesRegex(rayclock.Error, pattern) as caught:
            call(*args, **kwargs)
        self.assertNotIn("\n", str(caught.exception))
