# shellcheck shell=bash disable=SC2154  # `install` is set by the script that sources this
# Shared by Allrun and Alltest: installs what is missing, then configures and builds. Sourced, from the checkout's root.
# Expects `install` (yes or no) to be set.

# Debian's gcc, Python and CMake, not others that may come first on the caller's PATH.
packagesOf() { awk -v groups="$1" '$1 !~ /^#/ && index(groups, $1) { print $2 }' cmake/packages.txt; }

missingPackages() {
  local package
  for package in $(packagesOf "$1"); do
    dpkg-query -W -f '${Status}\n' "$package" 2>/dev/null | grep -q '^install ok installed$' || echo "$package"
  done
}

# installMissing GROUPS: leaves with status 1 when packages are missing and may not or cannot be installed.
installMissing() {
  if ! command -v dpkg-query >/dev/null; then
    echo "This is not a Debian system: install by hand what cmake/packages.txt lists. Going on." >&2
    return
  fi
  local missing
  missing=$(missingPackages "$1" | tr '\n' ' ')
  [ -n "$missing" ] || return 0
  if [ "$install" = no ]; then
    echo "Missing Debian packages (install them, or leave out --no-install):" >&2
    echo "  apt-get install --no-install-recommends $missing" >&2
    exit 1
  fi
  local asRoot=""
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      echo "Missing Debian packages, and neither root nor sudo to install them. As root:" >&2
      echo "  apt-get install --no-install-recommends $missing" >&2
      exit 1
    fi
    asRoot="sudo"
  fi
  echo "Installing Debian packages: $missing"
  mkdir -p build
  local log=build/log.apt
  # shellcheck disable=SC2086  # word splitting of the package list and of an empty asRoot is meant
  if ! { $asRoot env DEBIAN_FRONTEND=noninteractive apt-get update &&
         $asRoot env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $missing; } >"$log" 2>&1; then
    tail -n 5 "$log" >&2
    echo "apt could not install these packages; see $log" >&2
    exit 1
  fi
}

# build PRESET [TARGET...]: configures when needed and builds; the log is shown only when it fails.
build() {
  local preset=$1
  shift
  mkdir -p build
  local log=build/log.$preset
  echo "Building ($preset; log: $log)"
  if ! { cmake --preset "$preset" && cmake --build --preset "$preset" ${1:+--target "$@"}; } >"$log" 2>&1; then
    grep -E -A3 'error|Error|FAILED' "$log" | head -n 40 >&2
    echo "The build failed; see $log" >&2
    exit 1
  fi
}
