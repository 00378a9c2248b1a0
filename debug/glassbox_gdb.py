# Glassbox's records as gdb prints them, and commands that stop at one triangle or one pixel (docs/debugging.md):
#
#   (gdb) source debug/glassbox_gdb.py
#
# One printer for each record, in the order of base/spaces.h, pipeline/stages.h and raster/stages.h. A printer is called
# with the value of a record and has to_string(), a text, or children(), what belongs to it, or both. Floats and doubles
# are written with the fewest digits that read back as the same number: what you see is what is there.
import struct

import gdb
import gdb.printing
import gdb.types

# ---- numbers, names, arrays ----


def number(value):
    kind = gdb.types.get_basic_type(value.type)
    if kind.code != gdb.TYPE_CODE_FLT:
        return str(int(value))
    exact = float(value)
    layout = "f" if kind.sizeof == 4 else "d"
    for digits in range(1, 18):
        text = f"{exact:.{digits}g}"
        if struct.pack(layout, float(text)) == struct.pack(layout, exact):
            return text
    return str(exact)  # NaN with a payload


def numbers(values):
    return "(" + ", ".join(number(value) for value in values) + ")"


def fields(record):
    """Names and values, the numbers among them written out."""
    for field in gdb.types.get_basic_type(record.type).fields():
        value = record[field.name]
        yield field.name, number(value) if value.type.code == gdb.TYPE_CODE_FLT else value


def coordinates(record):
    return numbers(record[field.name] for field in gdb.types.get_basic_type(record.type).fields())


def parameter(record, index):
    """A type that a template was made for, without its namespace: "Eye" of Point<Eye, float>."""
    return str(gdb.types.get_basic_type(record.type).template_argument(index)).replace("glassbox::", "")


def elements(array):
    """Of a std::array or a std::span."""
    kind = gdb.types.get_basic_type(array.type)
    if kind.name.startswith("std::span<"):
        return [array["_M_ptr"][i] for i in range(int(array["_M_extent"]["_M_extent_value"]))]
    return [array["_M_elems"][i] for i in range(int(kind.template_argument(1)))]


def polynomial(*terms):
    """polynomial((2, "x"), (-1, "y"), (0, "z")) is "2 x - y"."""
    text = ""
    for coefficient, unknown in terms:
        if coefficient == 0:
            continue
        size = number(coefficient).lstrip("-")
        factors = [size] if unknown == "" else [unknown] if size == "1" else [size, unknown]
        sign = "-" if coefficient < 0 else "+"
        text += (f" {sign} " if text else sign.strip("+")) + " ".join(factors)
    return text or "0"


class RecordPrinter:
    def __init__(self, record):
        self.record = record


class StdArrayPrinter(RecordPrinter):
    def __init__(self, record):
        super().__init__(record)
        self.elements = elements(record)
        kind = gdb.types.get_basic_type(record.type).template_argument(0)
        self.of_numbers = kind.strip_typedefs().code in (gdb.TYPE_CODE_FLT, gdb.TYPE_CODE_INT)

    def to_string(self):
        return numbers(self.elements) if self.of_numbers else None

    def children(self):
        if not self.of_numbers:
            for i, element in enumerate(self.elements):
                yield f"[{i}]", element


# ---- base/spaces.h ----


class PointPrinter(RecordPrinter):
    def to_string(self):
        return f"{parameter(self.record, 0)} {coordinates(self.record)}"


class VectorPrinter(RecordPrinter):
    def to_string(self):
        return f"{parameter(self.record, 0)} vector {coordinates(self.record)}"


class NormalPrinter(RecordPrinter):
    def to_string(self):
        return f"{parameter(self.record, 0)} normal {coordinates(self.record)}"


class TransformPrinter(RecordPrinter):
    """Rows under the name of the spaces, as on paper; a NormalTransform has three."""

    axes = "xyzw"

    def to_string(self):
        columns = self.record["columns"]["value"]
        size = len(self.axes)
        table = [[number(columns[column][row]) for column in range(size)] for row in self.axes]
        widths = [max(len(row[column]) for row in table) for column in range(size)]
        text = f"{parameter(self.record, 0)}<-{parameter(self.record, 1)}"
        for row in table:
            text += "\n  [ " + "  ".join(n.rjust(width) for n, width in zip(row, widths)) + " ]"
        return text


class NormalTransformPrinter(TransformPrinter):
    axes = "xyz"


# ---- pipeline/stages.h ----


class ClipVertexPrinter(RecordPrinter):
    def to_string(self):
        weights = numbers(elements(self.record["weights"]))
        return f"{self.record['position']}, weights {weights}"


