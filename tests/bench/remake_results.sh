#!/usr/bin/env bash
# Remakes docs/bench.md, docs/bench-families.md and their plots, instructions included, on a machine that is otherwise quiet: about a quarter of an hour.
#   tests/bench/remake_results.sh [BUILD_FOLDER] [MORE_MAPS...]      default build/release and no maps besides the bundled ones
set -euo pipefail
cd "$(dirname "$0")/../.."
build=${1:-build/release}
shift || true
counted=$(mktemp)
trap 'rm -f "$counted"' EXIT
tests/bench/compare.sh "$build" >"$counted"
maps=()
for map in "$@"; do maps+=(--map "$map"); done
"$build/bin/handrail" bench "${maps[@]}" --instructions "$counted" --svg docs --markdown docs/bench.md
