#include "fixtures.hpp"

#include <unistd.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "model/commands.hpp"
#include "model/contours.hpp"

namespace inkcell::design::test {

namespace fs = std::filesystem;

namespace {

std::string plist(const std::string& content) {
  return "<?xml version='1.0' encoding='UTF-8'?>\n"
         "<!DOCTYPE plist PUBLIC \"-//Apple//DTD PLIST 1.0//EN\" "
         "\"http://www.apple.com/DTDs/PropertyList-1.0.dtd\">\n"
         "<plist version=\"1.0\">\n" +
         content + "</plist>\n";
}

constexpr const char* kGlyphA = R"(<?xml version='1.0' encoding='UTF-8'?>
<glyph name="A" format="2">
	<advance width="700"/>
	<unicode hex="0041"/>
	<note>
tall &amp; narrow
	</note>
	<image fileName="A.png" xScale="0.5" yScale="0.5"/>
	<guideline y="350" name="bar" identifier="g1"/>
	<anchor x="350" y="720" name="top"/>
	<outline>
		<contour identifier="c1">
			<point x="0" y="0" type="line" name="start"/>
			<point x="100" y="0" type="line"/>
			<point x="400.5" y="700" type="line"/>
		</contour>
		<contour>
			<point x="300" y="0" type="move"/>
			<point x="350" y="10"/>
			<point x="390" y="40"/>
			<point x="400" y="90" type="curve" smooth="yes"/>
		</contour>
	</outline>
	<lib>
		<dict>
			<key>com.foreign.tool</key>
			<dict>
				<key>when</key>
				<date>2020-02-02T10:00:00Z</date>
				<key>blob</key>
				<data>
				AAEC/w==
				</data>
				<key>real</key>
				<real>0.25</real>
			</dict>
		</dict>
	</lib>
</glyph>
)";

constexpr const char* kGlyphO = R"(<?xml version="1.0" encoding="UTF-8"?>
<glyph name="o" format="2">
  <advance width="512" height="20"/>
  <unicode hex="006F"/>
  <outline>
    <contour>
      <point x="0" y="0"/>
      <point x="0" y="500"/>
      <point x="500" y="500"/>
      <point x="500" y="0"/>
    </contour>
    <contour>
      <point x="100" y="250" type="qcurve" smooth="yes"/>
      <point x="100" y="150"/>
      <point x="180" y="100"/>
      <point x="250" y="100" type="qcurve" smooth="yes"/>
      <point x="300" y="100"/>
      <point x="400" y="180"/>
      <point x="400" y="250" type="curve" smooth="yes"/>
      <point x="400" y="400"/>
      <point x="100" y="400"/>
    </contour>
  </outline>
</glyph>
)";

constexpr const char* kGlyphAcute = R"(<?xml version="1.0" encoding="UTF-8"?>
<glyph name="aacute" format="2">
  <advance width="512"/>
  <outline>
    <!-- narrow -->
    <component base="o"/>
    <component base="A" xScale="-0.5" yOffset="300"/>
  </outline>
</glyph>
)";

