"""Makes the font files in assets/fonts from their packages; the README there says how to run it."""

import sys
from copy import deepcopy
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
# Powers and indices that texts and tables write as characters. What a face lacks comes from the mathematics, where the rest are drawn.
SCRIPTS = "2B0,2B2,2B3,2B7,2B8,2E1-2E3,1D43,1D47-1D49,1D4D,1D4F,1D50,1D52,1D56-1D58,1D5B,2070,2071,2074-207F,2080-208E"
GREEK = "391-3A9,3B1-3C9"
BOXES = "2500-257F"
MATHEMATICS = (
    "20-7E,A0-FF,131,237,2C6,2C7,2D8-2DD,300-30C,327,332,338,391-3A9,3B1-3C9,3D1,3D2,3D5,3D6,3F0,3F1,3F4,3F5,"
    "2002-200B,2010,2013,2014,2016,2018,2019,201C,201D,2020-2022,2026,202F,2032-2037,203E,2044,2057,2061-2064,"
    "2070,2071,2074-207F,2080-208E,20D0,20D1,20D6,20D7,20DB,20DC,2102-2138,213C-2140,2190-21A6,21A9-21B1,21BC-21CC,21D0-21DD,2200-22A5,"
    "22A8-22AE,22B2-22BB,22C0-22C8,22CA-22CE,22D0,22D1,22D6-22DB,22E2-22E9,22EE-22F1,2308-230B,2322,2323,"
    "239B-23B5,23D0,23DC-23E1,25A0,25A1,25B2-25BD,25C6,25C7,25CB,25CF,25EF,2605,2606,2660-2667,2713,27C2,"
    "27E6-27EF,27F5-27FC,2983-2986,29EB,2A00-2A06,2A0C,2A2F,2A3F,2A7D,2A7E,2A85-2A8C,2A95,2A96,2AA1,2AA2,2AAF,"
    "2AB0,1D400-1D7FF"
)
TEXT_FEATURES = ["kern", "liga", "ccmp", "locl", "mark", "mkmk", "lnum", "pnum", "tnum", "case", "sups"]
# Letters of indices, which none of the faces has, and how their italic forms are drawn for them.
INDICES = {0x2090: "a", 0x2091: "e", 0x2092: "o", 0x2093: "x", 0x2096: "k", 0x2097: "l", 0x2098: "m", 0x2099: "n", 0x209A: "p", 0x209B: "s",
           0x209C: "t", 0x1D62: "i", 0x1D63: "r", 0x1D64: "u", 0x1D65: "v", 0x2C7C: "j"}
INDEX_SCALE, INDEX_DROP = 0.64, 170
# How high the lowest radical sign is, of the one that the font has: as a capital and what is above it.
LOW_SIGN = 0.85
PRIMES = [0x2032, 0x2033, 0x2034, 0x2035, 0x2036, 0x2037, 0x2057]


def image(font, name, matrix):
    """The outline of a glyph under an affine map."""
    outline, pen = DecomposingRecordingPen(font.getGlyphSet()), TTGlyphPen(None)
    font.getGlyphSet()[name].draw(outline)
    outline.replay(TransformPen(pen, matrix))
    return pen.glyph()


def redraw(font, name, matrix):
    """Replaces a glyph by its image; its advance follows the horizontal scale."""
    advance, bearing = font["hmtx"][name]
    font["glyf"][name] = image(font, name, matrix)
    font["hmtx"][name] = (round(advance * matrix[0]), round(bearing * matrix[0]))


def add(font, name, code, glyph, metrics):
    """Adds a glyph, behind all others, and maps a character to it."""
    font.setGlyphOrder([*font.getGlyphOrder(), name])
    font["glyf"].glyphs[name] = glyph
    font["glyf"].setGlyphOrder(font.getGlyphOrder())
    font["hmtx"][name] = metrics
    for table in font["cmap"].tables:
        if table.isUnicode():
            table.cmap[code] = name


