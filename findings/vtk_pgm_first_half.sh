#!/bin/sh
# vtk_pgm_first_half.sh - VTK's picture of a PGM of 16 bits is the first half of its bytes
#
# Software: Debian's python3-vtk9 9.1.0+really9.1.0+dfsg2-5+deb12u1 (VTK 9.1.0), vtkPNMReader.
# Input: a binary PGM of 4 x 2 samples, 0x1000 to 0x8000, of a maximum of 65535, as height fields
# are kept; the same as PNG of 16 bits; and a PGM of 4 x 1 samples of a maximum of 31.
# Behaviour: the reader steps over the maximum and takes a sample for a byte, while the text on PGM
# has two, the higher first, for maxima above 255. So the upper row of the picture is the first two
# samples, cut up into bytes, the lower row is the other two, and the second half is not read. Width
# and height are right, no error is told, and every other column is noise. Samples of a maximum of
# 31 stay as they are, so white is nearly black. vtkPNGReader makes unsigned short of the same
# samples. One would guess shorts, or a refusal, from a reader that has to find where a header ends.
# Output seen: "pgm 65535: unsigned char 16 0 32 0 48 0 64 0", "png: unsigned short 4096 8192 12288
# 16384 20480 24576 28672 32768", "pgm 31: unsigned char 0 10 20 31".
# Exit status 1 when that changes, 2 when the packages cannot be had: what is not installed is
# unpacked into a temporary folder. SPDX-License-Identifier: MIT
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
version=9.1.0+really9.1.0+dfsg2-5+deb12u1
mkdir -p "$folder/archives/partial" "$folder/tree"
apt-get install -y -qq --no-install-recommends --download-only \
    -o "Dir::Cache::archives=$folder/archives" "python3-vtk9=$version" >/dev/null 2>&1 ||
    { echo "cannot get python3-vtk9 $version"; exit 2; }
for package in "$folder"/archives/*.deb; do
    [ ! -e "$package" ] || dpkg-deb -x "$package" "$folder/tree" || exit 2
done
libraries=$folder/tree/usr/lib/$(uname -m)-linux-gnu
cat >"$folder/read.py" <<'END'
import struct
import sys
import zlib

import vtk


def chunk(kind, body):
    return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))


def read(title, reader, name, data):
    with open(sys.argv[1] + "/" + name, "wb") as file:
        file.write(data)
    reader.SetFileName(file.name)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    samples = [image.GetScalarComponentAsDouble(x, y, 0, 0)
               for y in reversed(range(height)) for x in range(width)]  # VTK's y points up
    print(title + ":", image.GetScalarTypeAsString(), *[round(sample) for sample in samples],
          *["error"] * (reader.GetErrorCode() != 0))


rows = [struct.pack(">4H", *range(start, start + 0x4000, 0x1000)) for start in (0x1000, 0x5000)]
read("pgm 65535", vtk.vtkPNMReader(), "a.pgm", b"P5\n4 2\n65535\n" + b"".join(rows))
read("png", vtk.vtkPNGReader(), "a.png", b"\x89PNG\r\n\x1a\n"
     + chunk(b"IHDR", struct.pack(">2I5B", 4, 2, 16, 0, 0, 0, 0))
     + chunk(b"IDAT", zlib.compress(b"".join(b"\0" + row for row in rows)))
     + chunk(b"IEND", b""))
read("pgm 31", vtk.vtkPNMReader(), "b.pgm", b"P5\n4 1\n31\n" + bytes([0, 10, 20, 31]))
END
seen=$(LD_LIBRARY_PATH=$libraries:$libraries/blas:$libraries/lapack \
    PYTHONPATH=$folder/tree/usr/lib/python3/dist-packages \
    /usr/bin/python3 "$folder/read.py" "$folder" 2>&1)
echo "$seen"
[ "$seen" = "pgm 65535: unsigned char 16 0 32 0 48 0 64 0
png: unsigned short 4096 8192 12288 16384 20480 24576 28672 32768
pgm 31: unsigned char 0 10 20 31" ]
