#!/usr/bin/env bash
# The functions of cmake/setup.sh on machines made of a few fake commands: what is installed, by whom, and what is said.
set -uo pipefail
# shellcheck source=tests/setup/complaints.sh
. "$(dirname "${BASH_SOURCE[0]}")/complaints.sh"

# machine NAME: an empty folder of commands, with those that any machine has.
machine() {
  commands=$work/$1
  mkdir -p "$commands"
  local tool
  for tool in bash env grep sed mkdir tail cat nproc; do ln -s "$(type -P $tool)" "$commands/$tool"; done
}
# command NAME BODY: what the machine does when it is called so.
command_is() {
  printf '#!/usr/bin/env bash\n%s\n' "$2" >"$commands/$1"
  chmod +x "$commands/$1"
}
# on_machine CODE: runs it after setup.sh, on a copy of the package list; leaves $output and $status.
on_machine() {
  mkdir -p "$work/project/cmake"
  cp "$project/cmake/debian-packages.txt" "$project/cmake/setup.sh" "$work/project/cmake/"
  # shellcheck disable=SC2034
  output=$(PATH=$commands bash -c "set -euo pipefail; root=$work/project; . \$root/cmake/setup.sh; $1" run 2>&1 </dev/null)
  status=$?
}
expect() {
  local title=$1
  shift
  if ! eval "$*"; then
    failures=$((failures + 1))
    printf 'FAILED: %s\n  %s\n  status %s, output:\n%s\n' "$title" "$*" "$status" "$output"
  fi
}
says() { [[ $output == *"$1"* ]]; }
everything='for package in "$@"; do case $package in -*) ;; *) echo "$package installed";; esac; done'
all_but_fmt='for package in "$@"; do case $package in -* | libfmt-dev) ;; *) echo "$package installed";; esac; done'

machine complete
command_is apt-get 'echo apt-get was called'
command_is dpkg-query "$everything"
on_machine 'install_packages test'
expect "nothing is said or done where nothing is missing" '[[ $status == 0 && -z $output ]]'

