#!/bin/bash
# Installs the build into a folder, and uses what is there as a renderer's author would: both examples by find_package,
# a C program by pkg-config. Nothing of the repository but the examples is looked at: install_test.sh BUILD_FOLDER
# Exit code 77: pkg-config is missing.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=$(cd "$1" && pwd -P)
command -v pkg-config >/dev/null || { echo "skipped: no pkg-config here"; exit 77; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() {
    printf 'error: %s\n' "$1" >&2
    [[ ! -s $scratch/log ]] || cat "$scratch/log" >&2
    exit 1
}
cached() { sed -nE "s/^$1:[A-Z]+=(.*)$/\1/p" "$build/CMakeCache.txt"; }
run() { "$@" >"$scratch/log" 2>&1 || fail "exit code $? of: $*"; }

# --- Install, away from where it was configured for; then move it, as packages do
run cmake --install "$build" --prefix "$scratch/first"
mv "$scratch/first" "$scratch/prefix"
prefix=$scratch/prefix
for gone in pathtracer cli; do
    [[ ! -e $prefix/include/emulsion/$gone ]] || fail "headers of $gone were installed"
    [[ -z $(find "$prefix" -name "libemulsion_$gone*") ]] || fail "the library of $gone was installed"
done
[[ $(cached EMULSION_BUILD_RENDERER) == OFF ]] || run "$prefix/bin/emulsion" --version
if grep -rqF -e "$root" -e "$build" "$prefix"/lib*/cmake "$prefix"/lib*/pkgconfig "$prefix/include"; then
    fail "the package names the folder that it was built in"
fi
if grep -rqiE 'embree|CLI11' "$prefix"/lib*/cmake "$prefix"/lib*/pkgconfig; then
    fail "the package asks for Embree or CLI11"
fi

# What a sanitizer was built into must be linked with it.
sanitize=$(cached EMULSION_SANITIZE)
flags="-Wall -Wextra -Werror${sanitize:+ -fsanitize=$sanitize}"
check_file() {
    local file=$1 magic=$2
    [[ $(head -c 4 "$file" | od -An -tx1) == "$magic" ]] || fail "$file is not what its name says"
}

# --- The examples
for example in plug-in plug-in-rgb; do
    cp -r "$root/examples/$example" "$scratch/$example"
    run cmake -S "$scratch/$example" -B "$scratch/$example/build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
        -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_CXX_COMPILER="$(cached CMAKE_CXX_COMPILER)" -DCMAKE_CXX_FLAGS="$flags"
    grep -qF "emulsion_DIR:PATH=$prefix/" "$scratch/$example/build/CMakeCache.txt" || fail "it found another package"
    run cmake --build "$scratch/$example/build"
    (cd "$scratch" && run "$scratch/$example/build/${example//-/_}" 1)
    grep -qE '^[1-9][0-9]* samples, 0 kept out$' "$scratch/log" || fail "$example did not say what it did"
    check_file "$scratch/$example.exr" " 76 2f 31 01"
    check_file "$scratch/$example.png" " 89 50 4e 47"
done

# --- The C interface, from a program and from a shared object, as plug-ins are
export PKG_CONFIG_PATH
PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name emulsion.pc)")
read -ra compile < <(pkg-config --cflags emulsion)
read -ra link < <(pkg-config --static --libs emulsion)
read -ra checks <<<"$flags"
cp -r "$root/tests/capi" "$scratch/c"
run cc -std=c99 -pedantic "${checks[@]}" "${compile[@]}" "$scratch"/c/c99_*.c -o "$scratch/c99_test" "${link[@]}"
run "$scratch/c99_test" "$scratch/c99.exr"
run cc -std=c99 -shared -fPIC "${checks[@]}" "${compile[@]}" "$scratch"/c/c99_*.c -o "$scratch/c99_test.so" "${link[@]}"
