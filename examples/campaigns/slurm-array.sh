#!/usr/bin/env bash
# sbatch slurm-array.sh FOLDER CLAIM… [OPTION…]
#
# A campaign in parts, one for each task of an array of Slurm, for example
#   sbatch --array=1-8 slurm-array.sh found --all --samples 10000 --seed 1
#   sbatch --dependency=afterok:JOB --wrap 'delcert campaign merge found/part-*.jsonl --output found/whole.jsonl'
# A task that is killed, or whose time is over before its part is finished, is queued again, at most 100 times, and goes
# on from its log.
#SBATCH --job-name=campaign
#SBATCH --array=1-8
#SBATCH --cpus-per-task=1
#SBATCH --time=08:00:00
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --output=campaign-%A-%a.txt
set -uo pipefail
folder=$1
shift
mkdir -p "$folder"
# Half an hour before Slurm ends the task: no block is begun any more.
delcert attack "$@" --until 450min --threads "${SLURM_CPUS_PER_TASK:-1}" \
  --part "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" --log "$folder/part-$SLURM_ARRAY_TASK_ID.jsonl"
status=$?
# 2: not finished; above 128: ended by a signal.
if ((status == 2 || status > 128)) && ((${SLURM_RESTART_COUNT:-0} < 100)); then
  scontrol requeue "${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID"
fi
exit $status
