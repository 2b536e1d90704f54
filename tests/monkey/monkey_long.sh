#!/usr/bin/env bash
# Runs the monkey test for minutes, from a new seed each time. Each seed runs 100,000 actions, divided among eight
# parts:
#   tests/monkey/monkey_long.sh [MINUTES] [ACTS]       by default 10 minutes and 100,000 actions
# The script prints one line for each part of each seed. The log of a failed part is in $HANDRAIL_CORPORA/monkey, or in
# ~/.cache/handrail-fuzz/monkey. The line contains the command that repeats the part. Exit status 1: a part failed.
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
