#!/usr/bin/env bash
# What features cost that a scene does not have, in instructions per touch_tick by callgrind on the recorded walk through quake-e1m1.map: as shipped, with
# every optional feature compiled out, and with all compiled in and none used. Fails when the first is more than half a percent above the second, when
# results differ in a bit, or when the third costs no more (then the comparison would see nothing). 77: something it needs is not here.
#   tests/bench/absent_features.sh [BUILD_FOLDER] [TICKS]     default build/release 60000
set -euo pipefail
cd "$(dirname "$0")/../.."
build=${1:-build/release} ticks=${2:-60000}
command -v valgrind >/dev/null || { echo "Skipped: valgrind is missing; install the package valgrind."; exit 77; }
out=$(mktemp) said=$(mktemp)
trap 'rm -f "$out" "$said"' EXIT
declare -A count result
for part in touch plain all; do
    valgrind --tool=callgrind --callgrind-out-file="$out" --toggle-collect='*measured_ticks*' "$build/bin/touch_walk" "$ticks" "$part" >"$said" 2>/dev/null || { status=$?; cat "$said"; exit $status; }
    count[$part]=$(awk '/^summary:/ {print $2}' "$out")
    result[$part]=$(sed 's/.*checksum //' "$said")
done
show() { printf '%-34s %7d instructions a tick\n' "$2" $((count[$1] / ticks)); }
show touch "as shipped"
show plain "optional features compiled out"
show all "all compiled in, none used"
[ "${result[touch]}" = "${result[plain]}" ] && [ "${result[touch]}" = "${result[all]}" ] || { echo "Results differ: ${result[*]}"; exit 1; }
within() { [ $((200 * (count[$1] - count[plain]))) -le "${count[plain]}" ]; }
within touch || { echo "Absent features cost more than half a percent."; exit 1; }
within all && { echo "All features compiled in cost nothing: the comparison would see nothing."; exit 1; }
echo "Absent features cost $(((count[touch] - count[plain]) * 10000 / count[plain])) hundredths of a percent."
