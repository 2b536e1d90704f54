#!/usr/bin/env bash
# Measures the worst ticks again and replaces their section of docs/bench.md; the rest stays. Takes about two minutes.
#   tests/bench/remake_worst.sh [BUILD_FOLDER]      default build/release
set -euo pipefail
cd "$(dirname "$0")/../.."
build=${1:-build/release}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
counted=$folder/counted fresh=$folder/fresh.md
tests/bench/compare.sh "$build" worst >"$counted"
"$build/bin/compare_renderers" --scene worst --instructions "$counted" --markdown "$fresh" >/dev/null
machine=$(lscpu | sed -n 's/^Model name: *//p')
awk -v fresh="$fresh" -v day="$(date -u +%F)" -v machine="$machine" '
    function section(line) { while ((getline line < fresh) > 0) { if (line ~ /^## /) on = line ~ /^## The worst ticks/; if (on) print line } done = 1 }
    /^## / { skip = $0 ~ /^## The worst ticks/ }
    skip && !done { section() }
    /^Measured / { sub(/(, the worst ticks [^,]+,)? on /, ", the worst ticks " day " on " machine ", on ") }
    !skip { print }
    END { if (!done) section() }
' docs/bench.md >"$counted"
cp "$counted" docs/bench.md
