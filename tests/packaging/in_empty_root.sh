#!/usr/bin/env bash
# Makes the packages and checks them with Debian's own checkers. Then does with them what a person does: installs,
# starts, upgrades and removes them. This happens in a temporary copy of this system, without the source folder.
#   in_empty_root.sh BUILD SOURCE
# Exit status 0: all passed. 1: a sentence says what failed. 77: no such copy can be made here.
set -euo pipefail
build=$1 source=$2
fail() { echo "FAILED: $*" >&2; exit 1; }
note() { echo "Skipped: $*"; }

if [ "${3:-}" != inside ]; then
    command -v dpkg-deb >/dev/null || { note "this is not Debian."; exit 77; }
    folder=$(mktemp -d /tmp/handrail-test-package-XXXXXX)
    trap 'rm -rf "$folder"' EXIT
    cpack --config "$build/CPackConfig.cmake" -B "$folder/now" >"$folder/log" 2>&1 || {
        cat "$folder/log" >&2
        fail "no package could be made."
    }
    rm -rf "$folder/now/_CPack_Packages"
    package=$(echo "$folder"/now/handrail_*.deb)
    dpkg-deb -c "$package" >"$folder/list"
    for file in bin/handrail libexec/handrail/handrail-guard libexec/handrail/handrail-reader lib/udev/rules.d/70-handrail.rules share/handrail/worlds/house.map \
        share/handrail/worlds/labyrinth1.settings.toml share/handrail/languages/de.toml share/applications/handrail.desktop \
        share/icons/hicolor/scalable/apps/handrail.svg share/metainfo/handrail.metainfo.xml share/mime/packages/handrail.xml \
        share/bash-completion/completions/handrail share/zsh/vendor-completions/_handrail share/doc/handrail/copyright \
        share/doc/handrail/changelog.gz share/doc/handrail/html/index.html share/doc/handrail/html/settings.html; do
        grep -q " ./usr/$file$" "$folder/list" || fail "the package lacks /usr/$file."
    done
    # Another release of Debian has other versions of the libraries, so the version of the package must name the
    # release.
    version=$(dpkg-deb -f "$package" Version)
    release=$(. /etc/os-release && echo "${VERSION_ID:-$VERSION_CODENAME}")
    [[ "$version" == *~*"$release" ]] || fail "the version $version does not name the release $release."
    [[ "$(dpkg-deb -f "$folder"/now/libhandrail-dev_*.deb Depends)" == *"libhandrail0 (= $version)"* ]] || fail "libhandrail-dev does not depend on libhandrail0 of its version."
    for name in libhandrail0 libhandrail-dev; do dpkg-deb -c "$folder"/now/${name}_*.deb >>"$folder/list" || fail "there is no package $name."; done
    for file in lib/libhandrail.so.0 include/handrail.h include/handrail/haptic/render/touch.h lib/libhandrail_render.a lib/cmake/handrail/handrailConfig.cmake; do
        grep -q " ./usr/$file\( -> .*\)\?$" "$folder/list" || fail "the packages of the library lack /usr/$file."
    done
    dpkg-deb -x "$package" "$folder/tree"
    tree=$folder/tree/usr
    # No package may contain the path where it was made, not even in the bytes of programs and libraries.
    mkdir "$folder/all"
    for made in "$folder"/now/*.deb; do dpkg-deb -x "$made" "$folder/all"; done
    for place in "$source" "$build"; do
        told=$(grep -rlaF -- "$place" "$folder/all" | head -n 5) || true
        [ -z "$told" ] || fail "these hold the path $place of the machine that made them: $told"
    done
    rm -rf "$folder/all"

    # Each command needs a manual page in each language.
    for command in $(LC_ALL=C "$tree/bin/handrail" --help | sed -nE '/^Subcommands:/,/^$/s/^  ([a-z]+) .*/\1/p') ''; do
        for language in '' de/; do
            [ -s "$tree/share/man/${language}man1/handrail${command:+-$command}.1.gz" ] || fail "there is no manual page of ${command:-handrail} in $language."
        done
    done
    gzip -dc "$tree/share/man/man1/handrail-export.1.gz" | grep -q 'swell paper' || fail "the page of export does not say what its help does."
    if command -v man >/dev/null && [ -x /usr/bin/groff ]; then
        for page in "$tree"/share/man/man1/*.gz "$tree"/share/man/de/man1/*.gz; do
            said=$(LC_ALL=C.UTF-8 MANROFFSEQ='' MANWIDTH=80 man --warnings -E UTF-8 -l -Tutf8 -Z "$page" 2>&1 >/dev/null) || true
            [ -z "$said" ] || fail "$page: $said"
        done
    else note "man is not installed."; fi
    if command -v desktop-file-validate >/dev/null; then
        said=$(desktop-file-validate "$tree/share/applications/handrail.desktop" 2>&1) || true
        [ -z "$said" ] || fail "$said"
    else note "desktop-file-validate is not installed."; fi
    if command -v appstreamcli >/dev/null; then
        # Our file has no home page, and names its developers as the appstream of Debian 12 knows it.
        said=$(appstreamcli validate --no-net --pedantic "$tree/share/metainfo/handrail.metainfo.xml" 2>&1 | grep -E '^[EWIP]:' |
            grep -vE ' (url-homepage-missing|developer-name-tag-deprecated|developer-info-missing)$') || true
        [ -z "$said" ] || fail "$said"
        # Checks the file as a distributor changes it, who has a web page and pictures.
        sed 's|<releases>|<url type="homepage">https://handrail.example</url><screenshots><screenshot type="default"><image>https://handrail.example/window.png</image><caption>The plan.</caption></screenshot></screenshots>&|' \
            "$tree/share/metainfo/handrail.metainfo.xml" >"$folder/with_pictures.metainfo.xml"
        appstreamcli validate --no-net "$folder/with_pictures.metainfo.xml" >"$folder/log" 2>&1 || fail "$(cat "$folder/log")"
    else note "appstreamcli is not installed."; fi
    if command -v lintian >/dev/null; then
        said=$(lintian --allow-root --profile debian --no-tag-display-limit "$folder"/now/*.deb 2>&1) || true
        ! grep -qE '^[EW]:' <<<"$said" || fail "lintian: $(grep -E '^[EW]:' <<<"$said" | head -n 20)"
    else note "lintian is not installed."; fi

    # Checks what the shells offer as completions.
    offered() { bash -c 'source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); HANDRAIL_WORLDS=$worlds _handrail; echo "${COMPREPLY[@]}"' _ "$tree/share/bash-completion/completions/handrail" "$@"; }
    export worlds=$tree/share/handrail/worlds
    [[ " $(offered handrail ho) " == *" house "* ]] || fail "bash offers no world for ho."
    [[ " $(offered handrail exp) " == *" export "* ]] || fail "bash offers no export for exp."
    [[ " $(offered handrail export --sw) " == " --swell " ]] || fail "bash does not offer --swell alone for export --sw."
    if command -v zsh >/dev/null; then zsh -n "$tree/share/zsh/vendor-completions/_handrail" || fail "zsh cannot read its completion."
    else note "zsh is not installed, so nobody has read its completion."; fi

    # Every link of a page must lead to an existing page and an existing part of it.
    python3 - "$tree/share/doc/handrail/html" <<'PY' || fail "a page of the guides is not as it should be."
import pathlib, re, sys, urllib.parse
root = pathlib.Path(sys.argv[1])
pages = {page: page.read_text(encoding="utf-8") for page in root.rglob("*.html")}
wrong = []
for page, text in pages.items():
    for needed in ("<!DOCTYPE html>", "<html lang=", "<title>", "<main>"):
        if needed not in text:
            wrong.append(f"{page.name} lacks {needed}")
    if len(re.findall(r"<h1\b", text)) != 1:
        wrong.append(f"{page.name} has not one first heading")
    for address in re.findall(r'(?:href|src)="([^"]+)"', text):
        if re.match("[a-z]+:", address):
            continue
        path, _, part = urllib.parse.unquote(address).partition("#")
        target = (page.parent / path).resolve() if path else page
        if not target.is_file():
            wrong.append(f"{page.name} leads to {address}, which is not there")
        elif part and f'id="{part}"' not in pages.get(target, ""):
            wrong.append(f"{page.name} leads to {address}, which has no such part")
print("\n".join(wrong))
sys.exit(1 if wrong or len(pages) < 5 else 0)
PY

    # Mounts a copy of this system in memory, which only this script sees.
    cat >"$folder/outside.sh" <<'SH'
set -e
mount -t tmpfs none "$1/memory"
mkdir "$1/memory/upper" "$1/memory/work"
mount -t overlay none -o "lowerdir=/,upperdir=$1/memory/upper,workdir=$1/memory/work" "$1/root"
SH
    mkdir "$folder/memory" "$folder/root"
    as_root=()
    [ "$(id -u)" -eq 0 ] || as_root=(--map-root-user)
    unshare --mount "${as_root[@]}" bash "$folder/outside.sh" "$folder" 2>"$folder/log" || {
        note "no copy of this system can be made here, so nothing was installed: $(tail -n 1 "$folder/log")"
        exit 77
    }
    # Makes an older package, which contains a world that the new package lacks.
    dpkg-deb -R "$package" "$folder/before"
    sed -i 's/^Version: .*/Version: 0.0.9/' "$folder/before/DEBIAN/control"
    echo '{ "classname" "worldspawn" }' >"$folder/before/usr/share/handrail/worlds/long_gone.map"
    dpkg-deb --root-owner-group -Znone -b "$folder/before" "$folder/before.deb" >/dev/null
    unshare --mount "${as_root[@]}" bash -c 'bash "$0/outside.sh" "$0" && exec "$1" "$2" "$3" inside "$0"' "$folder" "${BASH_SOURCE[0]}" "$build" "$source"
    exit
