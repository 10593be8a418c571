#!/bin/bash
# Megapixels per second of processor time (user and system, all threads) of whole processes on one picture, beside those
# of Debian's pfstools (packages pfstools, pfstmo, openexr), which must be installed:
#
#     whole_process.sh BUILD_FOLDER PICTURE.exr
#
# First operators in a pipe: a PFS stream in, one out, 32-bit floats. Then `emulsion develop` from EXR to PNG, as people
# run it. The best of three runs, and the worst in brackets: others on the machine only add. The two that are
# slow run once.
set -euo pipefail
(($# == 2)) || { sed -n '2,9p' "$0" >&2; exit 2; }
build=$(realpath "$1")
picture=$(realpath "$2")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

pfsinexr "$picture" >"$scratch/in.pfs" 2>/dev/null
read -r width height < <(sed -n 2p "$scratch/in.pfs")
TIMEFORMAT='%U %S'

# row RUNS NAME COMMAND...: a row of the table.
row() {
    local runs=$1 name=$2 times=()
    shift 2
    while ((${#times[@]} < runs)); do
        times+=("$({ time "$@" <"$scratch/in.pfs" >/dev/null 2>&3; } 3>/dev/null 2>&1)")
    done
    printf '%s\n' "${times[@]}" | LC_ALL=C awk -v name="$name" -v pixels="$((width * height))" '
        { cpu = $1 + $2; if (NR == 1 || cpu < least) least = cpu; if (cpu > most) most = cpu }
        END { printf "| `%s` | %.2f (%.2f) | %.3g |\n", name, least, most, 1e-6 * pixels / least }'
}

printf '%d x %d pixels\n\n| process | CPU s | Mpix per CPU s |\n|---|---|---|\n' "$width" "$height"
for operator in max-to-white contrast reinhard-global drago reinhard-local high-contrast durand; do
    row 3 "$operator" "$build/bin/bench_tonemap_pfs_filter" "$operator"
done
for operator in drago03 reinhard02 mantiuk08; do row 3 "pfstmo_$operator" "pfstmo_$operator"; done
row 3 'pfstmo_reinhard02 -s' pfstmo_reinhard02 -s
row 1 'pfstmo_fattal02' pfstmo_fattal02
row 1 'pfstmo_durand02' pfstmo_durand02 -q
for operator in max-to-white contrast reinhard-global drago reinhard-local high-contrast durand; do
    row 3 "emulsion develop --tonemap $operator" \
        "$build/bin/emulsion" develop --quiet --tonemap "$operator" "$picture" -o "$scratch/out.png"
done