on_machine 'install_packages checker'
expect "a purpose that no package has is a mistake of ours" '[[ $status == 70 ]] && says "purpose checker"'
for purpose in $(sed -n 's/.*install_packages \([a-z]\+\).*/\1/p' "$project/run" "$project/test" "$project"/cmake/*.sh); do
  on_machine "install_packages $purpose"
  expect "the scripts ask for packages of a purpose that there is, here $purpose" '[[ $status == 0 && -z $output ]]'
done

machine unknown
on_machine 'install_packages run'
expect "elsewhere the list is printed and the status is 69" '[[ $status == 69 ]] && says "not Debian or Ubuntu" && says "libfmt-dev" && says "g++" && says "GMP 6.2"'
expect "./run asks for no test packages" '! says libgtest-dev'
on_machine 'install_packages test'
expect "./test asks for both" 'says libgtest-dev && says libfmt-dev'
on_machine 'DELCERT_SKIP_PACKAGES=1; install_packages run'
expect "packages may be left to the user" '[[ $status == 0 && -z $output ]]'

machine checker
command_is apt-get "echo \"\$@\" >>$work/apt-of-checker"
command_is dpkg-query 'exit 1'
command_is id 'echo 0'
command_is apt-cache 'if [[ $2 == libflint-arb-dev ]]; then echo "Package: $2"; fi'
on_machine 'install_packages check'
expect "the checker needs six libraries, and the compiler" '[[ $status == 0 && $(tail -n 1 $work/apt-of-checker | tr " " "\n" | grep -c -- "-dev$") == 6 ]]'
expect "an optional package is installed where there is one" '[[ $(tail -n 1 $work/apt-of-checker) == *" libflint-arb-dev" ]]'
command_is apt-cache 'exit 100'
on_machine 'install_packages check'
expect "and is not asked for where there is none" '[[ $status == 0 && $(tail -n 1 $work/apt-of-checker) != *arb* ]]'
command_is dpkg-query 'for package in "$@"; do case $package in -* | libflint-arb-dev) ;; *) echo "$package installed";; esac; done'
on_machine 'install_packages check'
expect "nor missed" '[[ $status == 0 && -z $output ]]'

machine powerless
command_is apt-get 'echo apt-get was called'
command_is dpkg-query "$all_but_fmt"
command_is id 'echo 1000'
on_machine 'install_packages run'
expect "without root and sudo only what is missing is listed" '[[ $status == 69 ]] && says "libfmt-dev" && ! says libgmp-dev && ! says "apt-get was called"'
command_is sudo '[[ $1 == -n ]] && exit 1; read -rp "password: "; "$@"'
on_machine 'install_packages run'
expect "a sudo that would ask for a password where nobody can answer is none" '[[ $status == 69 ]] && ! says "apt-get was called"'

machine root
command_is apt-get "echo \"\$@\" >>$work/apt"
command_is dpkg-query "$all_but_fmt"
command_is id 'echo 0'
on_machine 'install_packages run'
expect "only what is missing is installed" '[[ $status == 0 ]] && says "Installing 1 packages: libfmt-dev" && [[ $(tail -n 1 $work/apt) == *" install libfmt-dev" ]]'
command_is dpkg-query 'echo "libfmt-dev config-files"; exit 1'
: >"$work/apt"
on_machine 'install_packages run'
expect "a removed package with configuration left counts as missing" '[[ $status == 0 && $(tail -n 1 $work/apt) == *" libfmt-dev"* ]]'
command_is apt-get 'echo "E: Unable to locate package libfmt-dev"; exit 100'
on_machine 'install_packages run'
expect "what apt-get says is shown when it fails" '[[ $status == 69 ]] && says "Unable to locate"'

machine sudoer
command_is apt-get "echo \"\$@\" >>$work/apt-by-sudo"
command_is dpkg-query "$all_but_fmt"
command_is id 'echo 1000'
command_is sudo '[[ $1 == -n ]] && shift; "$@"'
command_is true ''
on_machine 'install_packages run'
expect "sudo is used where there is one" '[[ $status == 0 && $(tail -n 1 $work/apt-by-sudo) == *" install libfmt-dev" ]]'

machine builder
command_is cmake "mkdir -p $work/project/build/release; echo \"\$@\" >>$work/configured; : >$work/project/build/release/build.ninja
printf 'DELCERT_TESTS:BOOL=OFF\n' >$work/project/build/release/CMakeCache.txt"
on_machine 'configure DELCERT_TESTS=OFF; configure DELCERT_TESTS=OFF; configure'
expect "a build that stands is not configured again" '[[ $(grep -c preset $work/configured) == 1 ]]'
on_machine 'configure DELCERT_TESTS=ON'
expect "another setting is" '[[ $(grep -c preset $work/configured) == 2 && $(tail -n 1 $work/configured) == *-DDELCERT_TESTS=ON ]]'
command_is cmake 'echo "CMake Error: no"; exit 1'
on_machine 'configure DELCERT_TESTS=ON'
expect "a failed configuration fails and shows why" '[[ $status == 1 ]] && says "CMake Error: no"'
command_is ninja 'echo "ninja: Entering directory"; echo "[0/1] Re-checking globbed directories..."; echo "ninja: no work to do."'
on_machine 'build delcert'
expect "a build with nothing to do is silent" '[[ $status == 0 && -z $output ]]'
command_is ninja 'echo "[1/2] Building CXX object x.o"; echo "x.cpp:1: error"; exit 1'
on_machine 'build delcert'
expect "a failed build fails and shows why" '[[ $status == 1 ]] && says "x.cpp:1: error"'
on_machine 'set +e +o pipefail; build delcert; exit $?'
expect "also where the shell does not stop at errors" '[[ $status == 1 ]]'

machine chooser
for tool in head tr; do ln -s "$(type -P $tool)" "$commands/$tool"; done
# needs ARGS… : PROGRAMS…
needs() {
  on_machine "programs_for $1"
  local wanted=$2
  expect "./run $1 builds $wanted" '[[ $status == 0 && ${output//$'"'\\n'"'/ } == "$wanted" ]]'
}
printf '{\n  "delcert_witness": 1' >"$work/witness.json"
printf '{"format":"delcert-certificate"}' >"$work/certificate.json"
needs "" "delcert delcert-check"
needs "constants --dim 2" "delcert"
needs "certify --manifold torus-2" "delcert delcert-check"
needs "check a.json" "delcert-check"
needs "check --help" "delcert"
needs "check" "delcert"
needs "attack my.toml" "delcert delcert-claims"
needs "report $work/certificate.json --output x.html" "delcert delcert-publish delcert-check"
needs "report $work/certificate.json $work/witness.json --output x.html" "delcert delcert-publish delcert-check delcert-claims"
needs "export a.json --format off" "delcert delcert-publish delcert-check"
needs "cite" "delcert delcert-publish"
needs "info a.json" "delcert"
needs "info a.json --picture a.svg" "delcert delcert-publish"
needs "--help" "delcert"

printf '# what\ndelcert 300 200\ndelcert-check 50 10\ndelcert-claims 400 100\nall 3000 1000\n' >"$work/costs"
mkdir -p "$work/project/cmake"
cp "$work/costs" "$work/project/cmake/build-costs.tsv"
command_is nproc 'echo 2'
rm -rf "$work/project/build"
on_machine 'say_what_it_takes delcert delcert-check'
expect "minutes and megabytes are said before the first build" '[[ $status == 0 ]] && says "about 3 minutes with 2 compilers at once, 210 MB" && says "350 processor seconds"'
on_machine 'say_what_it_takes all'
expect "and those of everything" 'says "about 25 minutes" && says "1000 MB"'
mkdir -p "$work/project/build/release/apps"
: >"$work/project/build/release/apps/delcert"
on_machine 'say_what_it_takes delcert delcert-claims'
expect "what has been built does not count" 'says "400 processor seconds"'
on_machine 'say_what_it_takes delcert'
expect "and nothing is said where all has been" '[[ $status == 0 && -z $output ]]'
rm -rf "$work/project/build"

on_machine 'keep_log_in $root/build/run.log; logged one true; logged "the other" false || echo "failed as it should"; cat $root/build/run.log'
expect "the log has a line for each stage, and failures stay failures" '[[ $status == 0 ]] && says "  one: 0." && says "s, exit status 0" && says "  the other: 0." && says "s, exit status 1" && says "failed as it should"'
rm -rf "$work/project/build"

# An installed program is used if it was made from these sources, and only then.
command_is delcert 'echo "delcert 1.2.3"'
mkdir -p "$work/share/delcert"
echo 1.2.3 >"$work/project/VERSION"
on_machine installed_program
expect "an installed program of this version is used" '[[ $status == 0 && $output == */chooser/delcert ]]'
on_machine 'DELCERT_BUILD=1; installed_program'
expect "not where a build is asked for" '[[ $status != 0 && -z $output ]]'
mkdir -p "$work/project/build/release"
: >"$work/project/build/release/build.ninja"
on_machine installed_program
expect "not where there is a build" '[[ $status != 0 && -z $output ]]'
rm -rf "$work/project/build"
mkdir "$work/project/.git"
command_is git '[[ $3 == rev-parse ]] && echo c0ffee || exit 0'
on_machine installed_program
expect "in a repository not without its commit" '[[ $status != 0 && -z $output ]]'
echo c0ffee >"$work/share/delcert/commit"
on_machine installed_program
expect "with it it is" '[[ $status == 0 && $output == */chooser/delcert ]]'
command_is git '[[ $3 == rev-parse ]] && echo c0ffee || exit 1'
on_machine installed_program
expect "not where something has been changed" '[[ $status != 0 && -z $output ]]'
command_is git '[[ $3 == rev-parse ]] && echo c0ffed || exit 0'
on_machine installed_program
expect "nor at another commit" '[[ $status != 0 && -z $output ]]'
rm -rf "$work/project/.git"
echo 1.2.4 >"$work/project/VERSION"
on_machine installed_program
expect "nor of another version" '[[ $status != 0 && -z $output ]]'

