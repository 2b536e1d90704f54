#!/bin/busybox sh
# The first and only process of the machine that in_qemu.sh boots. It loads the modules, runs each test program, and
# switches the machine off.
/bin/busybox --install -s /bin
export PATH=/bin
mount -t devtmpfs dev /dev
mount -t proc proc /proc
mount -t sysfs sys /sys
for module in /modules/*.ko; do
    insmod "$module" || echo "[guest] FAILED to load $module"
done
export LD_LIBRARY_PATH=/lib/x86_64-linux-gnu:/usr/lib/x86_64-linux-gnu
for program in /tests/*; do
    { "$program" --gtest_color=no 2>&1; echo "$?" >/tmp/status; } | sed 's/^/[guest] /'
    [ "$(cat /tmp/status)" = 0 ] || echo "[guest] FAILED: $program ended with status $(cat /tmp/status)"
done
echo "[guest] finished"
poweroff -f
