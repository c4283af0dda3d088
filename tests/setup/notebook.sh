#!/usr/bin/env bash
# notebook.sh NOTEBOOK RAYCLOCK FOLDER: runs the notebook on a small frame, and demands its table and its two figures.
# Exit code 77: Jupyter, pandas or matplotlib is not installed.
set -eu
notebook=$1
export RAYCLOCK=$2 SIZE=64x48 RAYCLOCK_CACHE=$3/cache IPYTHONDIR=$3/ipython JUPYTER_CONFIG_DIR=$3/jupyter MPLCONFIGDIR=$3/matplotlib
python=/usr/bin/python3
"$python" -c 'import nbconvert, nbclient, ipykernel, pandas, matplotlib' 2>/dev/null || {
  echo "python3-nbconvert, python3-ipykernel, python3-pandas or python3-matplotlib is not installed"
  exit 77
}
rm -rf "$3"
mkdir -p "$3"
"$python" -m nbconvert --to notebook --execute --output-dir "$3" --output done.ipynb "$notebook"
"$python" - "$3/done.ipynb" <<'END'
import json, sys
cells = [c for c in json.load(open(sys.argv[1]))["cells"] if c["cell_type"] == "code"]
outputs = [o for c in cells for o in c["outputs"]]
text = "".join("".join(o.get("text", [])) for o in outputs)
assert "32 points of gears:8 at 64x48" in text, text
assert sum("image/png" in o.get("data", {}) for o in outputs) == 2, "two figures"
table = next("".join(o["data"]["text/plain"]) for o in outputs if "text/html" in o.get("data", {}))
assert "ddr3" in table and "NaN" not in table and len(table.splitlines()) == 9, table
assert not any(o.get("name") == "stderr" for o in outputs), [o for o in outputs if o.get("name") == "stderr"]
END
