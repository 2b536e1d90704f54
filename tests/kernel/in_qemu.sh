#!/usr/bin/env bash
# Boots a Debian kernel in QEMU with nothing but the given test programs, and runs them there:
#   in_qemu.sh FOLDER PROGRAM...
# FOLDER keeps the unpacked kernel. The script needs no special rights. Everything is emulated (TCG), so it also runs
# inside other virtual machines. Its output is that of the programs.
# Exit status 0: all passed. 1: a program failed, or the machine did not finish. 77: the test could not be tried.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
mkdir -p "$1"
folder=$(cd "$1" && pwd)
shift
longest_s=300

# The modules, in the order in which they depend on each other.
modules=(usb-common usbcore usbip-core vhci-hcd hid usbhid hid-generic uhid uinput evdev)

say() { echo "$*" >&2; }
skip() { say "Skipped: $*"; exit 77; }

qemu=$(command -v qemu-system-x86_64) || skip "QEMU is not installed. Please run as root: apt-get install qemu-system-x86 busybox-static"
busybox=$(command -v busybox) && ! ldd "$busybox" >/dev/null 2>&1 || skip "a static busybox is not installed. Please run as root: apt-get install busybox-static"
[ "$(uname -m)" = x86_64 ] || skip "these tests are for x86-64 computers."

# Fetches Debian's newest kernel package and unpacks it into $folder/kernel, without installing it.
fetch_kernel() {
    command -v apt-get >/dev/null || skip "this is not Debian, so no kernel can be had."
    local package
    package=$(apt-cache depends linux-image-amd64 2>/dev/null | awk '/Depends: linux-image-[0-9]/ { print $2; exit }')
    [ -n "$package" ] || skip "no package list names a kernel. Please run as root: apt-get update"
    say "Fetching the kernel package $package, about 70 megabytes."
    rm -rf "$folder/kernel" "$folder/download"
    mkdir -p "$folder/download"
    (cd "$folder/download" && apt-get -q download "$package" >"$folder/download.log" 2>&1) || { tail -n 3 "$folder/download.log" >&2; skip "the kernel package cannot be fetched."; }
    dpkg-deb -x "$folder"/download/*.deb "$folder/kernel.new"
    mv "$folder/kernel.new" "$folder/kernel"
    rm -rf "$folder/download"
}

compgen -G "$folder/kernel/boot/vmlinuz-*" >/dev/null || fetch_kernel
kernel=$(compgen -G "$folder/kernel/boot/vmlinuz-*" | head -n 1)

# These are the machine's only files: busybox, the modules, the programs, and the libraries that they load.
root="$folder/root"
rm -rf "$root"
mkdir -p "$root"/{bin,dev,proc,sys,tmp,modules,tests}
cp "$busybox" "$root/bin/busybox"
cp "$here/guest_init.sh" "$root/init"
chmod +x "$root/init"
number=10
for module in "${modules[@]}"; do
    found=$(find "$folder/kernel/lib/modules" -name "$module.ko" | head -n 1)
    [ -n "$found" ] || skip "the kernel package has no module $module."
    cp "$found" "$root/modules/$((number++))-$module.ko"
done
for program in "$@"; do
    cp "$program" "$root/tests/"
    ldd "$program" | awk '$2 == "=>" && $3 ~ /^\// { print $3 } $1 ~ /^\// { print $1 }' | while read -r library; do
        mkdir -p "$root$(dirname "$library")"
        cp -L "$library" "$root$library"
    done
done
(cd "$root" && find . | busybox cpio -o -H newc 2>/dev/null | gzip -1) >"$folder/initramfs.gz"
rm -rf "$root"

say "Booting $(basename "$kernel") in QEMU; this takes about half a minute."
log="$folder/console.log"
timeout "$longest_s" "$qemu" -M q35,usb=off -accel tcg -cpu max -smp 1 -m 512 -nographic -no-reboot -net none \
    -kernel "$kernel" -initrd "$folder/initramfs.gz" -append "console=ttyS0 quiet panic=-1 mitigations=off no_timer_check" </dev/null 2>&1 |
    tr -d '\r' | tee "$log" | sed -n 's/^\[guest\] //p'
if ! grep -q '^\[guest\] finished$' "$log"; then
    say "The machine did not come to its end within $longest_s seconds; its last words:"
    tail -n 20 "$log" >&2
    exit 1
fi
! grep -q '^\[guest\] FAILED' "$log"
