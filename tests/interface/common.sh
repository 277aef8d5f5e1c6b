# SPDX-License-Identifier: LGPL-2.1-or-later
# What the tests of programs share; sourced, with $1 the source and $2 the build
# folder. Everything happens in a folder of its own, with a blank in its name.
set -eu
source_dir=$1
build_dir=$2
prm=$source_dir/prm
demold=$build_dir/step-demold/step-demold
interface=$build_dir/step-nts-adhesion/step-nts-adhesion
arclength=$build_dir/step-arclength/step-arclength

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

contents()
{
  ls -AR .
}

# refused "words, of, the message" PROGRAM ARGUMENTS...: exit code 2, one line
# that holds the words, and nothing written.
refused()
{
  words=$1
  shift
  before=$(contents)
  code=0
  "$@" > "$folder/../${folder##*/}.out" 2> "$folder/../${folder##*/}.err" ||
    code=$?
  message=$(cat "$folder/../${folder##*/}.err")
  rm -f "$folder/../${folder##*/}.out" "$folder/../${folder##*/}.err"
  [ "$code" = 2 ] || complain "exit code $code instead of 2: $*"
  [ "$(echo "$message" | wc -l)" = 1 ] || complain "not one line: $message"
  case $message in
    'Bad input: '*) ;;
    *) complain "not announced as bad input: $message" ;;
  esac
  while [ -n "$words" ]; do
    word=${words%%, *}
    case $message in
      *"$word"*) ;;
      *) complain "no \"$word\" in: $message" ;;
    esac
    [ "$word" != "$words" ] || break
    words=${words#*, }
  done
  [ "$(contents)" = "$before" ] || complain "something was written: $*"
}
