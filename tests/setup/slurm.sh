#!/usr/bin/env bash
# slurm.sh COMMAND...: a cluster of this one machine, in the folder where it is started, for as long as the command
# runs. Needs Debian's munge, slurmctld, slurmd and slurm-client, and no systemd. Its ports are not the usual ones.
set -eu
PATH=$PATH:/usr/sbin
here=$PWD
host=$(hostname -s)
port=$((20000 + $$ % 10000 * 2))
mkdir state spool
head -c 1024 /dev/urandom >munge.key
chmod 400 munge.key
cat >slurm.conf <<END
ClusterName=one
SlurmctldHost=$host(127.0.0.1)
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthInfo=socket=$here/munge.socket
StateSaveLocation=$here/state
SlurmdSpoolDir=$here/spool
SlurmctldPidFile=$here/slurmctld.pid
SlurmdPidFile=$here/slurmd.pid
SlurmctldPort=$port
SlurmdPort=$((port + 1))
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
MpiDefault=none
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc)
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
END
export SLURM_CONF=$here/slurm.conf

daemons=()
trap 'kill "${daemons[@]}" 2>/dev/null; wait' EXIT
give_up() {
  echo "slurm.sh: $1" >&2
  tail -n 40 daemons.log >&2
  exit 1
}
# await COMMAND...: until it succeeds, for a minute.
await() {
  local end=$((SECONDS + 60))
  until "$@"; do
    [ "$SECONDS" -lt "$end" ] || give_up "waited too long for: $*"
    sleep 0.1
  done
}
is_idle() { timeout 5 sinfo -h -o %T 2>/dev/null | grep -q idle; }
# Starts a daemon that stays in the foreground, and keeps its id.
start() {
  "$@" >>daemons.log 2>&1 &
  daemons+=($!)
}
# The folder may be its owner's alone, which munged accepts by force only.
start munged --foreground --force --key-file="$here/munge.key" --socket="$here/munge.socket" --pid-file="$here/munged.pid" \
  --seed-file="$here/munge.seed"
await test -S munge.socket
start slurmctld -D
start slurmd -D
await is_idle
timeout 300 "$@" || give_up "the command failed: $*"
