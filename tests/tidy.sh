#!/usr/bin/env bash
# Checks sources with clang-tidy and .clang-tidy:
#   tests/tidy.sh              sources among the files of tests/changed.sh
#   tests/tidy.sh all          every source of the program
#   tests/tidy.sh FILE...      the given sources
# A header stands for the source with the same name. Leaves out app/page/browser, which only emscripten compiles. Each
# source is compiled alone: build/tidy has no unity build and no precompiled headers.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
cmake --preset release -B build/tidy -DHANDRAIL_TESTS=OFF -DCMAKE_UNITY_BUILD=OFF -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON >build/tidy.log || { cat build/tidy.log; exit 1; }
case "${1:-}" in
    '' | all) files() { tests/changed.sh "$@"; } ;;
    *) files() { printf '%s\n' "$@"; } ;;
esac
mapfile -t sources < <(files "$@" | sed -nE 's#^((app|audio-cues|haptic|settings|worlds)/.*)\.(cpp|h)$#\1.cpp#p' | awk '!seen[$0]++' |
    grep -v '^app/page/browser/' | while read -r source; do [ ! -e "$source" ] || echo "$source"; done)
printf '%s\0' "${sources[@]}" | xargs -0 -r -n 1 -P "$(nproc)" clang-tidy --quiet -p build/tidy 2> >(grep -v " warnings\? generated" >&2)
echo "clang-tidy finds nothing in ${#sources[@]} sources."
