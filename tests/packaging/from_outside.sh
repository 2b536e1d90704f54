#!/usr/bin/env bash
# Installs the library into an empty folder and builds another project against it, with the examples of the developer's
# guide. A wall must give the same force in C++, in C and in Python.
#   from_outside.sh BUILD SOURCE
set -euo pipefail
build=$1 source=$2
fail() { echo "FAILED: $*" >&2; exit 1; }
folder=$(mktemp -d /tmp/handrail-test-library-XXXXXX)
trap 'rm -rf "$folder"' EXIT
for component in development library; do
    cmake --install "$build" --prefix "$folder/prefix" --component $component >"$folder/log" 2>&1 || { cat "$folder/log" >&2; fail "it could not be installed."; }
done
# The installed library may contain no path to the place where it was built.
! grep -rlF "$source" "$folder/prefix/lib/cmake" "$folder/prefix/include" || fail "these name the source folder."
head -qn 1 "$folder"/prefix/include/handrail/*/*/*.h | grep -qvE '^// Handrail [0-9.]+: (stable|inner);' && fail "a header does not say whether it stays as it is."
head -n 1 "$folder/prefix/include/handrail/haptic/render/touch.h" | grep -q stable || fail "touch.h is not stable."

cp -r "$source/tests/packaging/outside" "$folder/project"
mkdir "$folder/project/examples"
cp "$source/tests/support/precompiled.h" "$folder/project/examples"
for example in "$source"/tests/examples/*_test.cpp; do
    # Examples of session features are left out, because these are parts of the program, not of the library.
    grep -q '"tests/\|"app/' "$example" || cp "$example" "$folder/project/examples"
done
[ "$(ls "$folder"/project/examples/*.cpp | wc -l)" -ge 4 ] || fail "there are not four examples to build."
cmake -S "$folder/project" -B "$folder/built" -DCMAKE_PREFIX_PATH="$folder/prefix" -DCMAKE_CXX_FLAGS=-ffp-contract=off >"$folder/log" 2>&1 &&
    cmake --build "$folder/built" >"$folder/log" 2>&1 || { grep -E -A 8 '(rror|undefined)' "$folder/log" | head -n 60 >&2; fail "somebody else's project does not build."; }
"$folder/built/examples" --gtest_brief=1 || fail "an example fails."

world=$source/worlds/maps/first_room.map
cpp=$("$folder/built/feel_a_wall" "$world")
c=$("$folder/built/feel_a_wall_c" "$world")
python=$(python3 "$folder/project/feel_a_wall.py" "$folder/prefix/lib/libhandrail.so.0" "$world")
[ "$cpp" = "$c" ] && [ "$c" = "$python" ] || fail "the wall gives $cpp N in C++, $c in C, $python in Python."
python3 -c "import sys; sys.exit(not 0.01 < $cpp < 1.0)" || fail "$cpp N is no force for a tenth of a millimetre."
# In each language, a missing file must give a sentence.
for words in "$folder/built/feel_a_wall" "$folder/built/feel_a_wall_c" "python3 $folder/project/feel_a_wall.py $folder/prefix/lib/libhandrail.so.0"; do
    said=$($words /nowhere/house.map 2>&1) && fail "$words reads a file that there is not."
    [[ "$said" == *house.map* ]] || fail "$words said: $said"
done
# The library may export only the names in its header.
seen=$(nm -D --defined-only "$folder/prefix/lib/libhandrail.so.0" | awk '{print $3}' | grep -vE '^(handrail_|HANDRAIL_1)' | head -n 5 || true)
[ -z "$seen" ] || fail "the library also shows: $seen"
for name in $(grep -oE '\bhandrail_[a-z_]+\(' "$source/haptic/c/handrail.h" | tr -d '(' | sort -u); do
    nm -D --defined-only "$folder/prefix/lib/libhandrail.so.0" | grep -q " T $name@@HANDRAIL_1$" || fail "the library lacks $name."
done
echo "Built from outside; the wall pushes with $cpp N in C++, C and Python."