fi

# From here on, the script runs inside its own mount namespace. $folder/root is the copy of the system.
folder=$4 root=$4/root
mount --rbind /dev "$root/dev"
mount --rbind /proc "$root/proc"
mkdir -p "$root/opt/packages" "$root/srv/visitor/.config/handrail"
cp "$folder/before.deb" "$root/opt/packages/before.deb"
cp "$folder"/now/handrail_*.deb "$root/opt/packages/now.deb"
for hidden in "$source" "$build"; do [ ! -d "$root$hidden" ] || mount -t tmpfs none "$root$hidden"; done
printf '[welcome]\ndone = true\n[speech]\nthrough = "text"\n[workspace]\nscale = 33\n' >"$root/srv/visitor/.config/handrail/settings.toml"
dpkg_there() { chroot "$root" env DEBIAN_FRONTEND=noninteractive dpkg --force-unsafe-io "$@" >"$folder/log" 2>&1 || fail "dpkg $*: $(cat "$folder/log")"; }
visit() { printf '%s\n' "$1" | chroot "$root" env -i HOME=/srv/visitor PATH=/usr/bin:/bin LC_ALL=C.UTF-8 ALSOFT_DRIVERS=null NO_AT_BRIDGE=1 SPEECHD_ADDRESS=unix_socket:/nonexistent BRLAPI_HOST=:99999 handrail "${@:2}" 2>&1; }
says() { grep -qF -- "$2" <<<"$1" || fail "it did not say \"$2\" but: $1"; }

