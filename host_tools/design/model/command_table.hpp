// Shared by the files that implement commands.
#pragma once

#include <map>
#include <string>

#include "model/arguments.hpp"
#include "model/project.hpp"
#include "model/sources.hpp"

namespace inkcell::design {

using CommandFunction = Change (*)(const Project& project,
                                   const Arguments& arguments);
using CommandTable = std::map<std::string, CommandFunction>;

void add_batch_command(CommandTable& table);
void add_bearing_commands(CommandTable& table);
void add_glyph_commands(CommandTable& table);
void add_image_commands(CommandTable& table);
void add_part_commands(CommandTable& table);
void add_point_commands(CommandTable& table);
void add_field_commands(CommandTable& table);
void add_font_commands(CommandTable& table);
void add_source_commands(CommandTable& table);
void add_spacing_command(CommandTable& table);
void add_transform_commands(CommandTable& table);
void add_weight_commands(CommandTable& table);

/// The change of a command without what follows in glyphs that are made of
/// others.
Change own_change_of(const Project& project, const Value& command);

/// The layer named by "layer", by default the first.
size_t layer_of(const Project& project, const Arguments& arguments);

/// Removes pictures that no glyph uses after `change`, which only changes
/// glyphs.
void drop_unnamed_images(const Project& project, Change& change);

/// The change made by `edit` on a copy of the glyph named by "glyph". A source
/// that no longer agrees with the contours goes, unless `edit` sets it.
template <typename Edit>
Change edited(const Project& project,
              const Arguments& arguments,
              const Edit& edit,
              bool sets_source = false) {
  GlyphChange change;
  change.layer = layer_of(project, arguments);
  change.name = arguments.text("glyph");
  change.before = project.find(change.name, change.layer);
  if (change.before == nullptr) {
    arguments.refuse("there is no such glyph; add it with add_glyph");
  }
  Glyph glyph = *change.before;
  edit(glyph);
  if (!sets_source && !(glyph.contours == change.before->contours)) {
    settle_source(*change.before, glyph);
  }
  change.after = std::make_shared<const Glyph>(std::move(glyph));
  Change result;
  result.glyphs.push_back(std::move(change));
  return result;
}

}  // namespace inkcell::design
