// The faces added by --merge.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "source/char_set.hpp"
#include "source/icon_place.hpp"
#include "source/variation.hpp"

namespace inkcell::gen {

/// A face for characters that the faces before it lack.
struct MergedFace {
  std::filesystem::path file;
  std::optional<int> face;  // none: the first
  std::string instance;
  std::vector<AxisSetting> axes;
  /// The characters to take from it; none: all that are still missing.
  CharSet characters;
  /// The baseline of its glyphs: its own, or the em square at `place`. by_kind:
  /// icons at `place`, others on their own baseline.
  enum class Baseline { by_kind, own, placed };
  Baseline baseline = Baseline::by_kind;
  /// Its height scales the face, whatever the baseline.
  IconPlace place;
};

/// Parses "FILE[:SETTING,...][=LIST]", with a list of add_ranges and settings
/// TAG=VALUE, instance=NAME, face=N, height=em|cap|NUMBER and
/// baseline=own|middle|bottom|NUMBER. Text that is the name of a file, as a
/// whole or up to its last '=', has no settings. Throws Error.
MergedFace parse_merged_face(const std::string& text);

}  // namespace inkcell::gen
