#!/usr/bin/env bash
# Compiles headers alone, so that each must include what it needs:
#   tests/headers.sh          headers with uncommitted changes or changed by the last 30 commits; the newest 150
#   tests/headers.sh all      every header
set -euo pipefail
most=150
cd "$(dirname "${BASH_SOURCE[0]}")/.."
changed() { git diff --name-only HEAD; git ls-files --others --exclude-standard; git log -30 --name-only --format=; }
[ "${1:-}" != all ] || { most=100000; changed() { git ls-files; }; }
mapfile -t headers < <(changed | grep -E '^(worlds|settings|haptic|audio-cues|app)/.*\.h$' | grep -v 'precompiled\.h$' | awk '!seen[$0]++' |
    while read -r header; do [ ! -e "$header" ] || echo "$header"; done | sed "${most}q")
read -ra foreign < <(pkg-config --cflags-only-I atk-bridge-2.0 atk gio-2.0 imgui bullet-float64)
printf '%s\0' "${headers[@]}" | xargs -0 -r -n 1 -P "$(nproc)" clang++ -std=c++20 -fsyntax-only -w -I. "${foreign[@]}" -x c++
echo "${#headers[@]} headers compile alone."
