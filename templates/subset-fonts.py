"""Makes the font files in assets/fonts from their packages; the README there says how to run it."""

import sys
from io import BytesIO
from pathlib import Path

from fontTools import subset
from fontTools.pens.recordingPen import DecomposingRecordingPen
from fontTools.pens.transformPen import TransformPen
from fontTools.pens.ttGlyphPen import TTGlyphPen
from fontTools.ttLib import TTFont
from fontTools.varLib import instancer

LATIN = (
    "20-7E,A0-FF,100-17F,192,218-21B,2C6,2C7,2D8-2DD,2009,200A,2010-2015,2018-201E,2020-2022,2026,202F,2030,"
    "2032,2033,2039,203A,2044,20AC,2122,2190-2193,2212"
)
GREEK = "391-3A9,3B1-3C9"
BOXES = "2500-257F"
MATHEMATICS = (
    "20-7E,A0-FF,131,237,2C6,2C7,2D8-2DD,300-30C,327,332,338,391-3A9,3B1-3C9,3D1,3D2,3D5,3D6,3F0,3F1,3F4,3F5,"
    "2002-200B,2010,2013,2014,2016,2018,2019,201C,201D,2020-2022,2026,202F,2032-2037,203E,2044,2057,2061-2064,"
    "20D0,20D1,20D6,20D7,20DB,20DC,2102-2138,213C-2140,2190-21A6,21A9-21B1,21BC-21CC,21D0-21DD,2200-22A5,"
    "22A8-22AE,22B2-22BB,22C0-22C8,22CA-22CE,22D0,22D1,22D6-22DB,22E2-22E9,22EE-22F1,2308-230B,2322,2323,"
    "239B-23B5,23D0,23DC-23E1,25A0,25A1,25B2-25BD,25C6,25C7,25CB,25CF,25EF,2605,2606,2660-2667,2713,27C2,"
    "27E6-27EF,27F5-27FC,2983-2986,29EB,2A00-2A06,2A0C,2A2F,2A3F,2A7D,2A7E,2A85-2A8C,2A95,2A96,2AA1,2AA2,2AAF,"
    "2AB0,1D400-1D7FF"
)
TEXT_FEATURES = ["kern", "liga", "ccmp", "locl", "mark", "mkmk", "lnum", "pnum", "tnum", "case", "sups"]
PRIMES = [0x2032, 0x2033, 0x2034, 0x2035, 0x2036, 0x2037, 0x2057]


def redraw(font, name, matrix):
    """Replaces a glyph by its image under an affine map; its advance follows the horizontal scale."""
    outline = DecomposingRecordingPen(font.getGlyphSet())
    font.getGlyphSet()[name].draw(outline)
    pen = TTGlyphPen(None)
    outline.replay(TransformPen(pen, matrix))
    advance, bearing = font["hmtx"][name]
    font["glyf"][name] = pen.glyph()
    font["hmtx"][name] = (round(advance * matrix[0]), round(bearing * matrix[0]))


def fit_browsers(font):
    """Mends what browsers make of the font where TeX would do better."""
    constants, cmap = font["MATH"].table.MathConstants, font.getBestCmap()
    # Superscripts of brackets stand as high as those of letters.
    constants.SuperscriptBaselineDropMax.Value = 386
    # Primes are set as superscripts, and script forms are not chosen: they shall come out at their proper size and height.
    scale = 100 / constants.ScriptPercentScaleDown
    for code in PRIMES:
        redraw(font, cmap[code], (scale, 0, 0, scale, 0, -constants.SuperscriptShiftUp.Value * scale))
    # Every root is given the room of the widest radical sign, so the signs shall be nearly of one width.
    variants = font["MATH"].table.MathVariants
    sign = cmap[0x221A]
    construction = variants.VertGlyphConstruction[variants.VertGlyphCoverage.glyphs.index(sign)]
    larger = [record.VariantGlyph for record in construction.MathGlyphVariantRecord]
    larger += [record.glyph for record in construction.GlyphAssembly.PartRecords]
    for name in sorted({sign, *larger}):
        width = 840 if name == sign else 900
        redraw(font, name, (width / font["hmtx"][name][0], 0, 0, 1, 0, 0))


def rename(font, family):
    """A changed font may not carry a reserved name."""
    for record in font["name"].names:
        new = {1: family, 3: family + " subset", 4: family, 6: family.replace(" ", ""), 16: family, 25: family.replace(" ", "")}.get(record.nameID)
        if new:
            record.string = new


def make(source, target, family, characters, features, axes=None, change=None):
    font = TTFont(source, recalcTimestamp=False)
    if axes:
        narrowed = BytesIO()
        instancer.instantiateVariableFont(font, axes).save(narrowed)
        font = TTFont(narrowed, recalcTimestamp=False)
    options = subset.Options()
    options.layout_features = features
    options.hinting = False
    options.notdef_outline = True
    options.flavor = "woff2"
    maker = subset.Subsetter(options)
    maker.populate(unicodes=subset.parse_unicodes(characters))
    maker.subset(font)
    if change:
        change(font)
    rename(font, family)
    font.flavor = "woff2"
    font.save(target)
    print(f"{target.name}: {target.stat().st_size} bytes")


def main(packages, here):
    serif, sans, mono, mathematics = (packages / name for name in ["source-serif", "source-sans", "source-code-pro", "stix-two-math"])
    weights = (400, 700)
    make(serif / "VAR/SourceSerif4Variable-Roman.ttf", here / "serif.woff2", "Workbook Serif", LATIN, TEXT_FEATURES, {"wght": weights, "opsz": (10, 40)})
    make(serif / "VAR/SourceSerif4Variable-Italic.ttf", here / "serif-italic.woff2", "Workbook Serif", LATIN, TEXT_FEATURES, {"wght": weights, "opsz": 16})
    make(sans / "VF/SourceSans3VF-Upright.ttf", here / "sans.woff2", "Workbook Sans", LATIN + "," + GREEK, TEXT_FEATURES, {"wght": weights})
    make(mono / "VF/SourceCodeVF-Upright.ttf", here / "mono.woff2", "Workbook Mono", LATIN + "," + BOXES, ["ccmp", "mark", "zero"], {"wght": weights})
    make(mathematics / "files/stix-two-math-latin-400-normal.woff2", here / "math.woff2", "Workbook Math", MATHEMATICS, ["ccmp", "locl"], change=fit_browsers)


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(__file__).resolve().parent / "assets" / "fonts")
