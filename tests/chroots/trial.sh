# tests/chroots/package.sh runs this file in a bare chroot, with -e: the first command that fails
# ends it. /root/trial has the packages, a golden picture and a small C++ project.
cd /root/trial

# ends_with CODE COMMAND... is for commands whose exit code must not be 0.
ends_with() {
  wanted=$1
  shift
  code=0
  "$@" || code=$?
  [ "$code" = "$wanted" ]
}

# try PREFIX tries the program, a lab and the library that are installed there.
try() {
  rm -rf lab build teapot.png consumer.png
  "$1/bin/glassbox" render teapot --size 960x540 -o teapot.png
  "$1/bin/glassbox" diff readme.png teapot.png
  "$1/bin/glassbox" lab start 3 lab
  ends_with 1 "$1/bin/glassbox" lab check lab # nothing is written yet
  cp "$1/share/glassbox/labs/03-view/student.cpp" lab
  "$1/bin/glassbox" lab check lab
  "$1/bin/glassbox" man >/dev/null
  for file in man/man1/glassbox.1 bash-completion/completions/glassbox zsh/site-functions/_glassbox \
    fish/vendor_completions.d/glassbox.fish; do
    test -s "$1/share/$file"
  done
  # A student builds the lab, and a user builds a program of their own.
  cmake -S lab -B build/lab -G Ninja -DCMAKE_PREFIX_PATH="$1"
  cmake --build build/lab
  cmake -S consumer -B build/consumer -G Ninja -DCMAKE_PREFIX_PATH="$1"
  cmake --build build/consumer
  build/consumer/consumer consumer.png
}

apt-get update
DEBIAN_FRONTEND=noninteractive apt-get install -y ./glassbox_*.deb
try /usr
[ "$(command -v glassbox)" = /usr/bin/glassbox ]

# The archive has the same content, and works in any folder. The other packages that the package
# installed stay.
dpkg --remove glassbox
[ -z "$(command -v glassbox)" ]
place="/opt/an odd place, ü"
mkdir -p "$place"
tar -xzf glassbox-*.tar.gz -C "$place"
for unpacked in "$place"/*; do try "$unpacked"; done
