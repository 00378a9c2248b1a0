#!/bin/sh
# cases.sh prints the cases for the program of another machine, one case a line: NAME<TAB>arguments
# of `glassbox`. They run in this order, in a folder with the files of images/golden. Some read what
# earlier ones wrote. All cases except the views come from the golden images.
set -eu

golden=$(CDPATH='' cd -- "$(dirname -- "$0")/../../images/golden" && pwd -P)
tab=$(printf '\t')

# Each golden command is drawn by the fastest engine of the machine, by the staged engine, and by
# the tile engine with vectors that the compiler makes of plain numbers.
grep -v '^#' "$golden/commands.txt" | while IFS="$tab" read -r file arguments; do
  name=${file%.png}
  printf '%s\t%s -o %s-made.png\n' "$name" "$arguments" "$name"
  case $arguments in
  render*)
    printf '%s by the stages\t%s --engine staged -o %s-staged.png\n' "$name" "$arguments" "$name"
    printf '%s by plain numbers\t%s --engine tile --target scalar --threads 2 --no-plan -o %s-scalar.png\n' \
      "$name" "$arguments" "$name"
    ;;
  esac
done

# The scenes of these commands are also followed step by step, and written as data.
grep -v '^#' "$golden/commands.txt" | sed -n "s/^[^$tab]*${tab}render \([^ ]*\).*/\1/p" | sort -u | while read -r scene; do
  name=$(printf %s "$scene" | tr '/:' '--')
  case $scene in
  *lines*) ;; # the scene has no triangle
  *) printf 'step %s\tstep %s --triangle 0 --size 320x180 --json -\n' "$scene" "$scene" ;;
  esac
  printf 'trace %s\ttrace %s --size 64x36 -o %s-trace.json\n' "$scene" "$scene" "$name"
  printf 'arrays %s\ttrace %s --size 64x36 -o %s-trace.npz\n' "$scene" "$scene" "$name"
done

# These files are computed from pictures: cameras, layers, shapes, textures, glyphs, depths.
cat <<'TEXT' | sed "s/: /$tab/"
cameras: views geometry --scene room --size 320x240 --move 0.3,0.02,0.03 --turn -6,1,2 --noise 0.2 --cameras-out cameras.txt --pair-out left.png right.png
depths: views match left.png right.png --cameras cameras.txt --range -10,60 --rectified-out l.png r.png --depth-out turned.pfm
layers: views layers build room --size 150x150 -o room.ldi
warped: views layers draw room.ldi --eye 1.75,1.62,-0.3 --look-at 0.68,1.39,-2.46 -o warped.png
ring: views ring teapot -o ring
voxels: views voxels ring --resolution 32 -o voxels.ply
polygons: views polygons ring --resolution 32 -o polygons.glb
sheet: views glyphs sheet -o sheet.png --pitch 28 --diameter 21
TEXT
