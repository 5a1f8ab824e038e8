# shellcheck shell=bash
# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# To be sourced.  install_packages NAME... installs the missing ones of these Debian packages.  If this
# is impossible, it prints the reason in one sentence and returns 1.

missing_packages()
{
  local package
  for package in "$@"; do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] ||
      printf '%s ' "$package"
  done
}

# Returns 0 for root, or if sudo works without a password or can ask for it on a terminal.
can_be_root()
{
  [ "$(id -u)" -eq 0 ] || { command -v sudo >/dev/null &&
    { sudo -n true 2>/dev/null || { [ -t 0 ] && sudo -v; }; }; }
}

as_root()
{
  if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

install_packages()
{
  if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    echo "This script installs missing packages with apt-get, which this system does not have." \
         "Install the content of these Debian packages and call cmake: $*" >&2
    return 1
  fi

  local missing log
  missing=$(missing_packages "$@")
  [ -n "$missing" ] || return 0
  if ! can_be_root; then
    echo "Packages are missing and can only be installed by root or with sudo. Ask your" \
         "administrator for: apt-get install $missing" >&2
    return 1
  fi

  echo "Installing $missing"
  log=$(mktemp)
  # Package names hold no blanks: $missing is meant to be split.
  if ! { as_root apt-get update &&
         as_root env DEBIAN_FRONTEND=noninteractive \
           apt-get install --yes --no-install-recommends $missing; } >"$log" 2>&1; then
    grep -E '^E:' "$log" >&2 || tail -n 20 "$log" >&2
    rm -f "$log"
    echo "apt-get could not install the missing packages (see its messages above)." \
         "This script is made for Debian 12." >&2
    return 1
  fi
  rm -f "$log"
}
