# SPDX-License-Identifier: LGPL-2.1-or-later
# What the tests of programs share; sourced, with $1 the source and $2 the build
# folder. Everything happens in a folder of its own, with a blank in its name.
set -eu
source_dir=$1
build_dir=$2
prm=$source_dir/prm
demold=$build_dir/step-demold/step-demold
interface=$build_dir/step-nts-adhesion/step-nts-adhesion

folder=$(mktemp -d "${TMPDIR:-/tmp}/demold test XXXXXX")
trap 'rm -rf -- "$folder"' EXIT
cd -- "$folder"

failures=0
complain()
{
  echo "$*"
  failures=$((failures + 1))
}

finish()
{
  [ "$failures" = 0 ] || echo "$failures complaints"
  [ "$failures" = 0 ]
}
