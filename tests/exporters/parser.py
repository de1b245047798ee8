"""parser - reads PLY, OBJ and STL, to have something to compare planelet with

Written from the formats' descriptions (Turk 1994, Wavefront 1995, 3D Systems 1988), with the
standard library alone; it shares nothing with planelet's readers, and is slow and strict.
A mesh is a list of positions, each a tuple of three words of 32 bits, and a list of polygons,
each a list of indices. Polygons of fewer than three corners are counted and left out.

SPDX-License-Identifier: MIT
"""
import re
import struct

from single import bits_of, bits_of_integer, bits_of_text

SIZES = {"b": 1, "B": 1, "h": 2, "H": 2, "i": 4, "I": 4, "q": 8, "Q": 8, "f": 4, "d": 8}
TYPES = {
    "char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I",
    "float": "f", "double": "d", "int8": "b", "uint8": "B", "int16": "h", "uint16": "H",
    "int32": "i", "uint32": "I", "float32": "f", "float64": "d", "int64": "q", "uint64": "Q",
}
ORDERS = {"ascii": None, "binary_little_endian": "<", "binary_big_endian": ">"}


class Refused(Exception):
    """The file contradicts itself or its format."""


class Mesh:
    def __init__(self):
        self.positions = []
        self.polygons = []
        self.short = 0  # polygons of fewer than three corners
        self.is_ended = True  # false for an ASCII STL without endsolid

    def add(self, corners):
        if len(corners) < 3:
            self.short += 1
        else:
            self.polygons.append(corners)

    def checked(self):
        for corners in self.polygons:
            for corner in corners:
                if not 0 <= corner < len(self.positions):
                    raise Refused(f"corner {corner} of {len(self.positions)} vertices")
        return self


# ---- PLY ---------------------------------------------------------------


class Words:
    """The values of an ASCII body."""

    def __init__(self, body):
        self.words = body.split()
        self.at = 0

    def value(self, kind):
        if self.at == len(self.words):
            raise Refused("the body ends too early")
        text = self.words[self.at].decode("latin-1")
        self.at += 1
        try:
            return float(text) if kind in "fd" else int(text)
        except ValueError:
            raise Refused(f"'{text}' is no {'number' if kind in 'fd' else 'integer'}") from None

    def single(self, kind):
        value = self.value(kind)
        if kind in "fd":
            return bits_of_text(self.words[self.at - 1].decode("latin-1"))
        return bits_of_integer(value)

    def rest(self):
        return len(self.words) - self.at


class Bytes:
    """The values of a binary body."""

    def __init__(self, body, order):
        self.body, self.order, self.at = body, order, 0

    def value(self, kind):
        size = SIZES[kind]
        if self.at + size > len(self.body):
            raise Refused("the body ends too early")
        self.at += size
        return struct.unpack_from(self.order + kind, self.body, self.at - size)[0]

    def single(self, kind):
        value = self.value(kind)
        return bits_of(value) if kind in "fd" else bits_of_integer(value)

    def rest(self):
        return len(self.body) - self.at


def ply_header(data):
    """The order of the bytes, the elements [(name, count, properties)] and the body."""
    end = re.search(rb"(^|[\r\n])end_header[ \t]*(\r\n|\n|\r)", data)
    if not end:
        raise Refused("no end_header")
    order, elements = None, []
    for line in re.split(rb"\r\n|\n|\r", data[: end.start() + 1])[1:]:
        words = line.decode("latin-1").split()
        if not words or words[0] in ("comment", "obj_info"):
            continue
        if words[0] == "format":
            order = words[1]
        elif words[0] == "element":
            elements.append((words[1], int(words[2]), []))
        elif words[0] == "property" and words[1] == "list":
            elements[-1][2].append((words[4], TYPES[words[3]], TYPES[words[2]]))
        elif words[0] == "property":
            elements[-1][2].append((words[2], TYPES[words[1]], None))
        else:
            raise Refused(f"'{words[0]}' in the header")
    if order not in ORDERS:
        raise Refused("no format line")
    return ORDERS[order], elements, data[end.end():]


def read_strip(mesh, corners):
    strip = []
    for corner in corners + [-1]:
        if corner != -1:
            strip.append(corner)
            continue
        for i in range(len(strip) - 2):
            a, b, c = strip[i: i + 3]
            mesh.add([b, a, c] if i % 2 else [a, b, c])
        strip = []


