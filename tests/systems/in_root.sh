#!/usr/bin/env bash
# Builds and tests Handrail in an empty Debian of another version, with ./run house and then ./run tests. Prints one
# line with the result.
#   in_root.sh bookworm|trixie|testing [COMMAND...]    COMMAND: run this instead, for example ./run package
# HANDRAIL_ROOTS     the folder of the roots, by default build/systems. Each root needs 6 GB and stays for the next run, as
#                    does its compiler cache.
# HANDRAIL_PRESET    the preset for the build, by default gcc in trixie and release elsewhere
# Needs root, debootstrap and the network. Exit status 0: passed; 1: failed; 2: wrong use; 77: the script cannot make such a root here.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
source "$here/tests/systems/empty_root.sh"

system=${1:-}
case "$system" in
trixie) preset=${HANDRAIL_PRESET:-gcc} ;;
bookworm | testing) preset=${HANDRAIL_PRESET:-release} ;;
*) echo "Name the system: bookworm, trixie or testing." >&2; exit 2 ;;
esac
folder=${HANDRAIL_ROOTS:-$here/build/systems}/$system
root=$folder/root project=$folder/root/srv/handrail log=$folder/log

if [ "${inside_root:-}" != yes ]; then
    skip() { echo "$system: skipped: $*"; exit 77; }
    can_mount || skip "only root can make and mount an empty Debian."
    mkdir -p "$folder/ccache"
    exec 8>"$folder/lock"
    flock -n 8 || skip "another in_root.sh works in $folder."
    if [ ! -e "$folder/made" ]; then
        command -v debootstrap >/dev/null || skip "debootstrap is not installed."
        rm -rf --one-file-system "$root"
        said=$(make_root "$system" "$root" "$folder/debootstrap.log") || skip "$said"
        touch "$folder/made"
    fi
    # Copies the tracked files into a Git repository, because tests ask Git for the project's files. A file that differs
    # gets the current time, so that it is built again: its time in this tree could be older than a build of another
    # version of it.
    mkdir -p "$project"
    git -C "$project" init -q
    tracked=$(git -C "$here" ls-files | sort)
    comm -13 <(echo "$tracked") <(git -C "$project" ls-files | sort) | (cd "$project" && xargs -d '\n' rm -f)
    (cd "$here" && while read -r file; do
        [ ! -f "$file" ] || cmp -s "$file" "$project/$file" || cp --parents --preserve=mode "$file" "$project"
    done <<<"$tracked")
    git -C "$project" add -A
    inside_root=yes exec unshare --mount --pid --fork --kill-child "${BASH_SOURCE[0]}" "$@"
fi

mount_in "$root"
mkdir -p "$root/var/cache/ccache"
mount --bind "$folder/ccache" "$root/var/cache/ccache"
run_there() {
    in_there "$root" CCACHE_DIR=/var/cache/ccache HANDRAIL_PRESET="$preset" \
        ${CMAKE_BUILD_PARALLEL_LEVEL:+CMAKE_BUILD_PARALLEL_LEVEL=$CMAKE_BUILD_PARALLEL_LEVEL} \
        sh -c 'cd /srv/handrail && exec "$@"' sh "$@"
}
if [ $# -gt 1 ]; then
    run_there "${@:2}"
    exit
fi

name="$system ($(in_there "$root" sh -c '. /etc/os-release; echo "$PRETTY_NAME"'), preset $preset)"
if ! run_there ./run house </dev/null >"$log.house" 2>&1; then
    echo "$name: FAILED: ./run house, see $log.house: $(tail -n 1 "$log.house")"
    exit 1
fi
status=0
run_there ./run tests </dev/null >"$log.tests" 2>&1 || status=1
summary=$(grep -E 'tests passed' "$log.tests" || tail -n 1 "$log.tests")
skipped=$(grep -cE '\(Skipped\)$' "$log.tests" || true)
[ $status -eq 0 ] && outcome=passed || outcome=FAILED
echo "$name: $outcome: ./run house; ./run tests: $summary; $skipped skipped; $((SECONDS / 60)) min; see $log.tests"
exit $status
