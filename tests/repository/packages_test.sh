#!/bin/bash
# Every Debian package that a build includes, links or runs is in scripts/packages.txt, or comes with one that is:
# packages_test.sh BUILD_FOLDER. Exit code 77: can't be told on this machine.
set -euo pipefail
build=$1
source "$(dirname "${BASH_SOURCE[0]}")/../../scripts/lib.sh"
trap - EXIT

command -v dpkg-query >/dev/null || { echo "skipped: no dpkg here"; exit 77; }
[[ -f $build/.ninja_deps ]] || { echo "skipped: $build was not built with ninja"; exit 77; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# --- What the build uses: headers, shared libraries, programs
ninja -C "$build" -t deps | sed -n 's|^ *\(/usr/.*\)$|\1|p' | sort -u >"$scratch/headers"
find "$build/bin" -maxdepth 1 -type f -executable -exec ldd {} + |
    sed -nE 's/.*=> (\/[^ ]*) .*/\1/p' | sort -u >"$scratch/libraries"
for program in cmake ninja c++ clang-format clang-tidy; do command -v "$program"; done >"$scratch/programs"
for kind in headers libraries programs; do
    [[ -s $scratch/$kind ]] || fail "the build in $build uses no $kind: has it been built?"
done

# Merged /usr: dpkg knows a file by the path in its package, which may lack the /usr or have it.
owners() {
    xargs -r realpath <"$1" | sed -E 's|^/usr(/.*)$|/usr\1\n\1|' |
        xargs -r dpkg-query -S 2>/dev/null | sed -E 's/^([^:,]+).*: .*/\1/' | sort -u || true
}
for kind in headers libraries programs; do owners "$scratch/$kind"; done | sort -u >"$scratch/used"

# --- What the list brings: its packages, and all that they depend on
listed_packages >"$scratch/listed"
dpkg-query -W -f '${Package}\t${Pre-Depends},${Depends}\n' >"$scratch/depends"
awk -F '\t' '
    NR == FNR { queue[++last] = $1; seen[$1] = 1; next }
    { depends[$1] = $2 }
    END {
        for (first = 1; first <= last; ++first) {
            count = split(depends[queue[first]], name, /[,|]/)
            for (i = 1; i <= count; ++i) {
                sub(/^ */, "", name[i]); sub(/[ :(].*/, "", name[i])
                if (name[i] in depends && !(name[i] in seen)) { queue[++last] = name[i]; seen[name[i]] = 1 }
            }
        }
        for (package in seen) print package
    }' "$scratch/listed" "$scratch/depends" | sort >"$scratch/brought"

printf '%d headers, %d libraries and %d programs of %d packages\n' "$(wc -l <"$scratch/headers")" \
    "$(wc -l <"$scratch/libraries")" "$(wc -l <"$scratch/programs")" "$(wc -l <"$scratch/used")"
missing=$(comm -23 "$scratch/used" "$scratch/brought")
[[ -z $missing ]] || fail "used, but not brought by scripts/packages.txt:"$'\n'"$missing"

# --- Each library's development package by name: a package that only happens to bring it may cease to
grep -rhoE --include='*.cmake' --include=CMakeLists.txt 'find_package\([A-Za-z0-9]+' "$repository"/{CMakeLists.txt,cmake,tests,bench} |
    sed 's/find_package(//' | sort -u >"$scratch/found"
declare -A package_of=([Imath]=libimath-dev [OpenEXR]=libopenexr-dev [TBB]=libtbb-dev [PNG]=libpng-dev [fmt]=libfmt-dev [Highway]=libhwy-dev
    [Lcms2]=liblcms2-dev [CLI11]=libcli11-dev [embree]=libembree-dev [Eigen3]=libeigen3-dev [GTest]=libgtest-dev [benchmark]=libbenchmark-dev
    [ZLIB]=zlib1g-dev)
while read -r library; do
    package=${package_of[$library]-}
    [[ -n $package ]] || fail "find_package($library): this test does not know its Debian package"
    grep -qxF "$package" "$scratch/listed" || fail "find_package($library): $package is not in scripts/packages.txt"
done <"$scratch/found"
