#!/usr/bin/env bash
# Sets what a command prints with pdflatex in an article at 10 pt, whose lines are 345 pt wide, and fails where a box is
# more than 1 pt too wide, or LaTeX finds an error.
# latex_fits.sh NAME COMMAND ARGUMENT…
set -uo pipefail
name=$1
shift
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
{
  printf '%s\n' '\documentclass{article}' '\usepackage{amsmath,amssymb,booktabs,longtable,graphicx,tikz}' '\hfuzz=1pt' '\begin{document}' \
    '\typeout{WIDTH \the\textwidth}' '\noindent'
  "$@"
  status=$?
  # Of attacks, 1 and 2 are results.
  [ "$status" -le 2 ] || { echo "$name: the command ends with $status" >&2; exit 1; }
  printf '%s\n' '\end{document}'
} >"$folder/$name.tex" || exit 1
cd "$folder" || exit 1
# Twice: a longtable learns the widths of its columns from the run before.
for run in 1 2; do
  if ! pdflatex -interaction=nonstopmode -halt-on-error "$name.tex" >"$name.out" 2>&1; then
    grep -A 3 '^!' "$name.log" || tail -n 20 "$name.out"
    exit 1
  fi
done
grep -q '^WIDTH 345.0pt' "$name.log" || { echo "the line is not 345 pt wide"; exit 1; }
if grep -A 2 '^Overfull .hbox' "$name.log"; then exit 1; fi
echo "$name fits: $(grep -o 'Output written.*' "$name.log")"
