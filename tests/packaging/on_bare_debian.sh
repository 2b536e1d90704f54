#!/usr/bin/env bash
# Installs the package in an empty Debian without a compiler, in the release for which the package was made. Starts the
# program, explores the house by text, upgrades from an older version and removes the package. The upgrade must keep
# settings and marks.
#   on_bare_debian.sh PACKAGES    PACKAGES: the folder that ./run package fills
# Needs root, the network, some minutes, and 1 GB of /var/tmp.
# Exit status 0: all passed. 1: a sentence says what failed. 77: no empty Debian can be made here.
set -euo pipefail
fail() { echo "FAILED: $*" >&2; exit 1; }
skip() { echo "Skipped: $*"; exit 77; }
source "$(dirname "${BASH_SOURCE[0]}")/../systems/empty_root.sh"

if [ "${2:-}" != inside ]; then
    packages=("${1:?the folder of the packages}"/handrail_*.deb)
    [ -e "${packages[0]}" ] || fail "there is no package of handrail in $1; ./run package makes one."
    [ ${#packages[@]} -eq 1 ] || fail "there is more than one package of handrail in $1."
    version=$(dpkg-deb -f "${packages[0]}" Version)
    case "$version" in
    *~deb12) system=bookworm ;;
    *~deb13) system=trixie ;;
    *~deb[a-z]*) system=testing ;;
    *) fail "${packages[0]} has the version $version, which names no Debian." ;;
    esac
    can_mount || skip "only root can make and mount an empty Debian."
    command -v debootstrap >/dev/null || skip "debootstrap is not installed."
    folder=$(mktemp -d /var/tmp/handrail-test-bare-XXXXXX)
    trap 'rm -rf --one-file-system "$folder"' EXIT
    said=$(make_root "$system" "$folder/root" "$folder/log") || skip "$said"
    mkdir "$folder/root/packages"
    cp "${packages[0]}" "$folder/root/packages/handrail.deb"
    # Makes a package with the same files and an older version.
    dpkg-deb -R "${packages[0]}" "$folder/before"
    sed -i 's/^Version: .*/Version: 0.0.9/' "$folder/before/DEBIAN/control"
    dpkg-deb --root-owner-group -Znone -b "$folder/before" "$folder/root/packages/handrail_before.deb" >/dev/null
    unshare --mount --pid --fork --kill-child bash "${BASH_SOURCE[0]}" "$1" inside "$folder"
    exit
fi

folder=$3 root=$3/root
mount_in "$root"
apt() { in_there "$root" apt-get -qy --no-install-recommends "$@" >"$folder/log" 2>&1 || fail "apt-get $*: $(tail -n 5 "$folder/log")"; }
visit() { printf '%s\n' "$1" | timeout 120 chroot "$root" env -i HOME=/srv/visitor PATH=/usr/bin:/bin LC_ALL="${language:-C.UTF-8}" handrail "${@:2}" 2>&1; }
says() { grep -qF -- "$2" <<<"$1" || fail "it did not say \"$2\" but: $1"; }
mkdir -p "$root/srv/visitor"
installed() { in_there "$root" dpkg-query -f '${db:Status-Status} ${Package}\n' -W | sed -n 's/^installed //p' | sort; }
installed >"$folder/packages_before"

apt update
apt install /packages/handrail_before.deb
! in_there "$root" sh -c 'command -v gcc c++ cc cmake ninja' || fail "the package brought tools to build with."
said=$(visit $'where am i\nmark\nHere I was\nwhat is here\nquit' house --no-window --device none)
says "$said" "House"
says "$said" "Here I was"
says "$said" "metres"
mkdir -p "$root/srv/visitor/.config/handrail"
printf '[welcome]\ndone = true\n[workspace]\nscale = 33\n' >"$root/srv/visitor/.config/handrail/settings.toml"
own=$(cd "$root/srv/visitor" && find . -type f -exec sha256sum {} + | sort)

apt install /packages/handrail.deb
version=$(in_there "$root" dpkg-query -f '${Version}' -W handrail)
[ "$version" != 0.0.9 ] || fail "apt did not upgrade."
[ "$own" = "$(cd "$root/srv/visitor" && find . -type f -exec sha256sum {} + | sort)" ] || fail "upgrading touched the person's own files."
says "$(visit '' settings)" "workspace.scale = 33"
says "$(visit $'marks\nlist\nescape\nquit' house --no-window --device none)" "Here I was"
says "$(language=de_DE.UTF-8 visit '' --help)" "ein Gebäude durch Tasten"
own=$(cd "$root/srv/visitor" && find . -type f -exec sha256sum {} + | sort)
came=$(installed | comm -13 "$folder/packages_before" - | wc -l)

apt purge handrail
# By default, apt keeps a package that a remaining package merely suggests: libsystemd0 of Debian 13 suggests
# libgcrypt20.
apt autoremove --purge -o APT::AutoRemove::RecommendsImportant=false -o APT::AutoRemove::SuggestsImportant=false
[ "$own" = "$(cd "$root/srv/visitor" && find . -type f -exec sha256sum {} + | sort)" ] || fail "removing touched the person's own files."
rm -rf "$root/packages" "$root/srv/visitor"
left=$(find "$root" -xdev -name '*handrail*' ! -path "$root/var/log/*")
[ -z "$left" ] || fail "removing left: $left"
left=$(installed | comm -13 "$folder/packages_before" - | paste -sd ' ')
[ -z "$left" ] || fail "removing left packages that it had brought: $left"
echo "Installed, explored, upgraded to $version and removed in an empty $(in_there "$root" sh -c '. /etc/os-release; echo "$PRETTY_NAME"'); $came packages came and went."
