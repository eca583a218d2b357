# shellcheck shell=bash
# What ./run and ./test share: install what is missing, configure, build. What is there already is passed over in
# silence and nothing is done twice. All messages go to standard error, so that ./run ARGS… can be piped.
# Expects $root, the project's folder.

build=${root:?}/build/release

say() { printf '%s\n' "$*" >&2; }

# keep_log_in FILE: from here on `logged` writes there, beginning with this call's command line.
keep_log_in() {
  stages=$1
  mkdir -p "${stages%/*}"
  stage_line "$0${call:+ $call}"
}
call=$*
stages=/dev/null
stage_line() { printf '%(%Y-%m-%d %H:%M:%S)T  %s\n' -1 "$*" >>"$stages"; }

# logged TITLE COMMAND…: runs it, and writes one line of it, with its seconds and its status; its failure is ours.
logged() {
  local title=$1 status=0 start=${EPOCHREALTIME/[.,]/}
  shift
  "$@" || status=$?
  local tenths=$(((${EPOCHREALTIME/[.,]/} - start) / 100000))
  stage_line "$(printf '%s: %d.%d s, exit status %d' "$title" $((tenths / 10)) $((tenths % 10)) "$status")"
  return "$status"
}

# installed_program: the path of an installed delcert that was made from these very sources: of the same version, and where
# these are a Git repository, of the commit that stands here unchanged.
installed_program() {
  local program version commit
  [[ -z ${DELCERT_BUILD:-} && ! -e $build/build.ninja ]] || return 1
  program=$(command -v delcert) || return 1
  version=$("$program" --version 2>/dev/null) || return 1
  [[ $version == "delcert $(<"$root/VERSION")" ]] || return 1
  if [[ -e $root/.git ]]; then
    commit=$(git -C "$root" rev-parse HEAD 2>/dev/null) || return 1
    [[ $commit == "$(cat "${program%/*}/../share/delcert/commit" 2>/dev/null)" ]] || return 1
    git -C "$root" diff --quiet HEAD 2>/dev/null || return 1
  fi
  echo "$program"
}

# programs_for ARGS…: the programs that `delcert ARGS…` consists of, one a line.
programs_for() {
  case ${1-} in
    attack | campaign | claims | errata | formalise | power | prove | tables | tighten) echo delcert; echo delcert-claims ;;
    check) case ${2-} in "" | --help | -h) echo delcert ;; *) echo delcert-check ;; esac ;;
    figure | report) echo delcert; echo delcert-publish; echo delcert-check; shows_witnesses "${@:2}" && echo delcert-claims ;;
    bundle | export) echo delcert; echo delcert-publish; echo delcert-check ;;
    cite) echo delcert; echo delcert-publish ;;
    info) echo delcert; [[ " $* " != *" --picture"* ]] || echo delcert-publish ;;
    constants | homology | manifolds | sample | --help | -h | --version) echo delcert ;;
    *) echo delcert; echo delcert-check ;;
  esac
  return 0
}

# shows_witnesses ARGS…: whether one of them is a file that begins as witnesses do.
shows_witnesses() {
  local file
  for file in "$@"; do
    if [[ -f $file ]] && head -c 64 -- "$file" 2>/dev/null | tr -d ' \t\r\n\0' | grep -qaE '^[{]"(delcert_witness|seed)"'; then return 0; fi
  done
  return 1
}

# say_what_it_takes PROGRAM…|all: minutes and megabytes, before the first build of them; by cmake/build-costs.tsv, which
# bench/builds.py measures: the target, processor seconds, MB in the build folder.
say_what_it_takes() {
  local target seconds megabytes sum=0 size=0 jobs
  [[ -r $root/cmake/build-costs.tsv ]] || return 0
  while read -r target seconds megabytes; do
    [[ $target != "#"* && " $* " == *" $target "* ]] || continue
    case $target in
      delcert-check) [[ ! -e $build/proofs/checker/delcert-check ]] || continue ;;
      all) [[ ! -e $build/tests/checker/test_checker ]] || continue ;;
      *) [[ ! -e $build/apps/$target ]] || continue ;;
    esac
    sum=$((sum + seconds)) size=$((size + megabytes))
  done <"$root/cmake/build-costs.tsv"
  ((sum > 0)) || return 0
  jobs=$(parallel_jobs)
  say "First build: about $(((sum + 60 * jobs - 1) / (60 * jobs))) minutes with $jobs compilers at once, $size MB in build/release." \
    "(Where it was measured: $sum processor seconds.)"
}

# packages_for check | run | test | package | python: the packages needed for it, one a line. What a run needs includes what checking
# needs, and what the tests need includes all. With `optional` those instead that a distribution need not have,
# as what they hold may be in another package: their purpose ends with a question mark.
packages_for() {
  local purposes=$1 wanted_purpose purpose package what mark=""
  if [[ $1 == run || $1 == test ]]; then purposes="check run"; fi
  if [[ $1 == test ]]; then purposes+=" test package python"; fi
  if [[ ${2:-} == optional ]]; then mark="?"; fi
  while read -r purpose package what; do
    for wanted_purpose in $purposes; do
      if [[ $purpose == "$wanted_purpose$mark" ]]; then echo "$package"; fi
    done
  done <"$root/cmake/debian-packages.txt"
}

# are_there PACKAGE…: those of them that are installed. Node.js of another source than Debian's comes with npm, and excludes
# the package of that name.
are_there() {
  if [[ " $* " == *" npm "* ]] && command -v npm >/dev/null; then echo npm; fi
  # The status of dpkg-query only says that some package is unknown, which is what is asked.
  # shellcheck disable=SC2016
  dpkg-query --show --showformat='${Package} ${db:Status-Status}\n' "$@" 2>/dev/null | sed -n 's/ installed$//p' || true
}

# Status 69: something that only the user can provide is missing.
stop_for_packages() {
  local purpose package what
  say "$1"
  shift
  while read -r purpose package what; do
    if [[ " $* " == *" $package "* ]]; then say "$(printf '  %-19s %s' "$package" "$what")"; fi
  done <"$root/cmake/debian-packages.txt"
  say "If they are there by other means: DELCERT_SKIP_PACKAGES=1 ./${0##*/}"
  exit 69
}

# known_packages PACKAGE…: those of them that this distribution has.
known_packages() {
  local package
  for package in "$@"; do
    # Its status is 0 for a name that is only referred to, too.
    if [[ -n $(apt-cache show "$package" 2>/dev/null) ]]; then echo "$package"; fi
  done
}

# install_packages check | run | test | package | python
install_packages() {
  [[ -z ${DELCERT_SKIP_PACKAGES:-} ]] || return 0
  local -a wanted optional missing=() unsure=() as_root=()
  mapfile -t wanted < <(packages_for "$1")
  mapfile -t optional < <(packages_for "$1" optional)
  ((${#wanted[@]} > 0)) || { say "cmake/debian-packages.txt has nothing for the purpose $1"; exit 70; }
  if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    stop_for_packages "This is not Debian or Ubuntu. Needed (under Debian's names):" "${wanted[@]}"
  fi

  local installed package
  installed=$(are_there "${wanted[@]}" "${optional[@]}")
  for package in "${wanted[@]}"; do grep -qxF "$package" <<<"$installed" || missing+=("$package"); done
  for package in "${optional[@]}"; do grep -qxF "$package" <<<"$installed" || unsure+=("$package"); done
  if ((${#missing[@]} == 0)); then
    mapfile -t missing < <(known_packages "${unsure[@]}")
    ((${#missing[@]} > 0)) || return 0
    unsure=()
  fi

  if [[ $(id -u) != 0 ]]; then
    if command -v sudo >/dev/null && { [[ -t 0 ]] || sudo -n true 2>/dev/null; }; then
      as_root=(sudo)
    else
      stop_for_packages "Neither root nor sudo, so these packages cannot be installed from here:" "${missing[@]}"
    fi
  fi

  local log=$root/build/packages.log
  mkdir -p "${log%/*}"
  if ! "${as_root[@]}" apt-get -q update >"$log" 2>&1; then
    tail -n 20 "$log" >&2
    stop_for_packages "apt-get failed (all of it in build/packages.log). Needed:" "${missing[@]}"
  fi
  mapfile -t -O ${#missing[@]} missing < <(known_packages "${unsure[@]}")
  say "Installing ${#missing[@]} packages: ${missing[*]}"
  if ! "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y --no-install-recommends \
      -o DPkg::Lock::Timeout=300 install "${missing[@]}" >>"$log" 2>&1 </dev/null; then
    tail -n 20 "$log" >&2
    stop_for_packages "apt-get failed (all of it in build/packages.log). Needed:" "${missing[@]}"
  fi
}

# One job a core, but no more than memory allows: a file that includes CGAL's triangulations takes 1.3 GB to compile.
parallel_jobs() {
  local cores memory
  cores=$(nproc)
  memory=$(sed -n 's/^MemAvailable: *\([0-9]*\) kB$/\1/p' /proc/meminfo 2>/dev/null)
  local by_memory=$((${memory:-1500000} / 1500000))
  ((by_memory >= 1)) || by_memory=1
  echo $((cores < by_memory ? cores : by_memory))
}

# configure VARIABLE=VALUE…: the preset "release" with these. Nothing happens if that is how the build stands:
# Ninja itself notices changes of CMake's files.
configure() {
  local cache=$build/CMakeCache.txt setting stands=yes
  [[ -e $build/build.ninja && ! $root/CMakePresets.json -nt $build/build.ninja ]] || stands=no
  for setting in "$@"; do
    grep -qE "^${setting%%=*}:[A-Z]+=${setting#*=}\$" "$cache" 2>/dev/null || stands=no
  done
  [[ $stands == no ]] || return 0

  say "Configuring build/release"
  local log=$root/build/configure.log
  mkdir -p "${log%/*}"
  if ! (cd "$root" && cmake --preset release "${@/#/-D}") >"$log" 2>&1; then
    cat "$log" >&2
    return 1
  fi
}

# Ninja's output without the lines that say that nothing is to be done; on a terminal the progress stays on one line.
only_news() {
  local line
  while IFS= read -r line; do
    case $line in
      "ninja: Entering directory"* | "ninja: no work to do."* | *"Re-checking globbed directories"*) ;;
      "["*) if [[ -t 2 ]]; then printf '\r\033[K%.*s' "$((${COLUMNS:-80} - 1))" "$line" >&2; else say "$line"; fi ;;
      *) if [[ -t 2 ]]; then printf '\r\033[K%s\n' "$line" >&2; else say "$line"; fi ;;
    esac
  done
  if [[ -t 2 ]]; then printf '\r\033[K' >&2; fi
}

# build TARGET…; all of them are tried even if one fails, so that one look shows every mistake.
build() {
  ninja -C "$build" -j "$(parallel_jobs)" -k 0 "$@" 2>&1 | only_news
  return "${PIPESTATUS[0]}"
}

# ctest_counts REPORT: how many tests passed and how many did not, by CTest's JUnit report. A test that did not run has
# not passed; a report that is missing or empty is one failure.
ctest_counts() {
  local header total not_passed=0 kind
  header=$(sed -n '/<testsuite/,/>/p' "$1" 2>/dev/null) || true
  for kind in tests failures skipped disabled; do
    [[ $header =~ [[:space:]]$kind=\"([0-9]+)\" ]] || { echo 0 1; return; }
    if [[ $kind == tests ]]; then total=${BASH_REMATCH[1]}; else not_passed=$((not_passed + BASH_REMATCH[1])); fi
  done
  if ((total > 0)); then echo $((total - not_passed)) $not_passed; else echo 0 1; fi
}

# ctest_failures REPORT: of each test that failed what it printed about that, at most 40 lines, or its last ones. CI shows
# the end of what ./test prints, and there a test with much output is far away.
ctest_failures() {
  awk '
    function show(at) {
      if (at > shown && lines < 40 && at <= number) { print "  " text[at]; shown = at; lines++ }
    }
    /<testcase / {
      failing = /status="fail"/
      name = $0; sub(/.* name="/, "", name); sub(/".*/, "", name)
    }
    failing && /<system-out>/ { inside = 1; number = 0; sub(/.*<system-out>/, "") }
    inside {
      ends = sub(/<\/system-out>.*/, "")
      gsub(/&lt;/, "<"); gsub(/&gt;/, ">"); gsub(/&quot;/, "\""); gsub(/&apos;/, "\047"); gsub(/&amp;/, "\\&")
      text[++number] = substr($0, 1, 300)
      if (ends) {
        inside = failing = lines = shown = found = 0
        print "FAILED: " name
        for (at = 1; at <= number; at++)
          if (text[at] ~ /: Failure|FAILED|[Ee]rror|Traceback|Assert|terminate|expected/) {
            found = 1
            for (more = at; more < at + 8; more++) show(more)
          }
        for (at = number - 15; !found && at <= number; at++) if (at > 0) show(at)
      }
    }' "$1" 2>/dev/null || true
}
