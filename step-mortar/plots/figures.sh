#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# The pictures of ../results.md that compare formulations.
#
# Usage: figures.sh BUILD-FOLDER [FOLDER]; default: beside this file. 3 minutes.
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

# run NAME STEP SCENE options...: the scene by node to segment, with standard and
# with dual multipliers
run()
{
  name=$1 step=$2 scene=$3
  shift 3
  "$build/$step/$step" "$prm/$scene" --quiet --output "$runs/$name-nodes" \
    --set "Contact/formulation=node to segment" "$@"
  for multipliers in standard dual; do
    "$build/$step/$step" "$prm/$scene" --quiet \
      --output "$runs/$name-$multipliers" --set Contact/formulation=mortar \
      --set "Contact/multipliers=$multipliers" "$@"
  done
}

run hertz step-mortar step-mortar/hertz-two-bodies.prm
# as deep, and with penalties as high, as node to segment gets by
run ironing step-mortar step-mortar/ironing.prm --set "Process/end time=3" \
  --set "Supports/motion y=-0.3*min(t,1)" --set Contact/penalty=300 \
  --set Friction/penalty=300
run slice step-demold step-demold/slice.prm

gnuplot << END
set datafile separator ","
set key autotitle columnhead
set terminal svg size 640,420 font "sans,12"
set key top right
nodes(name)    = "$runs/".name."-nodes"
standard(name) = "$runs/".name."-standard"
dual(name)     = "$runs/".name."-dual"

set output "$plots/hertz-pressure.svg"
set xlabel "x [mm]"
set ylabel "pressure [MPa]"
set samples 500
a = 0.8031333
p_0 = 0.07926701
plot [0:1] p_0*sqrt(1 - (x/a)**2) title "Hertz" lc "black", \
  nodes("hertz")."/interface.csv" using "x [mm]":"pressure [MPa]" \
    with points pt 2 title "node to segment", \
  standard("hertz")."/interface.csv" using "x [mm]":"pressure [MPa]" \
    with points pt 6 title "mortar, standard", \
  dual("hertz")."/interface.csv" using "x [mm]":"pressure [MPa]" \
    with points pt 4 title "mortar, dual"

set xlabel "way of the indenter [mm]"
set ylabel "horizontal force [N/mm]"
set key bottom right
set output "$plots/ironing-force.svg"
plot [0.5:4] [0.3:0.4] nodes("ironing")."/history.csv" \
    using "opening [mm]":"force [N]" with lines title "node to segment", \
  standard("ironing")."/history.csv" using "opening [mm]":"force [N]" \
    with lines title "mortar, standard", \
  dual("ironing")."/history.csv" using "opening [mm]":"force [N]" \
    with lines title "mortar, dual"

set xlabel "opening [mm]"
set ylabel "force [N]"
set key top right
set output "$plots/slice-force.svg"
plot [0:1] nodes("slice")."/history.csv" using "opening [mm]":"force [N]" \
    with lines title "node to segment", \
  standard("slice")."/history.csv" using "opening [mm]":"force [N]" \
    with lines title "mortar, standard", \
  dual("slice")."/history.csv" using "opening [mm]":"force [N]" \
    with lines title "mortar, dual"
END
