#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# The pictures of ../results.md.
#
# Usage: figures.sh BUILD-FOLDER [FOLDER]; default: beside this file. 1 minute.
set -eu
LC_ALL=C
export LC_ALL
if [ $# -lt 1 ]; then
  echo "Usage: figures.sh BUILD-FOLDER [FOLDER]" >&2
  exit 2
fi
build=$1
here=$(dirname -- "$(readlink -f -- "$0")")
plots=${2:-$here}
prm=$here/../../prm
runs=$(mktemp -d)
trap 'rm -rf "$runs"' EXIT

# run NAME STEP SCENE options...; a run that gives up has a history too
run()
{
  name=$1 step=$2 scene=$3
  shift 3
  "$build/$step/$step" "$prm/$scene" --quiet --output "$runs/$name" "$@" ||
    [ $? = 1 ]
}

for stiffness in 0.5 1.5 5; do
  run spring-$stiffness step-arclength step-arclength/spring.prm \
    --set "Network/springs=bar grip y $stiffness"
done
run truss step-arclength step-arclength/truss-snap-back.prm
for strategy in quasi-static dynamics automatic; do
  run slice-$strategy step-demold step-demold/slice-steep.prm \
    --set "Solution/strategy=$strategy"
done

gnuplot << END
set datafile separator ","
set key autotitle columnhead
set terminal svg size 640,420 font "sans,12"
set key top right noenhanced
set style data lines

set xlabel "opening [mm]"
set ylabel "force [N]"
set output "$plots/spring-paths.svg"
plot [0:.5] [-.01:.25] for [k in "0.5 1.5 5"] "$runs/spring-".k."/history.csv" \
  using "opening [mm]":"force [N]" title "k_s = ".k." N/mm"

set output "$plots/truss-snap-back.svg"
plot "$runs/truss/history.csv" using "opening [mm]":"force [N]" notitle

set output "$plots/slice-steep-force.svg"
plot [0:.3] for [s in "dynamics automatic quasi-static"] \
  "$runs/slice-".s."/history.csv" using "opening [mm]":"force [N]" title s
END