void make_plists(const fs::path& folder) {
  write_text(folder / "metainfo.plist",
             plist("<dict>\n\t<key>creator</key>\n\t<string>org.foreign"
                   "</string>\n\t<key>formatVersion</key>\n\t<integer>3"
                   "</integer>\n</dict>\n"));
  write_text(folder / "fontinfo.plist",
             plist("<dict>\n\t<key>unitsPerEm</key>\n\t<integer>1000"
                   "</integer>\n\t<key>familyName</key>\n\t<string>A &amp; B"
                   "</string>\n\t<key>italicAngle</key>\n\t<real>-12.5"
                   "</real>\n</dict>\n"));
  write_text(folder / "groups.plist",
             plist("<dict>\n\t<key>public.kern1.O</key>\n\t<array>\n\t\t"
                   "<string>o</string>\n\t</array>\n</dict>\n"));
  write_text(folder / "kerning.plist",
             plist("<dict>\n\t<key>public.kern1.O</key>\n\t<dict>\n\t\t<key>A"
                   "</key>\n\t\t<integer>-40</integer>\n\t</dict>\n</dict>\n"));
  write_text(folder / "lib.plist",
             plist("<dict>\n\t<key>com.foreign.z</key>\n\t<true/>\n\t<key>"
                   "com.foreign.a</key>\n\t<array>\n\t\t<integer>-3</integer>"
                   "\n\t\t<false/>\n\t</array>\n</dict>\n"));
  write_text(folder / "layercontents.plist",
             plist("<array>\n\t<array>\n\t\t<string>foreground</string>\n\t\t"
                   "<string>glyphs</string>\n\t</array>\n\t<array>\n\t\t"
                   "<string>sketch</string>\n\t\t<string>glyphs.sketch"
                   "</string>\n\t</array>\n</array>\n"));
  write_text(folder / "features.fea", "# none yet\n");
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::string name = (fs::temp_directory_path() / "inkcell-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) {
    throw std::runtime_error("no temporary folder can be made");
  }
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::map<std::string, std::string> contents_of(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const fs::directory_entry& entry :
       fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) {
      std::ostringstream text;
      text << std::ifstream(entry.path(), std::ios::binary).rdbuf();
      files[fs::relative(entry.path(), folder).generic_string()] = text.str();
    }
  }
  return files;
}

void write_text(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream out(file, std::ios::binary);
  out << text;
  if (!out.flush()) {
    throw std::runtime_error(file.string() + ": cannot be written");
  }
}

void make_foreign_ufo(const fs::path& folder) {
  make_plists(folder);
  write_text(folder / "glyphs/A_.glif", kGlyphA);
  write_text(folder / "glyphs/o.glif", kGlyphO);
  write_text(folder / "glyphs/aacute.glif", kGlyphAcute);
  write_text(folder / "glyphs/contents.plist",
             plist("<dict>\n\t<key>A</key>\n\t<string>A_.glif</string>\n\t"
                   "<key>o</key>\n\t<string>o.glif</string>\n\t<key>aacute"
                   "</key>\n\t<string>aacute.glif</string>\n</dict>\n"));
  write_text(folder / "glyphs.sketch/contents.plist",
             plist("<dict>\n\t<key>o</key>\n\t<string>o.glif</string>\n"
                   "</dict>\n"));
  write_text(folder / "glyphs.sketch/o.glif", kGlyphO);
  write_text(folder / "data/com.foreign.tool/settings.bin",
             std::string("\0\1\2\xff", 4));
  write_text(folder / "images/A.png", "no picture, but bytes all the same");
}

gen::SourceFont letters_of(const fs::path& font,
                           const std::string& characters) {
  gen::FontRequest request;
  request.file = font;
  gen::add_text(characters, "letters", request.characters);
  gen::Warnings warnings;
  gen::SourceFont source = gen::load_font(request, 1, warnings);
  source.glyphs.erase(source.glyphs.begin());
  return source;
}

Project face(const std::string& file,
             const std::string& ranges,
             Composites composites) {
  gen::CharSet characters;
  gen::add_ranges(ranges, characters);
  gen::Warnings warnings;
  return import_font("/usr/share/fonts/truetype/" + file, characters, warnings,
                     composites);
}

void run(Project& project, const Value& command) {
  project.apply(change_of(project, command));
}

void add_glyph(Project& project,
               const std::string& name,
               std::vector<char32_t> unicodes,
               const std::string& contours,
               const std::vector<ComponentUse>& components) {
  Glyph glyph;
  glyph.name = name;
  glyph.width = 600;
  glyph.unicodes = std::move(unicodes);
  glyph.components = components;
  for (const Value& contour : Value::parse(contours)) {
    glyph.contours.push_back(parse_contour(contour));
  }
  project.front().glyphs[name] =
      std::make_shared<const Glyph>(std::move(glyph));
}

}  // namespace inkcell::design::test
