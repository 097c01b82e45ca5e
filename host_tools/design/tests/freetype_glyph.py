"""Glyphs as FreeType draws them, without hints."""
import freetype

OUTLINE_OVERLAP = 0x40  # FT_OUTLINE_OVERLAP, which the bindings lack


def picture(face, glyph):
    """Greys of a glyph by their place: x to the right, y down."""
    face.load_glyph(glyph, freetype.FT_LOAD_NO_HINTING)
    slot = face.glyph
    # FreeType supersamples glyphs that are marked as overlapping; ours marks
    # composites that do, ufo2ft none.
    slot.outline._FT_Outline.flags &= ~OUTLINE_OVERLAP
    slot.render(freetype.FT_RENDER_MODE_NORMAL)
    bitmap = slot.bitmap
    return {(slot.bitmap_left + i % bitmap.pitch, i // bitmap.pitch -
             slot.bitmap_top): grey for i, grey in enumerate(bitmap.buffer)}


def worst_difference(a, b):
    return max((abs(a.get(place, 0) - b.get(place, 0))
                for place in a.keys() | b.keys()), default=0)
