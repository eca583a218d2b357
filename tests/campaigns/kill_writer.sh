# shellcheck shell=bash
# kill_writer LOG LINES PROGRAM: waits until the log has so many lines, then kills the process that its second line names,
# if that is the program. Status 1 if there was none to kill.
kill_writer() {
  local log=$1 lines=$2 program=$3 process
  for ((waited = 0; waited < 6000; waited++)); do
    if [[ -e $log ]] && (($(wc -l <"$log") >= lines)); then break; fi
    sleep 0.02
  done
  process=$(sed -n '2s/.*"process":\([0-9]*\).*/\1/p' "$log")
  [[ -n $process && $(readlink "/proc/$process/exe") == "$program" ]] || return 1
  kill -9 "$process"
}
