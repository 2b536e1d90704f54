#!/usr/bin/env bash
# sources.sh FOLDER: puts the sources of the libraries that a page needs into FOLDER, from Debian's source packages, and
# links to headers of this machine into FOLDER/include. It uses an apt of its own in FOLDER/apt, with the machine's
# entries turned into entries for sources, and changes nothing of the system's. A source that this Debian no longer
# offers comes from testing. A folder that is complete is left as it is.
set -euo pipefail
. /etc/os-release
folder=$1
mkdir -p "$folder/include" "$folder/apt/parts" "$folder/apt/lists/partial" "$folder/apt/cache/archives/partial"
cd "$folder"

entries() {
    sed -sE 's/^Types:.*/Types: deb-src/' /etc/apt/sources.list.d/debian.sources 2>/dev/null >apt/parts/debian.sources ||
        rm -f apt/parts/debian.sources
    sed -nE 's/^deb(-src)? (.*debian.*)/deb-src \2/p' /etc/apt/sources.list 2>/dev/null | sort -u >apt/parts/debian.list || true
    printf '%s\n' 'Types: deb-src' "URIs: http://deb.debian.org/debian" 'Suites: testing' 'Components: main' \
        'Signed-By: /usr/share/keyrings/debian-archive-keyring.gpg' >apt/parts/testing.sources
    printf '%s\n' 'Dir::Etc::SourceList "/dev/null";' "Dir::Etc::SourceParts \"$PWD/apt/parts\";" 'APT::Sandbox::User "root";' \
        "Dir::State::Lists \"$PWD/apt/lists\";" "Dir::Cache \"$PWD/apt/cache\";" >apt/apt.conf
    APT_CONFIG=apt/apt.conf apt-get -q update >apt/log 2>&1
}

# fetch NAME PACKAGE: unpacks the original archive of the Debian source package PACKAGE into the folder NAME.
fetch() {
    [ ! -d "$1" ] || return 0
    [ -f apt/apt.conf ] || entries || { tail -n 5 apt/log >&2; echo "Debian's lists of sources cannot be had." >&2; return 1; }
    rm -rf apt/now && mkdir apt/now
    local from
    for from in "$VERSION_CODENAME" testing; do
        (cd apt/now && APT_CONFIG=../apt.conf apt-get -q source --download-only --tar-only "$2/$from") >>apt/log 2>&1 && break
    done
    local archive
    archive=$(find apt/now -name '*.orig.tar.*' ! -name '*.asc' | head -n 1)
    [ -n "$archive" ] || { echo "The source of Debian's package $2 cannot be had; apt's messages are in $PWD/apt/log." >&2; return 1; }
    mkdir apt/now/unpacked && tar -C apt/now/unpacked --strip-components=1 -xf "$archive" && mv apt/now/unpacked "$1"
}

fetch bullet bullet
fetch openmesh openmesh
fetch recastnavigation recastnavigation
fetch zlib zlib
ln -sfn -t include /usr/include/{boost,fmt,glm,nlohmann,tl,toml++,gcrypt.h} "$(find /usr/include -name gpg-error.h | head -n 1)"
mkdir -p include/recastnavigation
ln -sf -t include/recastnavigation "$PWD"/recastnavigation/{Recast,Detour}/Include/*.h
