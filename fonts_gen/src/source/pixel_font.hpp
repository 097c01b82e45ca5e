// Bitmap fonts: BDF, PCF, Unifont's .hex, each also as gzip, and LVGL's .bin.
#pragma once

#include <filesystem>

#include "source/font_source.hpp"

namespace inkcell::gen {

/// Whether a file is a bitmap font, by its first bytes. Throws Error if it
/// cannot be read.
bool is_bitmap_font(const std::filesystem::path& file);

/// Reads the characters of `request` that such a file has, with the pictures,
/// advances and kerning in it. Throws Error.
SourceFont load_pixel_font(const FontRequest& request, Warnings& warnings);

}  // namespace inkcell::gen
