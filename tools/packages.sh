#!/bin/bash
# What no package registry offers: Debian packages, by name. Missing ones are installed.
#   tools/packages.sh chromium povray
set -euo pipefail

present() {
    case $1 in
        gcc) command -v cc ;;
        libc6-dev) test -e /usr/include/stdio.h ;;
        python3-venv) python3 -c 'import ensurepip, venv' ;;
        chromium) command -v "${CHROMIUM:-chromium}" ;;
        rustc-web) test -x /usr/bin/rustc ;;
        rust-web-src) dpkg-query --show --showformat='${db:Status-Status}' "$1" | grep -qx installed ;;
        *) command -v "$1" ;;
    esac >/dev/null 2>&1
}

missing=()
for name in "$@"; do
    present "$name" || missing+=("$name")
done
[ ${#missing[@]} -eq 0 ] && exit 0

install=(apt-get install --yes --no-install-recommends "${missing[@]}")
if [ "$(id -u)" -ne 0 ] || ! command -v apt-get >/dev/null; then
    echo "Missing here, and only root on Debian can install it: ${missing[*]}" >&2
    echo "Please run:  sudo ${install[*]}" >&2
    exit 1
fi
echo "Installing Debian packages: ${missing[*]}"
export DEBIAN_FRONTEND=noninteractive
apt-get update -qq
"${install[@]}" -qq
