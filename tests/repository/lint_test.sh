#!/bin/bash
# Runs scripts/lint over the sources of some folders, after seeing that its settings find planted faults:
# lint_test.sh BUILD_FOLDER [--quick] FOLDER...
# Exit code 77: scripts/lint goes by the release build, and this is another.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# A wrong line in a .clang-tidy would make clang-tidy fall back, with a word to nobody, to its own few checks.
cd "$root"
mapfile -t settings < <(find . -name .clang-tidy -not -path './build/*')
cp --parents "${settings[@]}" .clang-format "$scratch"
cat >"$scratch/planted.cpp" <<'EOF'
#include <string>
#include <utility>

namespace emulsion {

const int lowerCaseConstant = 1;

class badly_named {
  public:
    int value() const { return unsuffixed; }

  private:
    int unsuffixed = lowerCaseConstant;
};

std::string use_after_move(std::string text) {
    std::string moved = std::move(text);
    if (text == "") return moved;
    return text;
}

int dereference(int* pointer) {
    int *misplaced=pointer;
    if (pointer == nullptr) return *misplaced;
    return 0;
}

int one_less(int n) { return n - 1; }

double half(int n) { return n / 2; }

int divide(int n) {
    if (n != 1) return 0;
    return 10 / one_less(n);
}

}  // namespace emulsion
EOF
{
    echo 'int too_long() {'
    for ((line = 0; line < 62; ++line)); do echo "    // line $line"; done
    printf '    return 0;\n}\n'
} >>"$scratch/planted.cpp"

# Sees to it that the checks given find the planted faults in a source of a folder: finds FOLDER CHECK...
finds() {
    local folder=$1 found check name
    shift
    cp "$scratch/planted.cpp" "$scratch/$folder"
    found=$(clang-tidy --quiet "$scratch/$folder/planted.cpp" -- -std=c++20 2>&1) || true
    for check in "$@"; do
        [[ $found == *"[$check,-warnings-as-errors]"* ]] ||
            { printf 'error: %s: no planted fault found by %s:\n%s\n' "$folder" "$check" "$found" >&2; exit 1; }
    done
    for name in lowerCaseConstant badly_named unsuffixed; do
        [[ $found == *"'$name'"* ]] ||
            { printf 'error: %s: clang-tidy takes the name %s\n' "$folder" "$name" >&2; exit 1; }
    done
}
everywhere=(readability-identifier-naming bugprone-integer-division)
but_tests=(readability-function-size bugprone-use-after-move readability-container-size-empty)
mkdir "$scratch/src/core"
for folder in src/core src/cli; do
    finds "$folder" "${everywhere[@]}" "${but_tests[@]}" clang-analyzer-core.NullDereference \
        clang-analyzer-core.DivideZero
done
finds bench "${everywhere[@]}" "${but_tests[@]}"
finds tests "${everywhere[@]}"

if clang-format --dry-run -Werror "$scratch/planted.cpp" 2>"$scratch/log"; then
    echo "error: clang-format did not find a planted fault" >&2
    exit 1
fi
grep -q 'int \*misplaced=pointer' "$scratch/log" || { echo "error: clang-format found something else" >&2; exit 1; }

if [[ $(cd "$1" && pwd -P) != "$(realpath -m "$root/build/release")" ]]; then
    echo "skipped: scripts/lint goes by build/release, which is not the build under test"
    exit 77
fi
shift
quick=()
if [[ $1 == --quick ]]; then
    quick=(--quick)
    shift
fi
mapfile -t sources < <(find "$@" -name '*.cpp' | sort)
"$root/scripts/lint" "${quick[@]}" "${sources[@]}"
