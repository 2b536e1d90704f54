#!/usr/bin/env bash
# Compiles headers alone, so that each must include what it needs:
#   tests/headers.sh          headers among the files of tests/changed.sh
#   tests/headers.sh all      every header
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
mapfile -t headers < <(tests/changed.sh "${1:-}" | grep -E '^(worlds|settings|haptic|audio-cues|app)/.*\.h$' | grep -v 'precompiled\.h$')
read -ra foreign < <(pkg-config --cflags-only-I atk-bridge-2.0 atk gio-2.0 imgui bullet-float64)
printf '%s\0' "${headers[@]}" | xargs -0 -r -n 1 -P "$(nproc)" clang++ -std=c++20 -fsyntax-only -w -I. "${foreign[@]}" -x c++
echo "${#headers[@]} headers compile alone."
