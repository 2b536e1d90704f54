#!/usr/bin/env bash
# clang-tidy with the checks of .clang-tidy:
#   tests/tidy.sh [-s SECONDS] [FILE...]    these sources; `all`: every source of the program
# Without files: of the folders that pass whole, what is changed and not committed, then what the last 40 commits changed, newest first.
# A header stands for the source of its name. After SECONDS (120) no further source is begun; how many were left out is said. Ends with 1 if anything was found.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
commits=40 seconds=120
passing='app|worlds/scene'  # a folder is added once `tests/tidy.sh FOLDER/*.cpp` finds nothing in it
if [ "${1:-}" = -s ]; then seconds=$2; shift 2; fi

# Each source by itself, and without g++'s precompiled headers, which clang cannot read: what they hold is included instead.
mkdir -p build/tidy
cmake --preset apart >build/tidy/configured.log || { cat build/tidy/configured.log; exit 1; }
sed -E -e "s# -Winvalid-pch -include [^ ]*/handrail_test_support.dir/cmake_pch.hxx# -include $PWD/tests/support/precompiled.h#" \
    -e "s# -Winvalid-pch -include [^ ]*/cmake_pch.hxx# -include $PWD/worlds/base/precompiled.h#" -e 's/ -fpch-preprocess//' \
    build/apart/compile_commands.json >build/tidy/compile_commands.json

if [ $# -eq 0 ]; then
    mapfile -t files < <({ git diff --name-only HEAD; git ls-files --others --exclude-standard; 
        git rev-list -n $commits HEAD | git diff-tree --stdin --no-commit-id --name-only -r --root; } |
        sed -nE "s#^(($passing)/.*)\.(cpp|h)\$#\1.cpp#p" | awk '!seen[$0]++')
elif [ "$1" = all ]; then
    mapfile -t files < <(find app audio-cues haptic settings worlds -name '*.cpp' | sort)
    seconds=100000
else
    files=("$@")
    seconds=100000
fi

results=$(mktemp -d)
trap 'rm -rf "$results"' EXIT
export results seconds
begun=$(date +%s)
export begun
look_at() {
    [ -e "$1" ] && grep -qF "/$1\"" build/tidy/compile_commands.json || return 0  # gone, or not built here
    [ $(($(date +%s) - begun)) -lt "$seconds" ] || { echo "$1" >>"$results/left"; return 0; }
    echo "$1" >>"$results/looked"
    clang-tidy --quiet -p build/tidy "$1" >>"$results/found.$$" 2>>"$results/errors.$$" || { cat "$results/found.$$" "$results/errors.$$"; echo "$1" >>"$results/bad"; }
    rm -f "$results/found.$$" "$results/errors.$$"
}
export -f look_at
printf '%s\0' ${files[@]+"${files[@]}"} | xargs -0 -r -n 1 -P "$(nproc)" bash -c 'look_at "$1"' _
count() { [ -e "$results/$1" ] && wc -l <"$results/$1" || echo 0; }
echo "clang-tidy looked at $(count looked) sources and found something in $(count bad); $(count left) more were changed and not looked at for want of time."
[ "$(count bad)" -eq 0 ]
