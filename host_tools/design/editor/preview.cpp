#include "editor/preview.hpp"

#include <chrono>
#include <set>

#include "cells.hpp"
#include "export/rom.hpp"
#include "inkcell/font.hpp"
#include "model/contours.hpp"
#include "model/error.hpp"
#include "rom_file.hpp"
#include "shape/outline.hpp"
#include "trace/field_outline.hpp"

namespace inkcell::design::editor {
namespace {

// The code point of a glyph that has none.
constexpr char32_t kPrivate = 0xF8FF;

// Adds a glyph and its components.
void add_glyph(const Project& from, const std::string& name, Project& to) {
  const GlyphPointer glyph = from.find(name);
  if (glyph == nullptr || !to.front().glyphs.emplace(name, glyph).second) {
    return;
  }
  for (const ComponentUse& use : glyph->components) {
    add_glyph(from, use.base, to);
  }
}

void add_cells(const PreviewJob& job, Preview& preview) {
  const GlyphPointer glyph = job.project.glyph(job.glyph);
  const gen::Shape shape(outline_of(job.project, *glyph));
  if (shape.empty()) {
    return;
  }
  gen::Target target;
  target.coding = gen::Coding::field;
  const ShapeField made(shape, target);
  const GlyphField& field = made.field();
  preview.cell_bytes = made.bytes();
  const double scale = job.project.units_per_em() / gen::kUPerEm;
  tools::for_each_cell(field, [&](const Cell& cell) {
    preview.cells.push_back({scale * cell.x0_u, scale * cell.y0_u,
                             scale * (1 << cell.size_log2),
                             cell.is_saturated()});
  });
}

void add_facts(const gen::FontReport& report,
               const std::string& key,
               Preview& preview) {
  for (const gen::GlyphReport& glyph : report.glyphs) {
    if (glyph.key == key) {
      preview.glyph_bytes = glyph.bytes;
      preview.glyph_points = glyph.points;
      preview.worst_error = glyph.worst_error;
      preview.worst_px = glyph.worst_px;
    }
  }
}

}  // namespace

PreviewJob make_job(const Project& project,
                    const std::string& glyph,
                    const PreviewSettings& settings) {
  PreviewJob job;
  job.glyph = glyph;
  job.settings = settings;
  job.project.font = project.font;
  add_glyph(project, ".notdef", job.project);
  add_glyph(project, glyph, job.project);
  std::set<char32_t> wanted;
  std::set<char32_t> found;
  for (const char32_t c : tools::from_utf8(settings.text)) {
    wanted.insert(c);
  }
  for (const auto& [name, candidate] : project.front().glyphs) {
    for (const char32_t c : candidate->unicodes) {
      if (wanted.count(c) != 0) {
        add_glyph(project, name, job.project);
        found.insert(c);
        job.undrawn += is_undrawn(*candidate) ? tools::to_utf8(c) : "";
      }
    }
  }
  for (const char32_t c : wanted) {
    job.missing += found.count(c) == 0 ? tools::to_utf8(c) : "";
  }
  const GlyphPointer shown = project.glyph(glyph);
  if (!shown->unicodes.empty()) {
    job.character = shown->unicodes.front();
    return job;
  }
  Glyph mapped = *shown;
  if (glyph[0] == '_') {  // a part, which fonts leave out
    mapped.name = job.glyph = ".shown";
  }
  mapped.unicodes = {kPrivate};
  job.character = kPrivate;
  job.project.front().glyphs[job.glyph] =
      std::make_shared<const Glyph>(std::move(mapped));
  return job;
}

Preview draw_preview(const PreviewJob& job, gen::BuiltGlyphs* glyphs) {
  Preview preview;
  preview.glyph_name = job.glyph;
  preview.missing = job.missing;
  preview.undrawn = job.undrawn;
  const auto begin = std::chrono::steady_clock::now();
  try {
    gen::GenerateRequest request;
    request.built_glyphs = glyphs;
    const gen::RomFont font = make_rom(job.project, request);
    const PreviewSettings& settings = job.settings;
    const std::string text = tools::to_utf8(job.character);
    add_facts(font.report, text, preview);
    preview.rom = font.bytes;
    preview.glyph = draw_on_display(preview.rom, text, settings.glyph_px,
                                    settings.display, settings.dark);
    for (const double px : settings.text_px) {
      preview.lines.push_back(
          {px, draw_on_display(preview.rom, settings.text, px, settings.display,
                               settings.dark)});
    }
    if (settings.cells) {
      add_cells(job, preview);
    }
  } catch (const std::exception& error) {
    preview.error = error.what();
  }
  const std::chrono::duration<double> time =
      std::chrono::steady_clock::now() - begin;
  preview.seconds = time.count();
  return preview;
}

}  // namespace inkcell::design::editor
