#!/usr/bin/env bash
# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# getting_started.sh FOLDER PREFIX PYTHON_FOLDER [--without-viewer]: runs the commands of the page "Getting
# Started" word for word in FOLDER, which is emptied first.  Fails if a command fails or if a program does
# not print what the page says.  PREFIX has the installed program, library and page of the viewer,
# PYTHON_FOLDER the Python module.  The commands of the section "Installation" are omitted: the caller has
# installed everything.  With --without-viewer, the section "Viewer" is omitted as well.
set -eu -o pipefail

omitted=Installation
files=(path.vtp fine.ply distance.ply distance.png)
if [ "${4:-}" = --without-viewer ]; then
  omitted="Installation|Viewer"
  echo "The viewer was not built. Its section is skipped."
else
  files+=(fine.html)
fi

page=$(realpath "$(dirname "${BASH_SOURCE[0]}")/../doc/manual/getting_started.txt")
prefix=$(realpath "$2") python_folder=$(realpath "$3")
rm -rf "$1"
mkdir -p "$1/home" "$1/work"
cd "$1"

# The page installs to ~/.local.  The compiler cache remains where it is.
export CCACHE_DIR=${CCACHE_DIR:-$HOME/.cache/ccache} HOME=$PWD/home
ln -s "$prefix" home/.local
export PATH=$HOME/.local/bin:/usr/bin:$PATH PYTHONPATH=$python_folder

# Converts the blocks of the page to a script.  A block after "the file `NAME`:" is the content of the
# file.  A block after "prints:" must be a part of the output of the block of commands before it.
awk -v omitted=" ($omitted)\$" '
  /^\\section/ { omit = $0 ~ omitted; sections += !omit }
  omit { next }
  /^```$/ && is_block { is_block = 0; print end; next }
  is_block { print; next }
  /^```/ {
    is_block = 1
    end = "END_OF_BLOCK"
    if(name) print "cat >" name " <<\"END_OF_BLOCK\""
    else if(is_output) print "check_output <<\"END_OF_BLOCK\""
    else { print "{"; end = "} >../output" }
    next
  }
  /./ { name = ""; is_output = /prints:$/ }
  match($0, /the file `[^`]*`:$/) { name = substr($0, RSTART + 10, RLENGTH - 12) }
  END { if(sections < 3) { print "The page has less than three sections." >"/dev/stderr"; exit 1 } }
' "$page" >script

# Fails if the output of the last commands does not contain the text of the standard input.
check_output()
{
  local expected
  expected=$(cat)
  if [[ $(cat ../output) != *"$expected"* ]]; then
    printf 'The page says:\n%s\nThe commands printed:\n%s\n' "$expected" "$(cat ../output)" >&2
    return 1
  fi
}

cd work
. ../script
for file in "${files[@]}"; do
  [ -s "$file" ] || { echo "The commands did not write $file." >&2; exit 1; }
done
echo "All commands of the page did what it says."
