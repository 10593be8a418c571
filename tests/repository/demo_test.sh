#!/bin/bash
# Runs scripts/demo as a newcomer does, from some other folder: demo_test.sh BUILD_FOLDER
# Exit code 77: this is not the release build, and the demo would have to make that first.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=$(cd "$1" && pwd -P)
if [[ $build != "$(realpath -m "$root/build/release")" ]]; then
    echo "skipped: scripts/demo builds build/release, which is not the build under test"
    exit 77
fi

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() {
    printf 'error: %s; scripts/demo printed:\n' "$1" >&2
    cat "$scratch/log" >&2
    exit 1
}

program=$build/bin/emulsion
ninja -C "$build" emulsion >"$scratch/log" || fail "the program can't be built"
built=$(stat -c %Y.%Z "$program")
cd "$scratch"

# expect_pictures NAME: the demo has left both files of this name, and said where.
expect_pictures() {
    local output outputs=("$root/out/$1.exr" "$root/out/$1.png")
    for output in "${outputs[@]}"; do
        [[ -s $output ]] || fail "$output is missing or empty"
        grep -qF "$output" "$scratch/log" || fail "it did not say where $output is"
    done
    [[ $(head -c 4 "${outputs[0]}" | od -An -tx1) == " 76 2f 31 01" ]] || fail "${outputs[0]} is no OpenEXR file"
    [[ $(head -c 8 "${outputs[1]}" | od -An -tx1) == " 89 50 4e 47 0d 0a 1a 0a" ]] || fail "${outputs[1]} is no PNG file"
}

rm -f "$root"/out/{cornell-box,metamers}.{exr,png}
"$root/scripts/demo" metamers >"$scratch/log" 2>&1 || fail "scripts/demo metamers failed with exit code $?"
expect_pictures metamers
"$root/scripts/demo" >"$scratch/log" 2>&1 || fail "scripts/demo failed with exit code $?"
expect_pictures cornell-box
(($(ls -A "$root/out" | grep -c '\.tmp$') == 0)) || fail "a temporary file was left in $root/out"

grep -qF 'no work to do' "$scratch/log" || fail "it built something, though nothing had changed"
[[ $(stat -c %Y.%Z "$program") == "$built" ]] || fail "it built the program anew, though nothing had changed"
grep -q '^==> ' "$scratch/log" || fail "it did not say what it was doing"

for wrong in --no-such-flag no-such-scene ../scenes/prism; do
    if "$root/scripts/demo" $wrong >"$scratch/log" 2>&1; then fail "it took an argument that it does not know: $wrong"; fi
    grep -qF 'scripts/demo: error:' "$scratch/log" || fail "its error does not name it"
    grep -qF ' metamers ' "$scratch/log" || fail "its error does not name the scenes that there are"
done
