# shellcheck shell=bash
# One node of Slurm in a folder of its own: munged, slurmctld and slurmd, started as root and stopped by their process ids.
# start_cluster FOLDER sets what sbatch and the other clients need; stop_cluster ends all.
cluster_processes=()

# free_port: one that nobody listens on.
free_port() { python3 -c 'import socket; s = socket.socket(); s.bind(("", 0)); print(s.getsockname()[1])'; }

# in_background NAME COMMAND…: its streams go to a file.
in_background() {
  local name=$1
  shift
  "$@" >"$cluster/$name.log" 2>&1 &
  cluster_processes+=($!)
}

start_cluster() {
  cluster=$1
  local host
  host=$(hostname -s)
  mkdir -p "$cluster/state" "$cluster/spool"
  # munged refuses folders that others can write to.
  chmod 755 "$cluster"
  head -c 1024 /dev/urandom >"$cluster/munge.key"
  chmod 400 "$cluster/munge.key"
  cat >"$cluster/slurm.conf" <<END
ClusterName=campaign
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmdUser=root
SlurmctldPort=$(free_port)
SlurmdPort=$(free_port)
AuthType=auth/munge
AuthInfo=socket=$cluster/munge.socket
CredType=cred/munge
StateSaveLocation=$cluster/state
SlurmdSpoolDir=$cluster/spool
SlurmctldPidFile=$cluster/slurmctld.pid
SlurmdPidFile=$cluster/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=batch_sched_delay=0,sched_interval=1
MailProg=/bin/true
MpiDefault=none
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=campaign Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
  echo "CgroupPlugin=cgroup/v1" >"$cluster/cgroup.conf"
  export SLURM_CONF=$cluster/slurm.conf
  in_background munged munged --foreground --force --key-file "$cluster/munge.key" --socket "$cluster/munge.socket" \
    --pid-file "$cluster/munged.pid" --seed-file "$cluster/munged.seed" --log-file "$cluster/munged.txt"
  wait_until 30 test -S "$cluster/munge.socket" || return 1
  in_background slurmctld slurmctld -D -c -f "$SLURM_CONF"
  in_background slurmd slurmd -D -f "$SLURM_CONF" -N "$host"
  wait_until 60 node_is_idle
}

node_is_idle() { [[ $(sinfo --noheader --format %t 2>/dev/null) == idle ]]; }

# wait_until SECONDS COMMAND…: false if the command has not succeeded by then.
wait_until() {
  local end=$((SECONDS + $1))
  shift
  until "$@"; do
    ((SECONDS < end)) || return 1
    sleep 0.2
  done
}

stop_cluster() {
  local process
  for process in "${cluster_processes[@]}"; do kill "$process" 2>/dev/null; done
  wait "${cluster_processes[@]}" 2>/dev/null
  cluster_processes=()
}
