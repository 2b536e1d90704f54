#!/usr/bin/env bash
# Makes docs/bench.md and its plots again, and in build/bench the tables and plots of each family and the knobs.
# Takes about a quarter of an hour on a machine that is otherwise quiet.
#   tests/bench/remake_results.sh [BUILD_FOLDER] [MORE_MAPS...]      default build/release and no maps besides the bundled ones
set -euo pipefail
cd "$(dirname "$0")/../.."
build=${1:-build/release}
shift || true
counted=$(mktemp)
trap 'rm -f "$counted"' EXIT
tests/bench/compare.sh "$build" >"$counted"
mkdir -p build/bench
maps=()
for map in "$@"; do maps+=(--map "$map"); done
"$build/bin/compare_renderers" "${maps[@]}" --instructions "$counted" --svg build/bench --markdown build/bench/bench.md
sed 's|\[each family separately\](bench-families.md)|`tests/bench/remake_results.sh` makes the tables of each family in build/bench|' build/bench/bench.md >docs/bench.md
for plot in density hard-cases simplified triangles; do cp "build/bench/bench-$plot.svg" docs; done
