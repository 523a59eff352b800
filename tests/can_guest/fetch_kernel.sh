#!/usr/bin/env bash
# Downloads and unpacks Debian's kernel for the guest of the preset test-can-guest; it is not installed on this machine.
#   fetch_kernel.sh          fetch it, if it is missing
#   fetch_kernel.sh --check  only say whether it is there (exit 1 if not)
# Into $CCA_CAN_GUEST, or cca/can_guest in the user's cache. The version is the one that linux-image-amd64 depends on.
set -euo pipefail
folder=${CCA_CAN_GUEST:-${XDG_CACHE_HOME:-${HOME:-/root}/.cache}/cca/can_guest}

complete() { [ -s "$folder/vmlinux" ] && [ -d "$folder/modules" ] && [ -s "$folder/version" ]; }
if complete; then echo "can guest: kernel $(cat "$folder/version") is in $folder"; exit 0; fi
[ "${1-}" = --check ] && { echo "can guest: no kernel in $folder; ./bootstrap fetches it"; exit 1; }

# The generic kernel has CAN, the cloud kernel has not.
package=$(apt-cache depends linux-image-amd64 2>/dev/null | sed -n 's/^ *Depends: *\(linux-image-.*\)/\1/p' | head -n 1)
[ -n "$package" ] || { echo "can guest: apt knows no linux-image-amd64; apt-get update first" >&2; exit 1; }
mkdir -p "$folder"
work=$(mktemp -d "$folder/fetching.XXXXXX")
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get download --quiet "$package" 2>&1 | grep -v unsandboxed || true
deb=$(ls ./*.deb 2>/dev/null | head -n 1)
[ -n "$deb" ] || { echo "can guest: apt-get could not download $package" >&2; exit 1; }
# Only what the tests load: a thirtieth of the package.
dpkg --fsys-tarfile "$deb" | tar --extract --wildcards './boot/vmlinuz-*' './lib/modules/*/kernel/net/can/*' './lib/modules/*/kernel/drivers/net/can/*' \
  './lib/modules/*/modules.builtin'
version=$(basename lib/modules/*)

# Unpacked here, so the emulated machine need not do it: that saves three seconds a boot.
python3 - boot/vmlinuz-* vmlinux <<'P'
import lzma, struct, sys
image = open(sys.argv[1], "rb").read()
setup = (image[0x1F1] or 4) + 1  # sectors; Linux, Documentation/x86/boot.rst
offset, length = struct.unpack_from("<II", image, 0x248)
kernel = lzma.LZMADecompressor().decompress(image[setup * 512 + offset:setup * 512 + offset + length])
if kernel[:4] != b"\x7fELF":
    sys.exit("can guest: this kernel is not packed by xz")
open(sys.argv[2], "wb").write(kernel)
P
rm -rf "$folder/modules" "$folder/vmlinux" "$folder/version"
mv lib/modules/"$version" "$folder/modules"
mv vmlinux "$folder/vmlinux"
echo "$version" >"$folder/version"
echo "can guest: kernel $version fetched into $folder"
