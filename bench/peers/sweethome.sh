#!/bin/sh
# Renders a stored point of view of a home with Sweet Home 3D's own photo renderer; needs no display.
#
# Usage: bench/peers/sweethome.sh HOME.sh3d OUT.png [WIDTHxHEIGHT] [HIGH|LOW] [CAMERA]
#   e.g. bench/peers/sweethome.sh Studio.sh3d studio.png 640x480 HIGH 1
# Prints one line of JSON with the seconds of the render call; see sweethome.java beside it for what the words mean.
# Installs nothing. On Debian it needs the packages sweethome3d, default-jdk-headless and xvfb.
# JAVA_OPTIONS are handed to java, e.g. JAVA_OPTIONS=-Xmx4g.
set -eu
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)

for tool in java xvfb-run; do
    command -v "$tool" > /dev/null || { echo "sweethome.sh: $tool is not installed" >&2; exit 1; }
done

class_path=
for jar in /usr/share/sweethome3d/sweethome3d.jar /usr/share/java/j3dcore.jar /usr/share/java/j3dutils.jar \
    /usr/share/java/vecmath.jar /usr/share/java/sunflow.jar /usr/share/java/janino.jar \
    /usr/share/java/commons-compiler.jar /usr/share/java/batik.jar; do
    [ -e "$jar" ] || { echo "sweethome.sh: $jar is not installed" >&2; exit 1; }
    class_path=$class_path${class_path:+:}$jar
done

# Java 3D refuses to load without a display, although the photo renderer draws nothing on it.
# shellcheck disable=SC2086
exec xvfb-run -a java ${JAVA_OPTIONS:-} -Djava.library.path=/usr/lib/jni \
    -Dcom.eteks.sweethome3d.j3d.checkOffScreenSupport=false --add-exports java.desktop/sun.awt=ALL-UNNAMED \
    -cp "$class_path" "$here/sweethome.java" "$@"