class ClipPlanePrinter(RecordPrinter):
    def to_string(self):
        plane = self.record
        terms = [(plane["a"], "x"), (plane["b"], "y"), (plane["c"], "z"), (plane["d"], "w"), (plane["e"], "")]
        return f"{plane['name'].string()}: {polynomial(*terms)} >= 0"


class OutcodePrinter(RecordPrinter):
    """Which plane a bit stands for is known where the planes are, as in outcode() and in prepare_triangle()."""

    def to_string(self):
        code = int(self.record)
        if code == 0:
            return "inside all planes"
        if code & 0x80000000:
            return "not finite"
        bits = [bit for bit in range(31) if code >> bit & 1]
        names = self.names_of_planes()
        return "outside " + ", ".join(names[bit] if bit < len(names) else f"plane {bit}" for bit in bits)

    def names_of_planes(self):
        for place in ("planes", "stage.planes"):
            try:
                return [plane["name"].string() for plane in elements(gdb.parse_and_eval(place))]
            except (gdb.error, RuntimeError):  # no such variable here, or it is something else
                continue
        return []


class ClipPolygonPrinter(RecordPrinter):
    """The vertices that there are; the rest of the array is of no meaning."""

    def to_string(self):
        return f"polygon of {int(self.record['count'])} vertices"

    def children(self):
        for i in range(int(self.record["count"])):
            yield f"[{i}]", elements(self.record["vertices"])[i]


class DividedVertexPrinter(RecordPrinter):
    """NdcVertex and ScreenVertex: the position says which."""

    def to_string(self):
        return f"{self.record['position']}, 1/w {number(self.record['inverse_w'])}"


# ---- raster/stages.h ----


class SnappedVertexPrinter(RecordPrinter):
    def to_string(self):
        x, y = (f"{n // 256} + {n % 256}/256" for n in (int(self.record["x"]), int(self.record["y"])))
        return f"({x}, {y})"


class PixelRectPrinter(RecordPrinter):
    def to_string(self):
        x0, y0, x1, y1 = (int(self.record[name]) for name in ("x0", "y0", "x1", "y1"))
        return f"{x0} <= x < {x1}, {y0} <= y < {y1}"


class EdgeFunctionPrinter(RecordPrinter):
    def to_string(self):
        edge = self.record
        side = "top or left" if edge["owns_zero"] else "bottom or right"
        return f"{polynomial((edge['a'], 'x'), (edge['b'], 'y'), (edge['c'], ''))} ({side})"


class TriangleSetupPrinter(RecordPrinter):
    def to_string(self):
        area = int(self.record["double_area"]) / 2 / 65536
        winding = "clockwise" if self.record["clockwise"] else "counter-clockwise"
        return f"{area:.9g} square pixels, {winding} on the screen"

    def children(self):
        return fields(self.record)


class CoveragePrinter(RecordPrinter):
    def to_string(self):
        pixel = self.record
        return f"{numbers([pixel['x'], pixel['y']])}, edges {numbers(elements(pixel['edges']))}"


class FragmentPrinter(RecordPrinter):
    def to_string(self):
        return f"pixel {numbers([self.record['x'], self.record['y']])}"

    def children(self):
        return ((name, value) for name, value in fields(self.record) if name not in ("x", "y"))


class ColorPrinter(RecordPrinter):
    """Rgba, linear floats, and Rgba8, bytes as stored."""

    def to_string(self):
        name = gdb.types.get_basic_type(self.record.type).name.replace("glassbox::", "")
        return f"{name} {coordinates(self.record)}"


class ImagePrinter(RecordPrinter):
    def to_string(self):
        width, height = int(self.record["width"]), int(self.record["height"])
        return f"{width} x {height} image of {parameter(self.record, 0)}"


# ---- which printer for which type (gdb's own way is right for Varyings: its arrays have a printer) ----

PRINTERS = {
    "std::array": StdArrayPrinter,
    "glassbox::Point": PointPrinter,
    "glassbox::Vector": VectorPrinter,
    "glassbox::Normal": NormalPrinter,
    "glassbox::Transform": TransformPrinter,
    "glassbox::NormalTransform": NormalTransformPrinter,
    "glassbox::ClipVertex": ClipVertexPrinter,
    "glassbox::ClipPlane": ClipPlanePrinter,
    "glassbox::ClipPolygon": ClipPolygonPrinter,
    "glassbox::NdcVertex": DividedVertexPrinter,
    "glassbox::ScreenVertex": DividedVertexPrinter,
    "glassbox::SnappedVertex": SnappedVertexPrinter,
    "glassbox::PixelRect": PixelRectPrinter,
    "glassbox::EdgeFunction": EdgeFunctionPrinter,
    "glassbox::TriangleSetup": TriangleSetupPrinter,
    "glassbox::Coverage": CoveragePrinter,
    "glassbox::Fragment": FragmentPrinter,
    "glassbox::Rgba": ColorPrinter,
    "glassbox::Rgba8": ColorPrinter,
    "glassbox::Image": ImagePrinter,
}


