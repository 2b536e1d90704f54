#!/usr/bin/env bash
# clang-tidy with the checks of .clang-tidy:
#   tests/tidy.sh [-s SECONDS]     of the folders that pass whole, what is changed and not committed, then what the last 40 commits changed, newest first
#   tests/tidy.sh [-s SECONDS] all     all of those folders
#   tests/tidy.sh FILE...              these sources, each by itself
# A header stands for the source of its name. Sources that the build compiles in one go are read in one go, each of them, which takes a sixth of the
# time. After SECONDS (120) nothing further is begun; how many were left out is said. Ends with 1 if anything was found.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
commits=40 seconds=120
passing='app|worlds/scene'  # a folder is added once `tests/tidy.sh FOLDER/*.cpp` finds nothing in it
if [ "${1:-}" = -s ]; then seconds=$2; shift 2; fi
# A folder of its own: configuring that of the tests would take their lists away while they run.
case "${1:-}" in '' | all) preset=release commands=build/tidy/together ;; *) preset=apart commands=build/apart seconds=100000 ;; esac

# Without precompiled headers, g++'s, which clang cannot read, and its own, which nobody makes here: what they hold is included instead. Nor with options that
# only g++ knows.
mkdir -p build/tidy
cmake --preset $preset -B $commands >build/tidy/configured.log || { cat build/tidy/configured.log; exit 1; }
sed -E -e "s# -Winvalid-pch -include [^ ]*/handrail_test_support.dir/cmake_pch.hxx# -include $PWD/tests/support/precompiled.h#" \
    -e "s# -Winvalid-pch -include [^ ]*/cmake_pch.hxx# -include $PWD/worlds/base/precompiled.h#" -e 's/ -fpch-preprocess//' \
    -e 's/ -Xclang -include-pch -Xclang [^ ]*//' -e 's/ -mllvm [^ ]*//' -e 's/ -Wno-subobject-linkage//' -e 's/ --param [^ ]*//g' \
    $commands/compile_commands.json >build/tidy/compile_commands.json

# The sources in FILE, or of a name, that the build compiles: those named, or the file that includes them beside others.
compiled() { while read -r source; do grep -rlF --include='*_*.cpp' "#include \"$source\"" $(find $commands -mindepth 1 -name together) /dev/null || echo "$source"; done | awk '!seen[$0]++'; }
case "${1:-}" in
'')
    mapfile -t files < <({ git diff --name-only HEAD; git ls-files --others --exclude-standard;
        git rev-list -n $commits HEAD | git diff-tree --stdin --no-commit-id --name-only -r --root; } |
        sed -nE "s#^(($passing)/.*)\.(cpp|h)\$#\1.cpp#p" | awk '!seen[$0]++' | while read -r source; do [ ! -e "$source" ] || echo "$source"; done | compiled) ;;
all) mapfile -t files < <(git ls-files | grep -E "^($passing)/.*\.cpp\$" | compiled) ;;
*) files=("$@") ;;
esac

results=$(mktemp -d)
trap 'rm -rf "$results"' EXIT
export results seconds
begun=$(date +%s)
export begun
look_at() {
    [ -e "$1" ] && grep -qF "/$1\"" build/tidy/compile_commands.json || return 0  # gone, or not built here
    [ $(($(date +%s) - begun)) -lt "$seconds" ] || { echo "$1" >>"$results/left"; return 0; }
    echo "$1" >>"$results/looked"
    # Of sources in one go all are read, not what includes them.
    local together=()
    [[ "$1" != */together/* ]] || together=(--checks=-bugprone-suspicious-include --header-filter='/(app|audio-cues|haptic|settings|worlds)/[^.]*\.(h|cpp)$')
    clang-tidy --quiet -p build/tidy ${together[@]+"${together[@]}"} "$1" >"$results/found.$$" 2>"$results/errors.$$" ||
        { cat "$results/found.$$" "$results/errors.$$"; echo "$1" >>"$results/bad"; }
    rm -f "$results/found.$$" "$results/errors.$$"
}
export -f look_at
printf '%s\0' ${files[@]+"${files[@]}"} | xargs -0 -r -n 1 -P "$(nproc)" bash -c 'look_at "$1"' _
# Sources, not files that the compiler is given: what includes twelve counts as twelve.
count() {
    local file total=0
    while read -r file; do
        if [[ "$file" = */together/* ]]; then total=$((total + $(grep -c '#include' "$file"))); else total=$((total + 1)); fi
    done < <(cat "$results/$1" 2>/dev/null)
    echo $total
}
echo "clang-tidy looked at $(count looked) sources; $(count left) more were not looked at for want of time."
[ ! -e "$results/bad" ] || { echo "It found something in these, or in what is read with them:"; cat "$results/bad"; exit 1; }
