#!/usr/bin/env bash
# Parses headers by themselves, with no precompiled header to lean on, in the build of the preset release:
#   tests/headers.sh          what is changed and not committed, and what the last 30 commits changed
#   tests/headers.sh all      every one (the target headers_alone)
# Ends with 1, and the first errors, where one lacks an include.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
commits=30 log=build/headers_alone.log
if [ "${1:-}" = all ]; then
    targets=(headers_alone)
else
    mapfile -t targets < <({ git diff --name-only HEAD; git ls-files --others --exclude-standard;
        git rev-list -n $commits HEAD | git diff-tree --stdin --no-commit-id --name-only -r --root; } |
        grep -E '^(worlds|settings|haptic|audio-cues|app)/.*\.h$' | grep -v 'precompiled\.h$' | sort -u |
        while read -r header; do [ ! -e "$header" ] || echo "tests/unit/structure/alone/${header//\//_}.stamp"; done)
    [ ${#targets[@]} -gt 0 ] || { echo "No header was changed."; exit 0; }
fi
cmake --build --preset release --target "${targets[@]}" >"$log" || { grep -E -A 4 '(error|FAILED)' "$log" | head -n 100; exit 1; }
echo "Parsed alone: $(grep -c 'Parsing .* alone' "$log" || true) headers, the others since before."
