#!/usr/bin/env bash
# The monkey for minutes, from a new seed each time, with acts of 100,000 divided by its eight parts:
#   tests/monkey/monkey_long.sh [MINUTES] [ACTS]       10 minutes, unless told otherwise
# One line of result for each part of each seed; what a failing part did is in $HANDRAIL_CORPORA/monkey, or in
# ~/.cache/handrail-fuzz/monkey. The line names what repeats it. Ends with 1 if anything failed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
monkey=${HANDRAIL_MONKEY:-build/${HANDRAIL_PRESET:-release}/bin/monkey}
minutes=${1:-10} acts=${2:-100000}
home=${HANDRAIL_CORPORA:-${XDG_CACHE_HOME:-$HOME/.cache}/handrail-fuzz}/monkey
mkdir -p "$home"
end=$((SECONDS + 60 * minutes)) parts=0 failed=0
while [ $SECONDS -lt $end ]; do
    seed=$((RANDOM * 32768 + RANDOM + 1))
    for part in 0 1 2 3 4 5 6 7; do
        [ $SECONDS -lt $end ] || break
        log=$home/seed-$seed-part-$part.log
        parts=$((parts + 1))
        if HANDRAIL_SEED=$seed HANDRAIL_ACTS=$acts "$monkey" "--gtest_filter=*/$part" >"$log" 2>&1; then
            echo "seed $seed, part $part: $((acts / 8)) acts, nothing found"
            rm "$log"
        else
            failed=$((failed + 1))
            echo "seed $seed, part $part: failed, see $log; HANDRAIL_SEED=$seed HANDRAIL_ACTS=$acts $monkey --gtest_filter='*/$part'"
        fi
    done
done
echo "$parts parts of $((acts / 8)) acts, $failed failed"
[ $failed = 0 ]