def glassbox(value):
    """Called by gdb with every value that it prints."""
    kind = value.type.target() if value.type.code == gdb.TYPE_CODE_REF else value.type
    if kind.unqualified().name == "glassbox::Outcode":  # a name for an integer
        return OutcodePrinter(value)
    name = gdb.types.get_basic_type(kind).name or ""
    printer = PRINTERS.get(name.split("<")[0])
    return printer(value) if printer else None


gdb.printing.register_pretty_printer(None, glassbox, replace=True)
gdb.execute("set print pretty on")  # one line for each child
# `step` goes into Glassbox's own functions.
gdb.execute("skip -rfunction ^(std|glm|tl|__gnu_cxx)::|::Stopwatch::", to_string=True)


# ---- commands ----


class TileEngineNotice(gdb.Breakpoint):
    """Stops nothing: says once a run that the tile engine draws it."""

    FUNCTION = "glassbox::TileEngine::render"

    def __init__(self):
        super().__init__(self.FUNCTION, internal=True)
        self.silent = True
        self.told = None

    def stop(self):
        process = gdb.selected_inferior().pid
        if self.told != process:
            self.told = process
            gdb.write(TILE_ENGINE)
        return False


TILE_ENGINE = (
    "glassbox: the tile engine draws this run, many triangles and pixels at a time, and may never stop here. "
    "Run it with --engine staged.\n"
)
tile_engine_notice = None


def watch_for_tile_engine():
    """What glassbox-triangle and glassbox-pixel stop in are stages of the staged engine."""
    global tile_engine_notice
    if tile_engine_notice is None or not tile_engine_notice.is_valid():
        tile_engine_notice = TileEngineNotice()


def whole_numbers(text, count, usage):
    words = gdb.string_to_argv(text)
    if len(words) != count or not all(word.isdecimal() for word in words):
        raise gdb.GdbError(f"usage: {usage}")
    return [int(word) for word in words]


class StopAtTriangle(gdb.Command):
    """glassbox-triangle N: stop where triangle N is made ready (clip to cull), and where it is rasterised.
Triangles are numbered through the whole scene, as `glassbox pixel` and --id-out number them."""

    def __init__(self):
        super().__init__("glassbox-triangle", gdb.COMMAND_BREAKPOINTS)

    def invoke(self, text, from_tty):
        (n,) = whole_numbers(text, 1, "glassbox-triangle N")
        watch_for_tile_engine()
        gdb.execute(
            "break glassbox::prepare_triangle<glassbox::CountingWatch>"
            f" if stage.draw.first_number + triangle.number == {n}"
        )
        gdb.execute(
            "break glassbox::rasterise<glassbox::CountingWatch>(glassbox::FragmentStage const&,"
            f" glassbox::CountingWatch const&, glassbox::ReadyTriangle const&) if triangle.number == {n}"
        )


def break_in_body(function, condition):
    """Stops in the function's first line after its head. At the head itself the parameters may not be there yet: gdb skips
    no prologue in objects that have location lists."""
    (head,) = gdb.decode_line(function)[1]
    after = min(entry.line for entry in head.symtab.linetable() if entry.line > head.line)
    gdb.execute(f"break -source {head.symtab.filename} -line {after} if {condition}")


class StopAtPixel(gdb.Command):
    """glassbox-pixel X Y: stop wherever a triangle, line or point covers the pixel, before its depth test."""

    def __init__(self):
        super().__init__("glassbox-pixel", gdb.COMMAND_BREAKPOINTS)

    def invoke(self, text, from_tty):
        x, y = whole_numbers(text, 2, "glassbox-pixel X Y")
        watch_for_tile_engine()
        here = f"pixel.x == {x} && pixel.y == {y}"
        break_in_body("glassbox::interpolate(glassbox::TriangleSetup const&, glassbox::Coverage const&)", here)
        break_in_body(
            "glassbox::interpolate(std::array<glassbox::ScreenVertex, 2ul> const&, glassbox::LinePixel const&)", here
        )
        break_in_body(
            "glassbox::point_pixel(glassbox::SnappedVertex const&)",
            f"(point.x - 1) >> 8 == {x} && (point.y - 1) >> 8 == {y}",
        )


StopAtTriangle()
StopAtPixel()
