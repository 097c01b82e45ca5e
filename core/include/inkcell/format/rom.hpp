// Every offset and constant of the ROM font format, as docs/FORMAT.md states
// them. Shared by the reader and the generator; applications do not need it.
//
// Over 400 lines: one list of the whole format.
//
// All numbers are little endian. `u` is 1/1024 em.
#pragma once

#include <stdint.h>

#include "inkcell/cpp17.hpp"

namespace inkcell::format {

constexpr uint32_t tag(char a, char b, char c, char d) noexcept {
  return static_cast<uint32_t>(static_cast<uint8_t>(a)) |
         static_cast<uint32_t>(static_cast<uint8_t>(b)) << 8 |
         static_cast<uint32_t>(static_cast<uint8_t>(c)) << 16 |
         static_cast<uint32_t>(static_cast<uint8_t>(d)) << 24;
}

inline constexpr uint32_t kMagic = tag('I', 'N', 'K', 'C');

/// The font's first byte lies at a multiple of this. [bytes]
inline constexpr uint32_t kAlignment = 4;

// The header. The section directory follows it.
namespace header {
inline constexpr uint32_t kMagic = 0;          // u32
inline constexpr uint32_t kFormatMinor = 4;    // u8
inline constexpr uint32_t kFormatMajor = 5;    // u8
inline constexpr uint32_t kHeaderBytes = 6;    // u16, with directory
inline constexpr uint32_t kTotalBytes = 8;     // u32
inline constexpr uint32_t kHeaderCrc = 12;     // u32, header but this field
inline constexpr uint32_t kContentCrc = 16;    // u32, all after the header
inline constexpr uint32_t kGlyphCount = 20;    // u16, at least 1
inline constexpr uint32_t kUnitsPerEm = 22;    // u16, 4..16384
inline constexpr uint32_t kAscender = 24;      // i16 [font units]
inline constexpr uint32_t kDescender = 26;     // i16 [font units], below: < 0
inline constexpr uint32_t kLineGap = 28;       // i16 [font units]
inline constexpr uint32_t kXHeight = 30;       // i16 [font units]
inline constexpr uint32_t kCapHeight = 32;     // i16 [font units]
inline constexpr uint32_t kMinPx = 34;         // u16 [px/em]
inline constexpr uint32_t kMaxPx = 36;         // u16 [px/em]
inline constexpr uint32_t kTolerance = 38;     // u8 [1/255]
inline constexpr uint32_t kCoding = 39;        // u8, Coding
inline constexpr uint32_t kReserved0 = 40;     // u8, 0
inline constexpr uint32_t kPredicate = 41;     // u8, Predicate
inline constexpr uint32_t kSectionCount = 42;  // u16
inline constexpr uint32_t kMaxCells = 44;      // u16, of any glyph
inline constexpr uint32_t kMaxNodes = 46;      // u16, of any glyph
inline constexpr uint32_t kMaxDepth = 48;      // u8, of any tile
inline constexpr uint32_t kReserved1 = 49;     // u8, 0
inline constexpr uint32_t kBand = 50;          // u16 [u], field good up to here
inline constexpr uint32_t kXMin = 52;          // i16 [font units]
inline constexpr uint32_t kYMin = 54;          // i16 [font units]
inline constexpr uint32_t kXMax = 56;          // i16 [font units]
inline constexpr uint32_t kYMax = 58;          // i16 [font units]
// Outlines; 0 where the coding is one of cells.
inline constexpr uint32_t kGridShift = 60;  // i8, grid unit: 2^shift font units
inline constexpr uint32_t kCodeBits = 61;   // u8, the code table has 2^bits
inline constexpr uint32_t kMaxPoints = 62;  // u16, of any glyph
inline constexpr uint32_t kBytes = 64;
inline constexpr uint32_t kLeastUnitsPerEm = 4;
inline constexpr uint32_t kMostUnitsPerEm = 16384;
}  // namespace header

/// What a font's glyphs are made of.
enum class Coding : uint8_t {
  field = 0,    // cells of nine samples
  edges = 1,    // of earlier versions: refused
  outline = 2,  // outlines
  strike = 3,   // pictures of one size: GLYF holds strikes
};
enum class Predicate : uint8_t { size_aware = 0, fixed = 1 };

// An entry of the section directory.
namespace section {
inline constexpr uint32_t kTag = 0;     // u32
inline constexpr uint32_t kOffset = 4;  // u32 [bytes] from the font's start
inline constexpr uint32_t kSize = 8;    // u32 [bytes]
inline constexpr uint32_t kBytes = 12;

// Offsets are multiples of 4, which leaves two bits. The other one is 0.

/// A reader that does not know the section must refuse the font.
inline constexpr uint32_t kMustUnderstand = 1;
inline constexpr uint32_t kOffsetMask = ~uint32_t{3};

inline constexpr uint32_t kCmap = tag('C', 'M', 'A', 'P');
inline constexpr uint32_t kCodePages = tag('C', 'P', 'A', 'G');
inline constexpr uint32_t kMetrics = tag('M', 'E', 'T', 'R');
inline constexpr uint32_t kKerning = tag('K', 'E', 'R', 'N');
inline constexpr uint32_t kGlyphs = tag('G', 'L', 'Y', 'F');
inline constexpr uint32_t kCode = tag('C', 'O', 'D', 'E');
inline constexpr uint32_t kGrid = tag('G', 'R', 'I', 'D');
inline constexpr uint32_t kMorphs = tag('M', 'O', 'R', 'P');
inline constexpr uint32_t kStrikes = tag('S', 'T', 'R', 'K');
inline constexpr uint32_t kShaping = tag('S', 'H', 'A', 'P');
inline constexpr uint32_t kKeptLayout = tag('L', 'A', 'Y', 'T');
inline constexpr uint32_t kLayers = tag('C', 'O', 'L', 'R');
inline constexpr uint32_t kName = tag('N', 'A', 'M', 'E');
}  // namespace section

// An entry of CMAP: consecutive code points on consecutive glyphs. Sorted.
namespace cmap {
inline constexpr uint32_t kFirst = 0;       // u32, code point
inline constexpr uint32_t kExtra = 4;       // u16, code points after the first
inline constexpr uint32_t kFirstGlyph = 6;  // u16
inline constexpr uint32_t kBytes = 8;
}  // namespace cmap

// CPAG: code points on consecutive glyphs, by pages of 256. After the header
// the starts of the pages and an end, u16 from the section's start, then the
// low byte of each code point. Its glyph is the base plus its place, modulo
// 2^16.
namespace code_pages {
inline constexpr uint32_t kFirstPage = 0;  // u16
inline constexpr uint32_t kPages = 2;      // u16
inline constexpr uint32_t kGlyphBase = 4;  // u16
inline constexpr uint32_t kBytes = 6;
}  // namespace code_pages

// METR, KERN and GLYF hold bit tables: rows of numbers of stated widths without
// gaps, the first in the lowest bits of the first byte.
namespace bit_table {
inline constexpr uint32_t kMaxBits = 25;  // of a number: it spans four bytes
}  // namespace bit_table

// METR: after the header a bit table with a row for each glyph: advance, then
// x_min, y_min, x_max and y_max of the box of its ink. Only the rows of the
// first glyphs have an advance. A number is its column's base plus what the row
// holds, modulo 2^16: u16 for the advance, i16 for the others, all in font
// units.
namespace metrics {
inline constexpr uint32_t kColumns = 5;
inline constexpr uint32_t kBase = 0;         // u16 of each column
inline constexpr uint32_t kAdvances = 10;    // u16, rows with an advance
inline constexpr uint32_t kColumnBits = 12;  // u8 of each column, 0..16
inline constexpr uint32_t kBytes = 17;
inline constexpr uint32_t kMaxBits = 16;
}  // namespace metrics

// KERN: pairs of classes that kern, in rows of the same left class. After the
// header three bit tables, the next at the bit where one ends:
//   members     glyph, left class, right class; ascending by glyph. A glyph
//               that is not there has class 0 twice
//   row starts  left_classes + 1 numbers: the pairs of left class l are those
//               from number l - 1 to before number l
//   pairs       right class, value - value_base modulo 2^16; ascending by right
//               class within a row
// Class 0 kerns with nothing. Values are i16 in font units.
namespace kerning {
inline constexpr uint32_t kPairs = 0;         // u32, up to kMaxPairs
inline constexpr uint32_t kMembers = 4;       // u16
inline constexpr uint32_t kLeftClasses = 6;   // u16, without class 0
inline constexpr uint32_t kRightClasses = 8;  // u16, without class 0
inline constexpr uint32_t kValueBase = 10;    // i16
inline constexpr uint32_t kGlyphBits = 12;    // u8, 0..16
inline constexpr uint32_t kLeftBits = 13;     // u8, 0..16
inline constexpr uint32_t kRightBits = 14;    // u8, 0..16
inline constexpr uint32_t kValueBits = 15;    // u8, 0..16
inline constexpr uint32_t kStartBits = 16;    // u8, 0..25
inline constexpr uint32_t kBytes = 17;
inline constexpr uint32_t kMaxBits = 16;
inline constexpr uint32_t kMaxPairs = (1u << 22) - 1;
}  // namespace kerning

// GRID: how outlines are fitted to the grid of pixels. After the header the
// zones, then tables of code words. The hints of a glyph are the last bits of
// its record in GLYF, read from the last byte to the first, each byte from its
// lowest bit on: a head, [left inset, right inset], heights, ascending, and
// stems, from the left.
namespace grid {
inline constexpr uint32_t kZones = 0;      // u8, 0..8
inline constexpr uint32_t kFlags = 1;      // u8
inline constexpr uint32_t kStemWidth = 2;  // u8 [u], of most stems; 0: none
inline constexpr uint32_t kBarWidth = 3;   // u8 [u], of most bars; 0: none
inline constexpr uint32_t kXZone = 4;      // u8, zone of the x-height
inline constexpr uint32_t kCodeBits = 5;   // u8, 0..7
inline constexpr uint32_t kFirstY = 6;     // u8, before the first height
inline constexpr uint32_t kFirstX = 7;     // u8, before the first stem
inline constexpr uint32_t kBytes = 8;
inline constexpr uint32_t kMaxZones = 8;
inline constexpr uint32_t kMaxCodeBits = 7;

// Flags.
inline constexpr uint32_t kContrast = 1;  // bars are thinner than 3/4 stem
inline constexpr uint32_t kFewBars = 2;   // fewer than 1.1 bars a glyph

inline constexpr uint32_t kNoZone = 255;

// A zone.
inline constexpr uint32_t kZoneFlat = 0;       // i16 [u]
inline constexpr uint32_t kZoneOvershoot = 2;  // i8 [u], of round edges
inline constexpr uint32_t kZoneFlags = 3;      // u8
inline constexpr uint32_t kZoneBytes = 4;
inline constexpr uint32_t kTopZone = 1;  // ink is below it

// Tables of code words behind the zones, each of 2^code_bits u16. A word
// stands for the numbers from its base on that its extra bits count.
inline constexpr uint32_t kHeads = 0;
inline constexpr uint32_t kHeights = 1;
inline constexpr uint32_t kGapsY = 2;
inline constexpr uint32_t kWidthsY = 3;
inline constexpr uint32_t kGapsX = 4;
inline constexpr uint32_t kWidthsX = 5;
inline constexpr uint32_t kTables = 6;
inline constexpr uint32_t kLengthMask = 7;  // of the word, 0..7
inline constexpr uint32_t kExtraShift = 3;  // bits that follow, 0..15
inline constexpr uint32_t kExtraMask = 15;
inline constexpr uint32_t kBaseShift = 7;  // 0..511
inline constexpr uint32_t kMaxBase = 511;

// A head: how many heights and stems follow, and flags.
inline constexpr uint32_t kStemCountMask = 7;
inline constexpr uint32_t kHeightCountShift = 3;
inline constexpr uint32_t kHeightCountMask = 15;
inline constexpr uint32_t kHasInsets = 0x80;
inline constexpr uint32_t kSymmetric = 0x100;

// A height: its kind, which edge, its zone, and whether that edge is round.
inline constexpr uint32_t kRound = 1;
inline constexpr uint32_t kZoneShift = 1;  // 0: none, 1: zone 0
inline constexpr uint32_t kZoneMask = 15;
inline constexpr uint32_t kTop = 0x20;
inline constexpr uint32_t kKindShift = 6;
inline constexpr uint32_t kKindMask = 3;

// Kinds of heights.
inline constexpr uint32_t kBar = 0;
inline constexpr uint32_t kSerif = 1;
inline constexpr uint32_t kLoneEdge = 2;
inline constexpr uint32_t kFreeEnd = 3;

// Numbers.
inline constexpr int kInsetBits = 6;             // [2 u]
inline constexpr uint32_t kPositionMask = 1023;  // n: 2 n - 512 u
inline constexpr uint32_t kFirstShift = 2;       // of kFirstY and kFirstX
inline constexpr uint32_t kWidthMask = 127;      // [2 u]; 0: the usual one
inline constexpr int kPositionStep = 2;          // [u]
inline constexpr int kPositionBase = -512;       // [u]

/// Knots of a fitted map.
inline constexpr uint32_t kMaxKnots = 14;
}  // namespace grid

// GLYF: after the header a bit table of glyph_count + 1 offsets from the
// section's start, in units of 2^unit_log2 bytes; then the records. A glyph
// whose offset is that of the next has no ink.
namespace glyphs {
inline constexpr uint32_t kOffsetBits = 0;  // u8, 0..25
inline constexpr uint32_t kUnitLog2 = 1;    // u8, 0..7; at least 1 for cells
inline constexpr uint32_t kBytes = 2;
inline constexpr uint32_t kMaxUnitLog2 = 7;

/// Records of cells lie at multiples of this. [bytes]
inline constexpr uint32_t kRecordAlignment = 2;
}  // namespace glyphs

// CODE: the words of outlines: 1, 2, 4 or 8 tables of a u16 for each of
// 2^code_bits prefixes. A record begins with table 0; a word names what its
// table's number is XORed with for the next word.
namespace outline {
inline constexpr uint32_t kLengthMask = 7;  // of the word, 1..7
inline constexpr uint32_t kKindShift = 3;   // off curve, smooth, corner, end
inline constexpr uint32_t kKindMask = 3;
inline constexpr uint32_t kEndOfContour = 3;
inline constexpr uint32_t kXBitsShift = 5;  // bits of dx, two's complement
inline constexpr uint32_t kYBitsShift = 9;  // bits of dy
inline constexpr uint32_t kWidthMask = 15;
inline constexpr uint32_t kTableShift = 13;  // 0: the next word has this table
inline constexpr uint32_t kMaxTables = 8;
inline constexpr uint32_t kMaxCodeBits = 7;
inline constexpr uint32_t kLeastUnitsPerEm = 16;  // of the font
inline constexpr int32_t kMinGridShift = -4;
inline constexpr int32_t kMaxGridShift = 3;

/// In the first byte of a record of an outline; others have a type there.
inline constexpr uint8_t kRecordBit = 0x80;
}  // namespace outline

// MORP: how outlines of pairs of glyphs become each other. After the header a
// bit table with a row for each pair, ascending: first glyph, second glyph,
// offset of the record from the table's end, in bytes; then the records, which
// are read bit by bit like outlines.
namespace morphs {
inline constexpr uint32_t kPairs = 0;       // u16
inline constexpr uint32_t kGlyphBits = 2;   // u8, 0..16
inline constexpr uint32_t kOffsetBits = 3;  // u8, 0..25
inline constexpr uint32_t kMaxPoints = 4;   // u16, of any pair
inline constexpr uint32_t kMasters = 6;     // u16, the first; 0: there are none
inline constexpr uint32_t kBytes = 8;
inline constexpr uint32_t kMaxGlyphBits = 16;

// Widths of a record's numbers. [bits]
inline constexpr uint32_t kPointWidthBits = 4;  // the width of a point's number
inline constexpr uint32_t kKindBits = 2;
inline constexpr uint32_t kPieceCountBits = 7;
inline constexpr uint32_t kEighthBits = 3;
inline constexpr uint32_t kBirthBits = 4;  // 16ths of the progress
inline constexpr uint32_t kSwellBits = 3;  // quarters of the size

// Kinds of contours.
inline constexpr uint32_t kEnd = 0;         // there are no more
inline constexpr uint32_t kBoth = 1;        // both glyphs have it
inline constexpr uint32_t kSecondOnly = 2;  // it is born at a point
inline constexpr uint32_t kFirstOnly = 3;   // it dies at a point
}  // namespace morphs

// A glyph record that refers to others, bit by bit after its type.
namespace composite {
inline constexpr uint8_t kType = 3;
inline constexpr uint32_t kTypeBytes = 1;
}  // namespace composite

// A glyph record of cells of nine samples.
namespace glyph {
inline constexpr uint32_t kType = 0;        // u8, kTypeSamples
inline constexpr uint32_t kTileLog2 = 1;    // u8, 0..11: tiles of 1..2048 u
inline constexpr uint32_t kX0 = 2;          // i16 [u], left edge of the grid
inline constexpr uint32_t kY0 = 4;          // i16 [u], lower edge, y up
inline constexpr uint32_t kTilesX = 6;      // u8
inline constexpr uint32_t kTilesY = 7;      // u8
inline constexpr uint32_t kNodeCount = 8;   // u16
inline constexpr uint32_t kCellCount = 10;  // u16
inline constexpr uint32_t kBytes = 12;
// then u16 references: one a tile (row by row from below), four a node
// (child 2 * upper + right); then the cells.

inline constexpr uint8_t kTypeSamples = 1;
inline constexpr uint32_t kMaxTileLog2 = 11;

/// Grids lie within this of the origin in both directions. [u] Twice as much,
/// in the corner of the box around a grid turned by 45 degrees, must stay
/// within positions of Q16.16 u, with a few pixels to spare.
inline constexpr int32_t kGridLimit = 15360;

// A reference.
inline constexpr uint16_t kOutside = 0;
inline constexpr uint16_t kInside = 1;
inline constexpr uint16_t kFirstNode = 2;      // node n is kFirstNode + n
inline constexpr uint16_t kCellFlag = 0x8000;  // cell n is kCellFlag | n
inline constexpr uint32_t kMaxNodes = 0x7ffe;
inline constexpr uint32_t kMaxCells = 0x8000;
}  // namespace glyph

// A cell of nine samples: the distance at its centre, then eight offsets from
// it, i8, in cell size / 128: lower left, lower middle, lower right, middle
// left, middle right, upper left, upper middle, upper right (the paper's d1,
// d2, d3, d4, d6, d7, d8, d9).
namespace samples {
inline constexpr uint32_t kCentre = 0;  // i16, Q10.6 u
inline constexpr uint32_t kOffsets = 2;
inline constexpr uint32_t kBytes = 10;
inline constexpr int kCentreFraction = 6;
inline constexpr int kQuantaLog2 = 7;  // 128 quanta to the cell size
}  // namespace samples

// STRK, and GLYF of fonts of strikes: after the header an entry for each
// strike, then bit tables with the rows of their glyphs, left, top, width,
// height and offset, and pictures. Rows of fonts of strikes have an offset
// alone: METR has the boxes.
namespace strikes {
inline constexpr uint32_t kZero = 0;   // u16, 0: offset_bits of GLYF
inline constexpr uint32_t kCount = 2;  // u16
inline constexpr uint32_t kBytes = 4;
inline constexpr uint32_t kMaxSide = 255;  // of a picture [px]
}  // namespace strikes

// What the pictures of a strike were made with.
enum class StrikeFit : uint8_t { none = 0, heights = 1, both = 2, source = 3 };

// An entry of STRK. Its first word says what it serves: size, bits and fit.
namespace strike {
inline constexpr uint32_t kPx = 0;      // u16 [px/em]
inline constexpr uint32_t kBits = 2;    // u8 of a pixel: 1, 2 or 4
inline constexpr uint32_t kFit = 3;     // u8, StrikeFit
inline constexpr uint32_t kFirst = 4;   // u16, glyph
inline constexpr uint32_t kGlyphs = 6;  // u16
inline constexpr uint32_t kCoding = 8;  // u8, 0
inline constexpr uint32_t kColumns = 5;
inline constexpr uint32_t kColumnBits = 9;  // u8 of each column
inline constexpr uint32_t kLeftBase = 14;   // i8 [px]
inline constexpr uint32_t kTopBase = 15;    // i8 [px]
inline constexpr uint32_t kStep = 16;       // u16 [bytes, Q8.8]
inline constexpr uint32_t kReserved = 18;   // u16, 0
inline constexpr uint32_t kGuesses = 20;    // u32, of 2 and 4 bits
inline constexpr uint32_t kBoxes = 24;  // u32 [bytes] from the section's start
inline constexpr uint32_t kPictures = 28;  // u32, likewise, modulo 2^32
inline constexpr uint32_t kBytes = 32;
}  // namespace strike

// SHAP: how text of some scripts is shaped. After the header one run of bit
// tables, in the order of docs/FORMAT.md.
namespace shaping {
inline constexpr uint32_t kLookups = 0;       // u16
inline constexpr uint32_t kTopLookups = 2;    // u16, the first ones
inline constexpr uint32_t kSets = 4;          // u16
inline constexpr uint32_t kRows = 6;          // u16, 1..256
inline constexpr uint32_t kCompositions = 8;  // u16
inline constexpr uint32_t kCharacters = 10;   // u16
inline constexpr uint32_t kEntries = 12;      // u16
inline constexpr uint32_t kGlyphs = 14;       // u16, that have a row
inline constexpr uint32_t kSteps = 16;        // u16, at most, a character
inline constexpr uint32_t kPrograms = 18;     // u8
inline constexpr uint32_t kScripts = 19;      // u8
inline constexpr uint32_t kSpans = 20;        // u8
inline constexpr uint32_t kProperties = 21;   // u8
inline constexpr uint32_t kMarks = 22;        // u8
inline constexpr uint32_t kMirrors = 23;      // u8
inline constexpr uint32_t kWidths = 24;       // from there on 5 bits each
inline constexpr uint32_t kWidthBits = 5;
// As if they were bytes.
inline constexpr uint32_t kGlyphBits = kWidths;  // 0..16
inline constexpr uint32_t kRankBits = 25;        // 0..8
inline constexpr uint32_t kMarkBits = 26;        // 0..8
inline constexpr uint32_t kLetterBits = 27;      // 0..16
inline constexpr uint32_t kOffsetBits = 28;      // 0..25
inline constexpr uint32_t kPropertyBits = 29;    // 0..8
inline constexpr uint32_t kLookupBits = 30;      // 0..16
inline constexpr uint32_t kSetBits = 31;         // 0..16
inline constexpr uint32_t kRowBits = 32;         // 0..8
inline constexpr uint32_t kNumbersEnd = 33;
inline constexpr uint32_t kHeaderBits =
    8 * kWidths + (kNumbersEnd - kWidths) * kWidthBits;

// Widths. [bits]
inline constexpr uint32_t kCodeBits = 21;
inline constexpr uint32_t kCountBits = 16;
inline constexpr uint32_t kScriptRow = 2 * kCodeBits + 8;
inline constexpr uint32_t kProgramRow = 4 * 16 + 8 + 16 + 8 + 8;
inline constexpr uint32_t kSpanRow = kCodeBits + 2 * kCountBits;
inline constexpr uint32_t kMaskBits = 5;
inline constexpr uint32_t kJoiningBits = 3;
inline constexpr uint32_t kTypeBits = 4;
inline constexpr uint32_t kSkipBits = 3;
inline constexpr uint32_t kClassBits = 2;
inline constexpr uint32_t kRuleBits = 4;  // how long the parts of a rule are

// Flags of a program.
inline constexpr uint32_t kRightToLeft = 1;
inline constexpr uint32_t kJoins = 2;
inline constexpr uint32_t kThai = 4;
inline constexpr uint32_t kHebrew = 8;
inline constexpr uint32_t kSyllables = 16;  // Devanagari
inline constexpr uint32_t kHasReph = 32;    // its letter ra may become one
inline constexpr uint32_t kEmoji = 64;
inline constexpr uint32_t kSpaceIsFree = 128;  // all programs: none looks at it

// Joining types; from kMark on it is a mark.
inline constexpr uint32_t kBelowForm = 1;  // Devanagari: the letter has one
inline constexpr uint32_t kJoinsNone = 0;
inline constexpr uint32_t kJoinsRight = 1;
inline constexpr uint32_t kJoinsDual = 2;
inline constexpr uint32_t kJoinsLeft = 3;
inline constexpr uint32_t kLowMark = 4;  // Hebrew: meteg, and marks below
inline constexpr uint32_t kMark = 5;
inline constexpr uint32_t kWideMark = 6;    // Hebrew: patah, qamats
inline constexpr uint32_t kNarrowMark = 7;  // Hebrew: sheva, hiriq

inline constexpr uint32_t kMarkClass = 3;  // of GDEF

// Forms, and with them bits of masks.
inline constexpr uint32_t kAnyForm = 1;
inline constexpr uint32_t kIsolated = 2;
inline constexpr uint32_t kFinal = 4;
inline constexpr uint32_t kMedial = 8;
inline constexpr uint32_t kInitial = 16;
// Forms of Devanagari.
inline constexpr uint32_t kReph = 2;
inline constexpr uint32_t kHalf = 4;
inline constexpr uint32_t kBelowBase = 8;
inline constexpr uint32_t kBehindBase = 16;

// Lookups of entries without a mask: what orders syllables.
inline constexpr uint32_t kOrderFirst = 0;
inline constexpr uint32_t kOrderLast = 1;

// Types of lookups.
inline constexpr uint32_t kSingle = 1;
inline constexpr uint32_t kMultiple = 2;
inline constexpr uint32_t kLigatures = 4;
inline constexpr uint32_t kContext = 6;
inline constexpr uint32_t kReverse = 8;
inline constexpr uint32_t kAdjust = 9;  // from there on: positions
inline constexpr uint32_t kPairs = 10;
inline constexpr uint32_t kCursive = 11;
inline constexpr uint32_t kMarkToBase = 12;
inline constexpr uint32_t kMarkToLigature = 13;
inline constexpr uint32_t kMarkToMark = 14;
inline constexpr uint32_t kPositionContext = 15;

/// Lookups within lookups, at most.
inline constexpr uint32_t kMaxDepth = 4;
/// The marks of one letter that are put in order.
inline constexpr uint32_t kMaxMarks = 32;
/// Glyphs of a ligature, and glyphs that a context may change.
inline constexpr uint32_t kMaxInput = 15;
inline constexpr uint32_t kMaxSteps = 1024;
inline constexpr uint32_t kMaxRows = 256;
}  // namespace shaping

// LAYT: tables of the source font as they are, for HarfBuzz. After the header,
// for each glyph of the font its number in the source, u16, and of the list of
// glyphs in the order of those numbers one glyph, u16.
namespace kept_layout {
inline constexpr uint32_t kGlyphs = 0;    // u16
inline constexpr uint32_t kTables = 4;    // 3 times: tag, offset, size, u32
inline constexpr uint32_t kSources = 40;  // the offset is from the section on
}  // namespace kept_layout

// COLR: glyphs of several colours. After the header the colours of all
// palettes: red, green, blue, opacity, a byte each. Then one run of bit tables:
// for each glyph that has layers, and for their end, its id and the number of
// its first layer; and for each layer, from below, a glyph, which is drawn
// without layers of its own, and a colour. From the number of colours on it is
// that of the text, with an opacity of 255 less what it is above that.
namespace layers {
inline constexpr uint32_t kGlyphs = 0;      // u16, that have layers
inline constexpr uint32_t kColours = 2;     // u16, of a palette
inline constexpr uint32_t kPalettes = 4;    // u8
inline constexpr uint32_t kGlyphBits = 5;   // u8, 0..16
inline constexpr uint32_t kColourBits = 6;  // u8, 0..16
inline constexpr uint32_t kStartBits = 7;   // u8, 0..25
inline constexpr uint32_t kBytes = 8;
inline constexpr uint32_t kColourBytes = 4;
/// Layers of a glyph. A reader draws none of one that has more.
inline constexpr uint32_t kMaxLayers = 64;
/// The least opaque colour of the text, above the number of colours.
inline constexpr uint32_t kMaxFaint = 254;
}  // namespace layers

}  // namespace inkcell::format
