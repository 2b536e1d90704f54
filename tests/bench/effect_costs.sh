#!/usr/bin/env bash
# Mean instructions per touch_tick in an empty world and within each kind of effect, liquid and soft patch, counted by callgrind.
#   tests/bench/effect_costs.sh [BUILD_FOLDER] [TICKS]     default build/release 4000
set -euo pipefail
cd "$(dirname "$0")/../.."
build=${1:-build/release} ticks=${2:-4000}
command -v valgrind >/dev/null || { echo "valgrind is missing; install the package valgrind."; exit 1; }
out=$(mktemp)
trap 'rm -f "$out"' EXIT
"$build/bin/effect_costs" | while read -r kind _; do
    valgrind --tool=callgrind --callgrind-out-file="$out" --toggle-collect='*measured_ticks*' "$build/bin/effect_costs" "$kind" "$ticks" >/dev/null 2>&1
    printf '%-24s %8d instructions a tick\n' "$kind" "$(($(awk '/^summary:/ {print $2}' "$out") / ticks))"
done
