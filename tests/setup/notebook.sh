#!/usr/bin/env bash
# notebook.sh NOTEBOOK FOLDER: runs a notebook on a small frame, and demands its table and its two figures. PYTHON is the
# interpreter, and PYTHONPATH has the module.
# Exit code 77: the module, Jupyter, pandas or matplotlib is not installed.
set -eu
notebook=$1
export SIZE=64x48 RAYCLOCK_CACHE=$2/cache IPYTHONDIR=$2/ipython JUPYTER_CONFIG_DIR=$2/jupyter MPLCONFIGDIR=$2/matplotlib
python=${PYTHON:-/usr/bin/python3}
"$python" -c 'import rayclock' 2>/dev/null || {
  echo "the Python module is not built: python3-dev, python3-numpy or pybind11-dev is not installed"
  exit 77
}
"$python" -c 'import nbconvert, nbclient, ipykernel, pandas, matplotlib' 2>/dev/null || {
  echo "python3-nbconvert, python3-ipykernel, python3-pandas or python3-matplotlib is not installed"
  exit 77
}
rm -rf "$2"
mkdir -p "$2"
"$python" -m nbconvert --to notebook --execute --output-dir "$2" --output done.ipynb "$notebook"
"$python" - "$2/done.ipynb" "$(basename "$notebook")" <<'END'
import json, sys
cells = [c for c in json.load(open(sys.argv[1]))["cells"] if c["cell_type"] == "code"]
outputs = [o for c in cells for o in c["outputs"]]
text = "".join("".join(o.get("text", [])) for o in outputs)
assert sum("image/png" in o.get("data", {}) for o in outputs) == 2, "two figures"
table = next("".join(o["data"]["text/plain"]) for o in outputs if "text/html" in o.get("data", {}))
assert "NaN" not in table, table
if sys.argv[2] == "sweep.ipynb":
    assert "32 points of gears:8 at 64x48" in text, text
    assert "ddr3" in table and len(table.splitlines()) == 9, table
else:
    assert " rays, 0 wrong" in text, text
    assert "diffuse 2" in table and "random" in table and len(table.splitlines()) == 7, table
assert not any(o.get("name") == "stderr" for o in outputs), [o for o in outputs if o.get("name") == "stderr"]
END
