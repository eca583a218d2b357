#!/usr/bin/env bash
# sbatch slurm-array.sh FOLDER CERTIFICATE
#
# Checks a certificate in parts, one for each task of an array of Slurm, for example
#   sbatch --array=1-8 slurm-array.sh receipts poincare.json.zst
#   sbatch --dependency=afterok:JOB --wrap 'delcert-check --merge receipts/*-of-8.json poincare.json.zst'
# A task that is killed is queued again, at most 100 times, and does its part again.
#SBATCH --job-name=check
#SBATCH --array=1-8
#SBATCH --cpus-per-task=1
#SBATCH --time=08:00:00
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --output=check-%A-%a.txt
set -uo pipefail
folder=$1 certificate=$2
mkdir -p "$folder"
delcert-check "$certificate" --threads "${SLURM_CPUS_PER_TASK:-1}" --part "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" \
  --receipt "$folder/$SLURM_ARRAY_TASK_ID-of-$SLURM_ARRAY_TASK_COUNT.json"
status=$?
# Ended by a signal.
if ((status > 128)) && ((${SLURM_RESTART_COUNT:-0} < 100)); then
  scontrol requeue "${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID"
fi
exit $status