def draw_indices(font):
    """Adds the letters of indices: italic letters of formulas, smaller and lower."""
    cmap = font.getBestCmap()
    for code, letter in INDICES.items():
        source = cmap[0x1D44E + ord(letter) - ord("a")]
        glyph = image(font, source, (INDEX_SCALE, 0, 0, INDEX_SCALE, 0, -INDEX_DROP))
        advance, bearing = font["hmtx"][source]
        add(font, f"uni{code:04X}", code, glyph, (round(advance * INDEX_SCALE), round(bearing * INDEX_SCALE)))


def fit_browsers(font):
    """Mends what browsers make of the font where TeX would do better."""
    draw_indices(font)
    constants, cmap = font["MATH"].table.MathConstants, font.getBestCmap()
    # Superscripts of brackets stand as high as those of letters, and subscripts of letters that descend as low as those of others.
    constants.SuperscriptBaselineDropMax.Value = 386
    constants.SubscriptBaselineDropMin.Value = -30
    # Fractions within lines are close about their bar, since the lines are to keep their distance.
    constants.FractionNumeratorShiftUp.Value, constants.FractionDenominatorShiftDown.Value = 405, 355
    # Primes are set as superscripts, and script forms are not chosen: they shall come out at their proper size and height.
    scale = 100 / constants.ScriptPercentScaleDown
    for code in PRIMES:
        redraw(font, cmap[code], (scale, 0, 0, scale, 0, -constants.SuperscriptShiftUp.Value * scale))
    draw_roots(font)


def draw_roots(font):
    """Radical signs for browsers: nearly of one width, and one that is lower than the lowest."""
    cmap, constants, variants = font.getBestCmap(), font["MATH"].table.MathConstants, font["MATH"].table.MathVariants
    sign, low = cmap[0x221A], "radical.low"
    signs = dict(zip(variants.VertGlyphCoverage.glyphs, variants.VertGlyphConstruction))
    construction = signs.pop(sign)
    # Every root is given the room of the widest radical sign.
    larger = {record.VariantGlyph for record in construction.MathGlyphVariantRecord} | {part.glyph for part in construction.GlyphAssembly.PartRecords}
    for name in sorted({sign, *larger}):
        width = 840 if name == sign else 900
        redraw(font, name, (width / font["hmtx"][name][0], 0, 0, 1, 0, 0))
    # What a sign is too high TeX shares between the gap and the foot; browsers let all of it hang below the line.
    constants.RadicalVerticalGap.Value = 100
    add(font, low, 0x221A, image(font, sign, (1, 0, 0, LOW_SIGN, 0, 0)), font["hmtx"][sign])
    lowest = deepcopy(construction.MathGlyphVariantRecord[0])
    lowest.VariantGlyph, lowest.AdvanceMeasurement = low, round(LOW_SIGN * lowest.AdvanceMeasurement)
    construction.MathGlyphVariantRecord.insert(0, lowest)
    # In the order of the glyphs, of which this is the last.
    signs[low] = construction
    variants.VertGlyphCoverage.glyphs, variants.VertGlyphConstruction = list(signs), list(signs.values())


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
    make(serif / "VAR/SourceSerif4Variable-Roman.ttf", here / "serif.woff2", "Workbook Serif", LATIN + "," + SCRIPTS, TEXT_FEATURES, {"wght": weights, "opsz": (10, 40)})
    make(serif / "VAR/SourceSerif4Variable-Italic.ttf", here / "serif-italic.woff2", "Workbook Serif", LATIN + "," + SCRIPTS, TEXT_FEATURES, {"wght": weights, "opsz": 16})
    make(sans / "VF/SourceSans3VF-Upright.ttf", here / "sans.woff2", "Workbook Sans", LATIN + "," + GREEK + "," + SCRIPTS, TEXT_FEATURES, {"wght": weights})
    make(mono / "VF/SourceCodeVF-Upright.ttf", here / "mono.woff2", "Workbook Mono", LATIN + "," + BOXES, ["ccmp", "mark", "zero"], {"wght": weights})
    make(mathematics / "files/stix-two-math-latin-400-normal.woff2", here / "math.woff2", "Workbook Math", MATHEMATICS, ["ccmp", "locl"], change=fit_browsers)


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(__file__).resolve().parent / "assets" / "fonts")
