#!/bin/bash
# Plants one breach of the rules at a time in a copy of the sources; check_includes.sh must find each.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

failures=0
copy=$scratch/copy
fresh_copy() {
    rm -rf "$copy"
    mkdir -p "$copy/docs"
    cp -r "$root"/{src,tests,bench,CMakeLists.txt} "$copy"
    cp "$root/docs/architecture.md" "$copy/docs"
}

# expect_found TITLE MESSAGE: the check must fail on the copy, saying MESSAGE.
expect_found() {
    local title=$1 message=$2 output
    if output=$("$root/tests/repository/check_includes.sh" "$copy" 2>&1); then
        printf 'FAILED  %s: not found\n' "$title"
        failures=$((failures + 1))
    elif [[ $output != *"$message"* ]]; then
        printf 'FAILED  %s: expected "%s", got:\n%s\n' "$title" "$message" "$output"
        failures=$((failures + 1))
    else
        printf 'ok      %s\n' "$title"
    fi
}

# plant FILE LINE MESSAGE: a file with that line must be found.
plant() {
    fresh_copy
    mkdir -p "$copy/$(dirname "$1")"
    printf '%s\n' "$2" >>"$copy/$1"
    expect_found "$1: $2" "$3"
}

fresh_copy
"$root/tests/repository/check_includes.sh" "$copy" >"$scratch/log" 2>&1 ||
    { echo "FAILED  the unharmed copy:"; cat "$scratch/log"; exit 1; }

plant src/core/planted.h '#include "spectrum/spectrum.h"' 'src/core/planted.h:1: "spectrum/spectrum.h": core may include:'
plant src/film/planted.cpp '#include "tonemap/tone_mapper.h"' 'film may include: core spectrum'
plant src/tonemap/planted.cpp '#  include "spectrum/spectrum.h"' 'tonemap may include: core'
plant src/display/planted.cpp '  #include "film/filter.h"' 'display may include: core spectrum'
plant src/pathtracer/planted.h '#include"develop/pipeline.h"' 'pathtracer may include: core spectrum film'
plant src/develop/planted.cpp '#include "pathtracer/scene.h"' 'develop may include:'
plant tests/tonemap/planted_test.cpp '#include "film/film.h"' 'tonemap may include: core'
plant tests/stability/planted_test.cpp '#include "capi/emulsion.h"' 'stability may include: core'
plant bench/core/planted.cpp '#include "spectrum/spectrum.h"' 'core may include:'
plant src/film/planted.cpp '#include "support/temporary_folder.h"' 'film may include: core spectrum'
plant bench/support/planted.h '#include "film/film.h"' 'core may include:'
plant tests/support/planted.h '#include "film/film.h"' 'core may include:'
plant src/film/planted.cpp '#include "filter.h"' 'expected a path from src'
plant src/film/planted.cpp '#include "../tonemap/tone_mapper.h"' 'expected a path from src'
plant src/film/planted.cpp '#include "film/no_such_header.h"' 'no such header in src'
plant src/film/planted.cpp '#include HEADER' "this check can't read"
plant src/film/planted.cpp '#include <embree3/rtcore.h>' 'only pathtracer uses this library'
plant src/pathtracer/planted.cpp '#include <embree4/rtcore.h>' '2 files include Embree'
plant src/pathtracer/planted.cpp '#include <OpenEXR/ImfRgbaFile.h>' 'only film uses this library'
plant src/cli/planted.cpp '#include <ImfInputFile.h>' 'only film uses this library'
plant src/film/planted.cpp '#include <png.h>' 'only display uses this library'
plant src/film/planted.cpp '#include <zlib.h>' 'only display pathtracer uses this library'
plant src/gadgets/planted.cpp 'int planted;' "src/gadgets/: a folder that the table"
plant tests/gadgets/planted.cpp '#include "core/image.h"' 'gadgets is no folder of src'
plant CMakeLists.txt 'emulsion_room(core LINKS emulsion::film)' 'core links emulsion::film'

fresh_copy
sed -i 's/^emulsion_room(film LINKS .*/emulsion_room(film LINKS emulsion::core)/' "$copy/CMakeLists.txt"
expect_found "a link that is missing" 'film does not link emulsion::spectrum'
fresh_copy
sed -i '/may include/d' "$copy/docs/architecture.md"
expect_found "a table that is gone" 'no table of folders found'

((failures == 0)) || { printf 'error: %d breaches not found\n' "$failures" >&2; exit 1; }
