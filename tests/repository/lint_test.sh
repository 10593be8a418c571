#!/bin/bash
# Runs scripts/lint, after seeing that its settings find planted faults: lint_test.sh BUILD_FOLDER
# Exit code 77: scripts/lint goes by the release build, and this is another.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# A wrong line in .clang-tidy would make clang-tidy fall back, with a word to nobody, to its own few checks.
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

int divide(int* pointer) {
    int *misplaced=pointer;
    if (pointer == nullptr) return *misplaced;
    return 0;
}

}  // namespace emulsion
EOF
{
    echo 'int too_long() {'
    for ((line = 0; line < 62; ++line)); do echo "    // line $line"; done
    printf '    return 0;\n}\n'
} >>"$scratch/planted.cpp"
found=$(clang-tidy --quiet --config-file="$root/.clang-tidy" "$scratch/planted.cpp" -- -std=c++20 2>&1) || true
for check in readability-identifier-naming bugprone-use-after-move readability-container-size-empty \
    readability-function-size clang-analyzer-core.NullDereference; do
    [[ $found == *"[$check,-warnings-as-errors]"* ]] ||
        { printf 'error: clang-tidy did not find a planted fault, %s:\n%s\n' "$check" "$found" >&2; exit 1; }
done
for name in lowerCaseConstant badly_named unsuffixed; do
    [[ $found == *"'$name'"* ]] || { printf 'error: clang-tidy takes the name %s\n' "$name" >&2; exit 1; }
done
cp "$root/.clang-format" "$scratch"
if clang-format --dry-run -Werror "$scratch/planted.cpp" 2>"$scratch/log"; then
    echo "error: clang-format did not find a planted fault" >&2
    exit 1
fi
grep -q 'int \*misplaced=pointer' "$scratch/log" || { echo "error: clang-format found something else" >&2; exit 1; }

if [[ $(cd "$1" && pwd -P) != "$(realpath -m "$root/build/release")" ]]; then
    echo "skipped: scripts/lint goes by build/release, which is not the build under test"
    exit 77
fi
"$root/scripts/lint"
