#!/usr/bin/env bash
# Measures the worst ticks anew and puts them in their section of docs/bench.md, which otherwise stays: about two minutes.
#   tests/bench/remake_worst.sh [BUILD_FOLDER]      default build/release
set -euo pipefail
cd "$(dirname "$0")/../.."
build=${1:-build/release}
counted=$(mktemp) fresh=$(mktemp)
trap 'rm -f "$counted" "$fresh"' EXIT
tests/bench/compare.sh "$build" worst >"$counted"
"$build/bin/handrail" bench --scene worst --instructions "$counted" --markdown "$fresh" >/dev/null
awk -v fresh="$fresh" '
    function section(line) { while ((getline line < fresh) > 0) { if (line ~ /^### /) on = line ~ /^### The worst ticks/; if (on) print line } done = 1 }
    /^### / { skip = $0 ~ /^### The worst ticks/; if (skip || ($0 ~ /^### Stiffest/ && !done)) { if (!done) { section(); print "" } } }
    !skip { print }
' docs/bench.md >"$counted"
cp "$counted" docs/bench.md
