#!/usr/bin/env bash
# Runs a program in a virtual machine: boots Debian's kernel with CAN in QEMU, runs the program there as root, and returns its exit code.
#   run.sh [-m MODULES] [-s SETUP] [-d DEVICES] [-f FILES] [-t SECONDS] [-k KERNEL] -- PROGRAM [ARGUMENTS...]
#     -m  modules of the kernel's package, in the order of loading
#     -s  commands of the guest's shell before the program
#     -d  further arguments for QEMU
#     -f  files to put beside the program, in the folder in which it runs; programs come with their libraries
# Exit code: the program's; 124: it took too long; 125: the guest didn't boot, lacked something, or panicked, so the program never
# ended by itself. The guest reports the exit code twice, on the serial line and by a device that ends QEMU, and both must
# agree: so a guest that dies never passes a test.
# It emulates and uses no KVM: /dev/kvm may be there and not work.
set -u
folder=${CCA_CAN_GUEST:-${XDG_CACHE_HOME:-${HOME:-/root}/.cache}/cca/can_guest}
modules='' setup='' devices='' files='' seconds=120 kernel=$folder/vmlinux
lacking() { echo "can guest: $*" >&2; exit 125; }
while getopts m:s:d:f:t:k: option; do
  case $option in
    m) modules=$OPTARG ;; s) setup=$OPTARG ;; d) devices=$OPTARG ;; f) files=$OPTARG ;; t) seconds=$OPTARG ;; k) kernel=$OPTARG ;;
    *) sed -n '2,7s/^# \{0,1\}//p' "$0" >&2; exit 125 ;;
  esac
done
shift $((OPTIND - 1))
[ $# -ge 1 ] || lacking "no program"
program=$1
shift
[ -f "$program" ] || lacking "there is no program $program"
[ -s "$kernel" ] || lacking "there is no kernel $kernel; ./bootstrap fetches it"
for tool in qemu-system-x86_64 cpio /bin/busybox; do command -v $tool >/dev/null || lacking "$tool is not installed; ./bootstrap does"; done
ip=$(command -v ip || echo /sbin/ip)
[ -x "$ip" ] || lacking "ip is not installed; ./bootstrap does"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
root=$work/root
mkdir -p "$root"/{bin,dev,proc,sys,tmp,modules,test}
cp /bin/busybox "$root/bin/busybox"
for applet in sh mount dd cat grep poweroff stty insmod; do ln -s busybox "$root/bin/$applet"; done
copy_with_libraries() {  # program, as
  cp "$1" "$root$2"
  ldd "$1" 2>/dev/null | grep -oE '/[^ ]+' | while read -r library; do
    mkdir -p "$root$(dirname "$library")"
    cp -Lu "$library" "$root$library"
  done
}
copy_with_libraries "$ip" /bin/ip
copy_with_libraries "$program" /test/program
for file in $files; do
  [ -f "$file" ] || lacking "there is no file $file; ./bootstrap installs what the tests need"
  copy_with_libraries "$file" "/test/$(basename "$file")"
done
number=10
for module in $modules; do
  file=$(find "$folder/modules" -name "$module.ko" | head -n 1)
  [ -n "$file" ] || lacking "the kernel has no module $module"
  cp "$file" "$root/modules/$number-$module.ko"
  number=$((number + 1))
done
printf '%s\n' "$setup" >"$root/test/setup"
{ printf 'export CCA_CAN_GUEST=1\nexec /test/program'; for argument in "$@"; do printf " '%s'" "${argument//\'/\'\\\'\'}"; done; echo; } >"$root/test/run"

cat >"$root/init" <<'INIT'
#!/bin/sh
export PATH=/bin
ip() { /bin/ip "$@"; }  # the shell's own ip does not know "type can"
mount -t devtmpfs none /dev; mount -t proc none /proc; mount -t sysfs none /sys
mkdir -p /dev/pts /dev/shm; mount -t devpts none /dev/pts; mount -t tmpfs none /dev/shm; mount -t tmpfs none /tmp
ends() { echo "@@ended $1@@" >/dev/ttyS1; printf "\\x$(printf %02x $(($1 & 127)))" | dd of=/dev/port bs=1 seek=1281 count=1 2>/dev/null; poweroff -f; }
exec </dev/null >/dev/ttyS1 2>&1
stty -F /dev/ttyS1 -opost
for module in /modules/*.ko; do [ ! -e "$module" ] || insmod "$module" || { echo "can guest: $module can't be loaded"; ends 125; }; done
( set -e; . /test/setup ) || { echo "can guest: the setup failed"; ends 125; }
cd /test; sh /test/run; ends $?
INIT
chmod +x "$root/init"
(cd "$root" && find . -print0 | LC_ALL=C sort -z | cpio --null --create --format newc --quiet) >"$work/initrd"

# shellcheck disable=SC2086
timeout --foreground --kill-after 5 "$seconds" qemu-system-x86_64 -machine q35 -accel tcg -cpu max -smp 1 -m 256 -nodefaults -no-user-config -display none -no-reboot -net none \
  -chardev "file,id=log,path=$work/log" -serial chardev:log -chardev "file,id=said,path=$work/said" -serial chardev:said \
  -device isa-debug-exit,iobase=0x501,iosize=0x01 $devices -kernel "$kernel" -initrd "$work/initrd" \
  -append "console=ttyS0 quiet panic=-1 oops=panic mitigations=off nokaslr tsc=reliable random.trust_cpu=on 8250.nr_uarts=2" </dev/null 2>"$work/qemu"
qemu=$?
touch "$work/said" "$work/log"
grep -av '^@@' "$work/said" | tr -d '\r'
code=$(grep -ao '@@ended [0-9]*@@' "$work/said" | tail -n 1 | tr -dc 0-9)
if [ -n "$code" ] && [ $qemu -eq $((((code & 127) << 1 | 1) & 255)) ]; then exit "$code"; fi
{ cat "$work/qemu"; tail -n 20 "$work/log"; } >&2
if [ $qemu -eq 124 ]; then echo "can guest: not ended after $seconds s" >&2; exit 124; fi
lacking "it died: QEMU ended with $qemu, the program with '${code:-nothing}'"
