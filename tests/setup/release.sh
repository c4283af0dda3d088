#!/usr/bin/env bash
# release.sh SOURCE: what tests/setup/release does before it builds, with stand-ins for apt, debootstrap, unshare and id.
set -euo pipefail
source=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
tree="$work/a tree"
mkdir -p "$tree/tests/setup" "$work/bin"
cp "$source/bootstrap" "$tree"
cp "$source/tests/setup/release" "$tree/tests/setup"
for tool in bash sh sed awk cat cp find mkdir rm touch tar tr flock dirname env printf grep; do
  ln -s "$(command -v "$tool")" "$work/bin/$tool"
done
stand_in() { rm -f "$work/bin/$1"; printf '#!/bin/sh\n%s\n' "$2" >"$work/bin/$1"; chmod +x "$work/bin/$1"; }
stand_in id 'echo 1000'
stand_in unshare 'test "$2" != true || exit 0
shift 6; echo "there: $*"; case "$*" in *bootstrap*demo*) exit "$(cat "'"$work"'/demo_ends_with")" ;; esac'
stand_in git 'exit 1'
stand_in apt-get 'echo "$(. /etc/os-release; echo $VERSION_CODENAME) http://mirror.example/debian"; echo "other http://elsewhere.example"'
stand_in apt-config 'case "$1" in shell) echo "proxy='"'http://proxy.example:3128'"'" ;; dump) echo "Acquire::http::Proxy \"http://proxy.example:3128\";" ;; esac'
echo 0 >"$work/demo_ends_with"

# check NAME CODE WORDS ARGUMENT...: the script ends with CODE and prints WORDS (an extended regular expression).
check() {
  local name=$1 code=$2 words=$3 got=0 text
  shift 3
  text=$(PATH="$work/bin" RAYCLOCK_CHROOTS="$work/roots" "$tree/tests/setup/release" "$@" 2>&1) || got=$?
  if [ "$got" -ne "$code" ] || ! grep -Eq -- "$words" <<<"$text"; then
    printf '%s: exit code %s instead of %s, or not "%s" in:\n%s\n' "$name" "$got" "$code" "$words" "$text" >&2
    exit 1
  fi
}

check "no release" 2 '^  tests/setup/release trixie all '
check "no such release" 2 '^  tests/setup/release trixie ' sid
check "nobody but root" 0 'not tested here: a chroot needs root$' trixie
stand_in id 'echo 0'
check "no debootstrap" 0 'not tested here: debootstrap is not installed' trixie
stand_in debootstrap 'echo "E: no network"; exit 1'
check "no network" 0 'cannot make it from http://mirror.example/debian \(no network\?\)' trixie
! test -e "$work/roots/trixie" || { echo "half a chroot is left" >&2; exit 1; }
stand_in debootstrap 'while [ $# -gt 2 ]; do shift; done
mkdir -p "$1/etc/apt/apt.conf.d"; echo "$http_proxy" >"$1/proxy"'
check "good" 0 'are good$' trixie
grep -q '^http://proxy.example:3128$' "$work/roots/trixie/proxy"
grep -q 'Acquire::http::Proxy "http://proxy.example:3128";' "$work/roots/trixie/etc/apt/apt.conf.d/90network"
test -x "$work/roots/trixie/src/bootstrap"
stand_in debootstrap 'echo "must not be called again"; exit 1'
check "kept" 0 'are good$' trixie
check "all" 0 '^there: .*bootstrap test$' trixie all
echo 1 >"$work/demo_ends_with"
check "a demo that fails" 1 'bootstrap demo' trixie
echo "release says and does what it should"
