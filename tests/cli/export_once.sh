#!/bin/sh
# export_once.sh FILE COMMAND…: runs the command, which is to write FILE, with --output FILE. Ends with its status; with 99
# if it failed and left something of the file behind, or did not and left nothing.
file=$1
shift
rm -f "$file"
"$@" --output "$file"
status=$?
if [ $status -eq 0 ]; then
  test -s "$file" || exit 99
else
  for left in "$file"* ".$file"*; do
    test ! -e "$left" || exit 99
  done
fi
exit $status