dpkg_there -i /opt/packages/before.deb
[ -e "$root/usr/share/handrail/worlds/long_gone.map" ] || fail "the older package was not installed whole."
said=$(visit $'mark\nHere I was\nwhere am i\nquit' house --no-window --device none)
says "$said" "Here I was"
says "$said" "metres"
says "$(visit '' settings)" "workspace.scale = 33"
says "$(chroot "$root" env -i HOME=/srv/visitor LC_ALL=de_DE.UTF-8 PATH=/usr/bin:/bin handrail --help)" "ein Gebäude durch Tasten"

dpkg_there -i /opt/packages/now.deb
[ ! -e "$root/usr/share/handrail/worlds/long_gone.map" ] || fail "a world that the new package lacks stayed after the upgrade."
says "$(visit '' settings)" "workspace.scale = 33"
said=$(visit $'marks\nlist\nescape\nquit' house --no-window --device none)
says "$said" "Here I was"
if [ -x "$root/usr/bin/update-mime-database" ]; then
    for kind in x-quake-map x-ifc vnd.openstreetmap.data+xml x-handrail-link; do grep -qrs "application/$kind:" "$root/usr/share/mime/globs2" || fail "application/$kind is not known after installing."; done
fi

own=$(cd "$root/srv/visitor" && find . -type f -exec sha256sum {} + | sort)
dpkg_there --purge handrail
[ "$own" = "$(cd "$root/srv/visitor" && find . -type f -exec sha256sum {} + | sort)" ] || fail "removing touched the person's own files."
rm -rf "$root/opt/packages" "$root/srv/visitor"
left=$(cd "$folder/memory/upper" && find . -name '*handrail*' ! -type c ! -path './var/log/*' ! -path './tmp/*')
[ -z "$left" ] || fail "removing left: $left"
left=$(cd "$folder/memory/upper" && grep -rlis handrail . | grep -vE '^\./(var/log/|var/cache/man/|var/lib/dpkg/(status|available)(-old)?$|tmp/)' || true)
[ -z "$left" ] || fail "removing left its name in: $left"
echo "Judged, installed, started, upgraded and removed."
