# Sourced by the scripts beside it: the steps that they share. The caller sets -euo pipefail.

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
script=scripts/$(basename "$0")
current_step="start"

step() {
    current_step=$1
    printf '==> %s\n' "$1"
}

note() { printf '    %s\n' "$1"; }

# Ends the script with a message and, by default, exit code 1.
fail() {
    trap - EXIT
    printf '%s: error: %s\n' "$script" "$1" >&2
    exit "${2:-1}"
}

name_the_failed_step() {
    local status=$?
    if ((status != 0)); then
        printf '%s: error: failed with exit code %d at the step "%s"\n' "$script" "$status" "$current_step" >&2
    fi
}
trap name_the_failed_step EXIT

# Shows a command and runs it.
run() {
    printf '    $'
    printf ' %q' "$@"
    printf '\n'
    "$@"
}

# The names in scripts/packages.txt, one a line.
listed_packages() { sed -e 's/#.*//' -e 's/[[:space:]]//g' -e '/^$/d' "$repository/scripts/packages.txt"; }

# Those of them that are not installed.
missing_packages() {
    local installed
    installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' | sed -n 's/^installed //p')
    listed_packages | grep -vxF -e "$installed" || true
}

install_packages() {
    step "Look for the packages of scripts/packages.txt"
    if ! command -v dpkg-query >/dev/null; then
        note "there is no dpkg-query, so this is no Debian: taking it that they are here under other names"
        return
    fi
    local missing
    mapfile -t missing < <(missing_packages)
    if ((${#missing[@]} == 0)); then
        note "nothing is missing"
        return
    fi

    step "Install ${missing[*]}"
    local as_root=()
    if ((EUID != 0)); then
        command -v sudo >/dev/null ||
            fail "installing packages needs root or sudo; let root run: apt-get install ${missing[*]}"
        as_root=(sudo)
    fi
    run "${as_root[@]}" apt-get update -q
    run "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get install -y -q --no-install-recommends "${missing[@]}"
}

# configure PRESET: into build/PRESET. Changes of the CMake files are ninja's business; it does not see the presets.
configure() {
    local build=$repository/build/$1
    step "Configure build/$1"
    if [[ -f $build/build.ninja && ! $repository/CMakePresets.json -nt $build/build.ninja ]]; then
        note "already configured"
        return
    fi
    run cmake -S "$repository" --preset "$1"
}

# build PRESET [TARGET...]: everything, or the targets given.
build() {
    local preset=$1
    shift
    step "Build $preset"
    run cmake --build "$repository/build/$preset" ${1+--target "$@"}
}
