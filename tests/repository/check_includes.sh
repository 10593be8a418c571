#!/bin/bash
# Fails when an #include or a link breaks the table of docs/architecture.md: check_includes.sh [REPOSITORY]
set -euo pipefail
cd "${1:-$(dirname "${BASH_SOURCE[0]}")/../..}"

broken=0
complain() {
    printf '%s\n' "$1" >&2
    broken=$((broken + 1))
}

# --- The table: room -> the rooms that it may include, between blanks.
declare -A allowed=()
while IFS='|' read -r _ room _ may _; do
    room=${room//[ \`]/}
    read -ra rooms <<<"${may//[,-]/ }"
    allowed[${room#*/}]=" ${rooms[*]} "
done < <(sed -n '/| may include |/,/^$/p' docs/architecture.md | grep -E '^\| `(src|tests)/')
((${#allowed[@]} > 0)) || complain "docs/architecture.md: no table of folders found"

# The rooms that may include each library's headers. Tests may, too.
declare -A users=(
    ['^(OpenEXR/|Imf|Iex|IlmThread|openexr)']=film
    ['^(libpng[0-9]*/)?png(conf|libconf)?\.h$']=display
    ['^lcms2']=display
    ['^embree']=pathtracer
    ['^stb/']=pathtracer
    ['^zlib\.h$']='display pathtracer'
    ['^hwy/']='core tonemap display'
)

# --- Folders
for folder in src/*/; do
    room=$(basename "$folder")
    [[ -n ${allowed[$room]-} ]] || complain "$folder: a folder that the table of docs/architecture.md does not have"
done

# --- Includes
check_own() {
    local file=$1 where=$2 room=$3 header=$4 from=${4%%/*}
    if [[ $header != */* && $file != src/* && -f ${file%/*}/$header ]]; then
        return  # what the tests of one folder share lies beside them
    elif [[ $from == support && $file != src/* && -f ${file%%/*}/$header ]]; then
        return  # and what the tests or benchmarks of several folders share in their support folder
    elif [[ $header != */* || $header == ./* || $header == ../* ]]; then
        complain "$where: \"$header\": expected a path from src, such as \"core/image.h\""
    elif [[ $from != "$room" && ${allowed[$room]} != *" $from "* ]]; then
        complain "$where: \"$header\": $room may include:${allowed[$room]}"
    elif [[ ! -f src/$header ]]; then
        complain "$where: \"$header\": no such header in src"
    fi
}
check_library() {
    local where=$1 room=$2 header=$3 pattern
    for pattern in "${!users[@]}"; do
        if [[ $header =~ $pattern && " ${users[$pattern]} " != *" $room "* ]]; then
            complain "$where: <$header>: only ${users[$pattern]} uses this library"
        fi
    done
}
while IFS=: read -r file line text; do
    IFS=/ read -r _ room _ <<<"$file"
    [[ $file != @(tests|bench)/support/* ]] || room=core  # they may use what all may
    if [[ -z ${allowed[$room]-} ]]; then
        [[ $file == src/* ]] || complain "$file:$line: $room is no folder of src"
    elif [[ $text =~ include[[:space:]]*\"([^\"]*)\" ]]; then
        check_own "$file" "$file:$line" "$room" "${BASH_REMATCH[1]}"
    elif [[ $text =~ include[[:space:]]*\<([^\>]*)\> ]]; then
        [[ $file == tests/* ]] || check_library "$file:$line" "$room" "${BASH_REMATCH[1]}"
    else
        complain "$file:$line: an include that this check can't read: $text"
    fi
done < <(grep -rnE --include='*.h' --include='*.cpp' --include='*.c' '^[[:space:]]*#[[:space:]]*include' src tests bench || true)

embree_users=$({ grep -rlE '#[[:space:]]*include[[:space:]]*<embree' src || true; } | wc -l)
((embree_users <= 1)) || complain "src: $embree_users files include Embree, expected one"

# --- Links
while read -r room links; do
    for link in $(grep -oE 'emulsion::[a-z]+' <<<"$links" | sed 's/emulsion:://'); do
        [[ " ${allowed[$room]-} " == *" $link "* ]] ||
            complain "CMakeLists.txt: $room links emulsion::$link, may use:${allowed[$room]-}"
    done
    for link in ${allowed[$room]-}; do
        grep -qE "emulsion::$link( |\)|$)" <<<"$links" ||
            complain "CMakeLists.txt: $room does not link emulsion::$link, which docs/architecture.md lets it use"
    done
done < <(sed -nE 's/^ *emulsion_room\(([a-z]+) (.*)$/\1 \2/p' <(sed -e ':a' -e '/emulsion_room([^)]*$/{N;s/\n */ /;ba' -e '}' CMakeLists.txt))

((broken == 0)) || { printf 'error: %d broken rules\n' "$broken" >&2; exit 1; }
printf 'no broken rules\n'
