// Offsets and limits of a paged font (docs/FORMAT.md), which lies in storage
// that is not mapped.
#pragma once

#include <stdint.h>

#include "inkcell/cpp17.hpp"

namespace inkcell::format::paged {

inline constexpr uint32_t kMagic = 0x504b4e49;  // "INKP"

// The container's header, at offset 0 of the file; the roots of the index
// follow it.
inline constexpr uint32_t kMagicAt = 0;        // u32
inline constexpr uint32_t kFormatMinor = 4;    // u8
inline constexpr uint32_t kFormatMajor = 5;    // u8
inline constexpr uint32_t kResidentBytes = 6;  // u16
inline constexpr uint32_t kHeaderCrc = 8;      // u32
inline constexpr uint32_t kContentCrc = 12;    // u32
inline constexpr uint32_t kBlockBytes = 16;    // u16
inline constexpr uint32_t kFontOffset = 18;    // u16
inline constexpr uint32_t kGlyphEnd = 20;      // u16
inline constexpr uint32_t kLevels = 22;        // u8
inline constexpr uint32_t kRoots = 23;         // u8
inline constexpr uint32_t kPages = 24;         // u16
inline constexpr uint32_t kKernEnd = 26;       // u16
inline constexpr uint32_t kBytes = 28;

inline constexpr uint32_t kMaxResidentBytes = 512;
inline constexpr uint32_t kMinBlockBytes = 512;
inline constexpr uint32_t kMaxBlockBytes = 4096;
inline constexpr uint32_t kMaxLevels = 2;

// Of COLR in the resident font: u32, the bytes of the section, which follows
// the pairs in blocks of its own; 3 bytes at least follow it there.
inline constexpr uint32_t kLayersBytes = 4;

// An entry of the index, all of u16.
namespace entry {
inline constexpr uint32_t kGlyph = 0;
inline constexpr uint32_t kCodeLow = 2;
inline constexpr uint32_t kCodeHigh = 4;
inline constexpr uint32_t kBytes = 6;
}  // namespace entry

// The end of a page.
namespace trailer {
inline constexpr uint32_t kFirstGlyph = 0;  // u16
inline constexpr uint32_t kGlyphs = 2;      // u8
inline constexpr uint32_t kRuns = 3;        // u8
inline constexpr uint32_t kReserved = 4;    // u16, 0
inline constexpr uint32_t kRecords = 6;     // u16
inline constexpr uint32_t kBytes = 8;
}  // namespace trailer

}  // namespace inkcell::format::paged