def read_ply(data):
    order, elements, body = ply_header(data)
    source = Bytes(body, order) if order else Words(body)
    mesh = Mesh()
    for name, count, properties in elements:
        for _ in range(count):
            place = {}
            for what, kind, counted in properties:
                if counted:
                    number = source.value(counted)
                    if number != int(number) or number < 0:
                        raise Refused(f"a list of {number}")
                    values = [source.value(kind) for _ in range(int(number))]
                    if any(value != int(value) for value in values if what.startswith("vertex_i")):
                        raise Refused("a corner that is no whole number")
                    if name == "face" and what in ("vertex_indices", "vertex_index"):
                        mesh.add([int(value) for value in values])
                    elif name == "tristrips" and what in ("vertex_indices", "vertex_index"):
                        read_strip(mesh, values)
                elif name == "vertex" and what in ("x", "y", "z"):
                    place[what] = source.single(kind)
                else:
                    source.value(kind)
            if name == "vertex":
                mesh.positions.append((place["x"], place["y"], place["z"]))
    if source.rest():
        raise Refused(f"{source.rest()} more than the header says")
    return mesh.checked()


# ---- OBJ ---------------------------------------------------------------


def read_obj(data):
    mesh = Mesh()
    text = re.sub(r"\\\r?\n", " ", data.decode("latin-1"))
    for line in re.split(r"\r\n|\n|\r", text):
        words = line.split("#")[0].split()
        if words and words[0] == "v":
            try:
                mesh.positions.append(tuple(bits_of_text(word) for word in words[1:4]))
            except ValueError:
                raise Refused(f"'{line}'") from None
            if len(words) < 4:
                raise Refused(f"'{line}'")
        elif words and words[0] == "f":
            numbers = [int(word.split("/")[0]) for word in words[1:]]
            if 0 in numbers:
                raise Refused("corner 0")
            mesh.add([n - 1 if n > 0 else len(mesh.positions) + n for n in numbers])
    return mesh.checked()


# ---- STL ---------------------------------------------------------------


def add_loop(mesh, corners):
    first = len(mesh.positions)
    mesh.positions += corners
    mesh.add(list(range(first, first + len(corners))))


def read_binary_stl(data):
    """Where the count and the size disagree, the size counts; one program writes all of it
    big-endian."""
    whole, rest = divmod(len(data) - 84, 50)
    if rest:
        raise Refused(f"{rest} bytes of a triangle")
    little, big = struct.unpack_from("<I", data, 80)[0], struct.unpack_from(">I", data, 80)[0]
    order = ">" if little != whole == big else "<"
    mesh = Mesh()
    for at in range(84, len(data), 50):
        words = struct.unpack_from(order + "12xIIIIIIIII", data, at)
        add_loop(mesh, [words[0:3], words[3:6], words[6:9]])
    return mesh


def read_ascii_stl(data):
    mesh = Mesh()
    corners = []
    for line in re.split(r"[\r\n]+", data.decode("latin-1")):
        words = line.lower().split()
        if not words:
            continue
        if words[0] == "vertex":
            try:
                corners.append(tuple(bits_of_text(word) for word in words[1:4]))
            except ValueError:
                raise Refused(f"'{line}'") from None
        elif words[0] == "endloop":
            add_loop(mesh, corners)
            corners = []
        elif words[0] not in ("solid", "endsolid", "facet", "endfacet", "outer"):
            raise Refused(f"'{words[0]}'")
    if corners:
        raise Refused("ends inside a loop")
    last = data.rstrip().rsplit(b"\n", 1)[-1]
    mesh.is_ended = last.strip().lower().startswith(b"endsolid")
    return mesh


def read_stl(data):
    """ASCII begins with solid and has a facet or an endsolid soon after; so have some headers
    of binary files, whose size then is what their count asks for."""
    counted = struct.unpack_from("<I", data, 80)[0] if len(data) >= 84 else None
    if counted is not None and len(data) == 84 + 50 * counted:
        return read_binary_stl(data)
    start = data[:1024].lower()
    if start.lstrip().startswith(b"solid") and b"\0" not in start:
        return read_ascii_stl(data)
    if counted is None:
        raise Refused("shorter than a header")
    return read_binary_stl(data)


def read(path):
    with open(path, "rb") as file:
        data = file.read()
    if path.endswith(".ply"):
        return read_ply(data)
    return read_obj(data) if path.endswith(".obj") else read_stl(data)
