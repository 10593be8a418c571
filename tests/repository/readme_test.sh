#!/bin/bash
# What the README says to type is what the tests and CI run, and what it names exists: readme_test.sh PROGRAM
set -euo pipefail
program=$1
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

failures=0
expect() {
    local what=$1
    shift
    "$@" || { printf 'error: %s\n' "$what" >&2; failures=$((failures + 1)); }
}

# The text of all ```sh blocks, with continued lines joined.
commands=$(sed -n '/^```sh$/,/^```$/p' README.md | grep -v '^```' | sed -e ':a' -e '/\\$/{N;s/\\\n *//;ba' -e '}')

# --- The two commands, which are also what tests/repository/demo_test.sh and CI run
for script in scripts/demo scripts/test; do
    expect "README.md has no line '$script' in a \`\`\`sh block" grep -qxE "$script( +#.*)?" <<<"$commands"
    expect "$script is not executable" test -x "$script"
done
expect ".ci/run is not executable" test -x .ci/run
expect ".ci/run does not end by running scripts/test" grep -qE '^exec .*/scripts/test"$' .ci/run
expect "demo_test.sh does not run scripts/demo" grep -qE '^"\$root/scripts/demo" ' tests/repository/demo_test.sh

# --- Every other command: a script of ours, git, cd, or the program with flags that it has
while read -r line; do
    line=${line%%#*}
    read -r name rest <<<"$line"
    case $name in
        "") ;;
        git | cd) ;;
        scripts/*) expect "README.md: there is no $name" test -x "$name" ;;
        emulsion | build/release/bin/emulsion)
            subcommand=${rest%% *}
            [[ $subcommand != color ]] || { rest=${rest#* }; subcommand="color ${rest%% *}"; }
            # shellcheck disable=SC2086  # one word or two
            help=$("$program" $subcommand --help) || { echo "error: emulsion $subcommand --help failed" >&2; exit 1; }
            for flag in $(grep -oE '(^| )--?[a-z][a-z-]*' <<<"$rest"); do
                expect "README.md: emulsion $subcommand has no $flag" grep -qE -- "(^|[ ,])$flag($|[ ,=])" <<<"$help"
            done
            ;;
        *) expect "README.md: this test does not know the command '$name'" false ;;
    esac
done <<<"$commands"

# --- Code: each block of a language is in the file that is compiled, word for word
# blocks_of LANGUAGE: the blocks, with a \x01 behind each.
blocks_of() {
    awk -v start="\`\`\`$1" '$0 == start { inside = 1; next }
        $0 == "```" && inside { inside = 0; printf "\001" }
        inside' README.md
}
for source in cpp:examples/plug-in/main.cpp cmake:examples/plug-in/CMakeLists.txt c:tests/capi/c99_test.c; do
    code=$(<"${source#*:}")$'\n'
    found=0
    while IFS= read -r -d $'\x01' block; do
        expect "README.md: this is not in ${source#*:}:"$'\n'"$block" test "${code/"$block"/}" != "$code"
        found=$((found + 1))
    done < <(blocks_of "${source%%:*}")
    expect "README.md has no block of ${source#*:}" test "$found" -gt 0
done

# --- Flags named in tables: | `--flag ...` | in the section of the subcommand, or both
help=$("$program" --help && "$program" render --help && "$program" develop --help && "$program" compare --help)
for task in $("$program" color --help | sed -n '/^Subcommands:/,$p' | sed -nE 's/^  ([a-z]+) .*/\1/p'); do
    help+=$("$program" color "$task" --help)
done
for flag in $(grep -oE '`--?[a-z][a-z-]*' README.md | tr -d '`' | sort -u); do
    case $flag in --preset | -ffp-contract) continue ;; esac # of scripts/test, of compilers
    expect "README.md: emulsion has no $flag" grep -qE -- "(^|[ ,])$flag($|[ ,=])" <<<"$help"
done

# --- Files and folders that it names
for path in $(grep -oE '`(src|scripts|scenes|data|docs|tests|bench|cmake|examples)/[A-Za-z0-9_./-]*`' README.md | tr -d '`') \
    $(grep -oE '\]\([^)#:]+\)' README.md | tr -d '()]'); do
    expect "README.md: there is no $path" test -e "$path"
done

((failures == 0)) || exit 1
