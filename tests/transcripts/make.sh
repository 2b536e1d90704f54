#!/usr/bin/env bash
# Plays scripted sessions, so that you can compare two versions of the program. The sessions give every command twice:
# first in the order of the table, then in a random order that SEED determines. They do so in each world, in English and
# in German, without a device and with a simulated hand that touches nearby things. The script writes the scenario files
# to OUT/scenarios and plays them with PROGRAM. It writes what was announced, played and felt to OUT/texts. Two versions
# behave alike if `diff -r` finds no difference between their texts.
#   tests/transcripts/make.sh OUT PROGRAM [WORLD ...]      by default house.map and school.map; SEED is 1 by default
set -euo pipefail
out=$(realpath -m "$1") program=$(realpath "$2")
shift 2
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
worlds=("$@")
((${#worlds[@]})) || worlds=(house.map school.map)
seed=${SEED:-1}
echo "seed $seed"
mapfile -t commands < <(grep -rhoE 'CommandInfo\{Command::\w+, "[a-z-]+"' --include=command.cpp app | sed -E 's/.*"(.*)"/\1/')
((${#commands[@]} > 80)) || { echo "The table of commands was not found." >&2; exit 1; }
mkdir -p "$out/scenarios" "$out/home"

# Gives one command and waits for the answer. If the command opens a list, goes through the list and chooses one line, or
# sometimes closes the list instead.
act() {
    case $1 in
        leave | calibrate) return ;;  # these commands end the session or start the set-up
        forward | back | left | right | hand-* | workspace-* | tilt-* | trail-left | trail-right | retrace | free-*) printf '[[do]]\nhold = "%s"\nfor_s = %s\n' "$1" "$2" ;;
        *) printf '[[do]]\npress = "%s"\n' "$1" ;;
    esac
    printf '[[do]]\nwait_s = 0.4\n'
    case $1 in
        find) printf '[[do]]\ntype = "a"\n[[do]]\nwait_s = 0.3\n[[do]]\nkey = "Enter"\n[[do]]\nwait_s = 1\n[[do]]\nkey = "Escape"\n' ;;
        menu | marks | exits | unvisited | routes | ways | learnt | desk | help | lessons | simplified | language | name-room | progress | unexplored)
            case $3 in
                0) printf '[[do]]\nkey = "Down"\n[[do]]\nwait_s = 0.3\n[[do]]\nkey = "Enter"\n[[do]]\nwait_s = 1\n[[do]]\nkey = "Escape"\n' ;;
                1) printf '[[do]]\nkey = "Down"\n[[do]]\nkey = "Down"\n[[do]]\nwait_s = 0.3\n[[do]]\nkey = "Up"\n[[do]]\nwait_s = 0.3\n[[do]]\nkey = "Escape"\n' ;;
                *) printf '[[do]]\nkey = "Down"\n[[do]]\nkey = "Down"\n[[do]]\nkey = "Down"\n[[do]]\nkey = "Enter"\n[[do]]\nwait_s = 1\n[[do]]\nkey = "Escape"\n' ;;
            esac
            printf '[[do]]\nwait_s = 0.2\n' ;;
    esac
}

for world in "${worlds[@]}"; do
    for language in en de; do
        for device in none sim-t sim-f; do
            name=$(basename "${world%.*}")_${language}_$device
            {
                printf 'title = "%s"\nworld = "%s"\ndevice = "%s"\nsettings = { "speech.language" = "%s" }\n' "$name" "$world" "$device" "$language"
                printf '[[do]]\nwait_s = 2\n'
                for command in "${commands[@]}"; do act "$command" 0.7 0; done
                [ "$device" = none ] || printf '[[do]]\nmove_by = [0.0, 0.0, -1.5]\nspeed_m_per_s = 0.05\n[[do]]\nmove_by = [2.0, 0.5, 0.0]\nspeed_m_per_s = 0.05\n[[do]]\nmove_by = [-1.0, 3.0, 0.7]\nspeed_m_per_s = 0.05\n'
                RANDOM=$seed
                for ((i = 0; i < 250; ++i)); do act "${commands[RANDOM % ${#commands[@]}]}" "0.$((RANDOM % 9 + 1))" $((RANDOM % 3)); done
                printf '[[expect]]\nforce_n = [0, 100]\n'
            } >"$out/scenarios/$name.toml"
        done
    done
done
rm -rf "$out/texts"
HOME=$out/home "$program" scenario "$out/scenarios" --transcripts "$out/texts"
cat "$out"/texts/*.txt | sha256sum
