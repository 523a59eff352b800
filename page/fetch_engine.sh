#!/usr/bin/env bash
# Downloads and unpacks the source of Debian's physics engine (ODE), which the page compiles to WebAssembly; nothing is installed.
#   fetch_engine.sh          fetch it, if it is missing
#   fetch_engine.sh --check  only say whether it is there (exit 1 if not)
# Into $CCA_PAGE_ENGINE, or cca/ode in the user's cache. apt checks the signature; the version is that of libode-dev.
set -euo pipefail
folder=${CCA_PAGE_ENGINE:-${XDG_CACHE_HOME:-${HOME:-/root}/.cache}/cca/ode}

if [ -f "$folder/ode/src/ode.cpp" ]; then echo "page: the engine's source is in $folder"; exit 0; fi
[ "${1-}" = --check ] && { echo "page: no source of the engine in $folder; ./bootstrap page fetches it"; exit 1; }

mkdir -p "$(dirname "$folder")"
work=$(mktemp -d "$folder.XXXXXX")
trap 'rm -rf "$work"' EXIT
# Debian's own lists mostly lack sources, so apt gets a list and a folder for it of its own.
. /etc/os-release
mirror=$(cat /etc/apt/sources.list.d/*.sources /etc/apt/sources.list 2>/dev/null | sed -n 's/^URIs: *\(http[^ ]*debian\) *$/\1/p; s/^deb \(http[^ ]*debian\) .*/\1/p' | sed 1q || true)
mkdir -p "$work/lists/partial"
echo "deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] ${mirror:-http://deb.debian.org/debian} $VERSION_CODENAME main" >"$work/sources.list"
apt=(apt-get --quiet -o Dir::Etc::sourcelist="$work/sources.list" -o Dir::Etc::sourceparts=- -o Dir::State::lists="$work/lists" -o APT::Sandbox::User=root)
"${apt[@]}" update || { echo "page: apt-get update failed: is there a network?" >&2; exit 1; }
cd "$work"
"${apt[@]}" source --download-only ode || { echo "page: apt-get could not download the source of ode" >&2; exit 1; }
dpkg-source --no-check --extract ./ode_*.dsc unpacked >/dev/null
rm -rf "$folder"
mv unpacked "$folder"
echo "page: the engine's source fetched into $folder"
