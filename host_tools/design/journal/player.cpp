// Runs records; undo and redo.
#include "journal/session.hpp"
#include "model/base64.hpp"
#include "model/commands.hpp"
#include "model/error.hpp"
#include "ufo/glif.hpp"

namespace inkcell::design {
namespace {

Value images_value(const Images& images) {
  Value value = Value::object();
  for (const auto& [name, bytes] : images) {
    value[name] = encode_base64(*bytes);
  }
  return value;
}

Images parse_images(const Value& value) {
  Images images;
  for (const auto& [name, text] : value.items()) {
    images[name] = std::make_shared<const std::vector<uint8_t>>(
        decode_base64(text.get<std::string>()));
  }
  return images;
}

Value font_value(const FontData& font) {
  return {{"images", images_value(font.images)},
          {"info", font.info},
          {"groups", font.groups},
          {"kerning", font.kerning},
          {"lib", font.lib},
          {"features", font.features}};
}

}  // namespace

Value restore_record(const Change& change, bool after) {
  Value glyphs = Value::array();
  for (const GlyphChange& glyph : change.glyphs) {
    const GlyphPointer& state = after ? glyph.after : glyph.before;
    glyphs.push_back({glyph.layer, glyph.name,
                      state == nullptr ? Value() : Value(write_glif(*state))});
  }
  Value record = {{"do", "restore"}, {"glyphs", std::move(glyphs)}};
  const FontDataPointer& font = after ? change.font_after : change.font_before;
  if (font != nullptr) {
    record["font"] = font_value(*font);
  }
  return record;
}

bool Player::undo() {
  if (done_ == 0) {
    return false;
  }
  project_.revert(steps_[--done_]);
  return true;
}

bool Player::redo() {
  if (done_ == steps_.size()) {
    return false;
  }
  project_.apply(steps_[done_++]);
  return true;
}

void Player::apply(Change change) {
  project_.apply(change);
  steps_.resize(done_);
  steps_.push_back(std::move(change));
  ++done_;
}

void Player::restore(const Value& record) {
  Change change;
  for (const Value& entry : record.at("glyphs")) {
    GlyphChange glyph;
    glyph.layer = entry.at(0).get<size_t>();
    glyph.name = entry.at(1).get<std::string>();
    if (!entry.at(2).is_null()) {
      glyph.after = std::make_shared<const Glyph>(
          parse_glif(entry.at(2).get<std::string>(), "journal"));
    }
    change.glyphs.push_back(std::move(glyph));
  }
  if (record.contains("font")) {
    const Value& data = record["font"];
    change.font_after = std::make_shared<const FontData>(
        FontData{data.at("info"), data.at("groups"), data.at("kerning"),
                 data.at("lib"), data.at("features").get<std::string>(),
                 parse_images(data.at("images"))});
  }
  project_.apply(change);
}

void Player::play(const Value& record) {
  const std::string name = record.value("do", "");
  if (name == "begin" || name == "save") {
    return;
  }
  if (name == "undo" || name == "redo") {
    if (!(name == "undo" ? undo() : redo())) {
      throw Error("command '" + name + "': there is nothing to " + name);
    }
  } else if (name == "restore") {
    try {
      restore(record);
    } catch (const Value::exception& error) {
      throw Error(std::string("command 'restore': ") + error.what());
    }
  } else {
    apply(change_of(project_, record));
  }
}

}  // namespace inkcell::design
