# How ./run and ./test install what is missing and build, each failure in one sentence. Sourced by bash; $program names the caller.
# shellcheck shell=bash

log_folder=build/logs
installed_packages=no

say() { printf '%s: %s\n' "${program:?}" "$*" >&2; }
fail() {
  say "$*"
  exit 1
}

# missing_packages NAME...: those that dpkg does not have installed, one a line.
missing_packages() {
  comm -13 <(dpkg-query -W -f='${db:Status-Status} ${Package}\n' | sed -n 's/^installed //p' | sort -u) \
    <(printf '%s\n' "$@" | sort -u)
}

# as_root COMMAND...: for others than root through sudo, which may ask for a password only where a person can answer.
as_root() {
  if [[ $EUID == 0 ]]; then
    "$@"
  elif [[ -t 0 ]]; then
    sudo "$@"
  else
    sudo -n "$@"
  fi
}

apt_get() { as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o Acquire::Retries=3 -o DPkg::Lock::Timeout=300 "$@"; }

# install_missing NAME...: returns at once where nothing is missing, and then needs neither root nor a network.
install_missing() {
  local log=$log_folder/apt.log missing
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    fail "this needs Debian 12 or a system like it: there is no apt-get here to install packages with"
  fi
  mapfile -t missing < <(missing_packages "$@")
  ((${#missing[@]})) || return 0
  if [[ $EUID != 0 ]] && ! command -v sudo >/dev/null; then
    fail "installing packages needs root or sudo, and these are missing: ${missing[*]}"
  fi
  mkdir -p "$log_folder"
  say "installing ${#missing[@]} packages with apt-get (log: $log): ${missing[*]}"
  # A broken third-party list makes `update` fail while Debian's own packages still install, so only `install` decides.
  apt_get update >"$log" 2>&1 || true
  if ! apt_get install --no-install-recommends "${missing[@]}" >>"$log" 2>&1; then
    tail -n 5 "$log" >&2
    fail "apt-get could not install the missing packages; the whole log is $log"
  fi
  installed_packages=yes
}

# build_jobs: a compiler a core, as far as memory allows. tuned: 1.2 GiB a compiler, what g++ 12 takes for a file full of JSON
# templates with sanitizers; more room a job builds slower, less lets the kernel kill compilers.
build_jobs() {
  local cores room
  cores=$(nproc)
  room=$(awk '/^MemAvailable:/ { print int($2 / 1024 / 1200) }' /proc/meminfo)
  ((room >= 1)) || room=1
  echo $((cores < room ? cores : room))
}

# show_progress: of ninja's lines on standard input only the count, on one line, where a person watches.
show_progress() {
  local line
  while IFS= read -r line; do
    [[ -t 2 && $line =~ ^\[([0-9]+)/([0-9]+)\] ]] || continue
    printf '\r%s: building, %s of %s ' "$program" "${BASH_REMATCH[1]}" "${BASH_REMATCH[2]}" >&2
  done
  [[ ! -t 2 ]] || printf '\r\033[K' >&2
}

# show_errors PATTERN LOG: what matters of a log, or its end where nothing looks like it.
show_errors() {
  grep -A 8 -m 5 -E "$1" "$2" >&2 || tail -n 10 "$2" >&2
}

# configure_preset NAME: where that was not done yet. Afterwards ninja sees by itself what changed, but not the presets nor programs
# that were missing when CMake looked for them.
configure_preset() {
  local folder=build/$1 log=$log_folder/$1-configure.log
  if [[ -e $folder/build.ninja && $folder/build.ninja -nt CMakePresets.json && $installed_packages == no ]]; then return; fi
  say "configuring and building $folder; the first time takes some minutes"
  if ! cmake --preset "$1" >"$log" 2>&1; then
    show_errors 'CMake Error' "$log"
    fail "CMake could not configure $folder; the whole log is $log"
  fi
}

# build_preset NAME [TARGET...]
build_preset() {
  local folder=build/$1 log=$log_folder/$1-build.log
  mkdir -p "$log_folder"
  configure_preset "$1"
  shift
  if ! (set -o pipefail && cmake --build "$folder" --parallel "$(build_jobs)" ${1:+--target "$@"} 2>&1 | tee "$log" | show_progress); then
    show_errors 'error:|FAILED:|undefined reference|ninja:' "$log"
    fail "$folder did not build; the whole log is $log"
  fi
}