machine counter
report=$work/report.xml
# report COUNTS: the head of a report as CTest writes it.
report() { printf '<?xml version="1.0"?>\n<testsuite name="(empty)"\n\t%s\n\thostname=""\n>\n\t<testcase name="a" tests="99"/>\n</testsuite>\n' "$1" >"$report"; }
report 'tests="12" failures="2" disabled="1" skipped="3"'
on_machine "ctest_counts $report"
expect "what did not run has not passed" '[[ $output == "6 6" ]]'
report 'tests="12" failures="0" disabled="0" skipped="0"'
on_machine "ctest_counts $report"
expect "all passed" '[[ $output == "12 0" ]]'
report 'tests="0" failures="0" disabled="0" skipped="0"'
on_machine "ctest_counts $report"
expect "no test at all is a failure" '[[ $output == "0 1" ]]'
on_machine "ctest_counts $work/nowhere"
expect "no report is a failure" '[[ $output == "0 1" ]]'
cat >"$report" <<'XML'
<testsuite name="(empty)" tests="3" failures="2" disabled="0" skipped="0">
	<testcase name="right" classname="right" time="1" status="run">
		<system-out>no error here</system-out>
	</testcase>
	<testcase name="wrong" classname="wrong" time="1" status="fail">
		<failure message=""/>
		<system-out>[       OK ] Suite.before (0 ms)
file.cpp:7: Failure
Expected: (1) &lt; (0)
</system-out>
	</testcase>
	<testcase name="killed" classname="killed" time="1" status="fail">
		<system-out>[ RUN      ] Suite.last
</system-out>
	</testcase>
</testsuite>
XML
ln -s "$(type -P awk)" "$commands/awk"
on_machine "ctest_failures $report"
expect "failures are told at the end" \
  '[[ $output == "FAILED: wrong"*"file.cpp:7: Failure"*"Expected: (1) < (0)"*"FAILED: killed"*"Suite.last"* ]]'
expect "and nothing else" '[[ $output != *"Suite.before"* && $output != *"here"* ]]'
on_machine "ctest_failures $work/nowhere"
expect "no report, no failure to be told" '[[ -z $output ]]'

duplicates=$(grep -v '^#' "$project/cmake/debian-packages.txt" | sed 's/^[a-z?]* *\([^ ]*\).*/\1/' | sort | uniq -d)
expect "no package stands twice in the list" '[[ -z $duplicates ]]'
malformed=$(grep -vE '^#|^(check|run|test|package|python|deep)\?? +[a-z0-9.+-]+ +[A-Za-z]' "$project/cmake/debian-packages.txt")
expect "every line of the list has a purpose, a package and a description" '[[ -z $malformed ]]'

finish
