# shellcheck shell=bash
# Provides functions for scripts that work in an empty Debian. in_root.sh and ../packaging/on_bare_debian.sh source it.

# make_root SYSTEM ROOT LOG: makes an empty Debian in ROOT, from the source that this machine's own apt uses. Fails with
# a sentence if apt has no such source or cannot reach it.
make_root() {
    local source
    source=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Label: Debian' 'Component: main' | head -n 1)
    [ -n "$source" ] || { echo "apt knows no source of Debian packages; apt-get update may help."; return 1; }
    debootstrap --variant=minbase "$1" "$2" "$source" >"$3" 2>&1 || { echo "debootstrap failed: $(tail -n 1 "$3")"; return 1; }
    # Copies the settings that apt needs to reach the source: the proxy, if there is one, and whether a mirror may be out
    # of date.
    apt-config dump | grep -iE '^Acquire::((https?|ftp)::.*proxy|Check-Valid-Until)' >"$2/etc/apt/apt.conf.d/99proxy" || true
    printf '#!/bin/sh\nexit 101\n' >"$2/usr/sbin/policy-rc.d"  # packages start no services
    chmod +x "$2/usr/sbin/policy-rc.d"
}

# can_mount: succeeds if the functions below can be used here.
can_mount() { [ "$(id -u)" -eq 0 ] && unshare --mount --pid --fork true 2>/dev/null; }

# mount_in ROOT: mounts /proc, /dev and a separate /dev/shm in ROOT. Call it only inside
# `unshare --mount --pid --fork --kill-child`, so that all mounts and processes end with the script.
mount_in() {
    mount -t proc proc "$1/proc"
    mount --rbind /dev "$1/dev"
    mount -t tmpfs tmpfs "$1/dev/shm"
    cp /etc/resolv.conf "$1/etc/"
}

# in_there ROOT [NAME=VALUE...] COMMAND...: runs a command inside ROOT with a clean environment.
in_there() { chroot "$1" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin DEBIAN_FRONTEND=noninteractive "${@:2}"; }
