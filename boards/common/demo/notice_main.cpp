// A firmware that shows notices as they come over the serial line: UTF-8, a
// tab between from whom and what, a line feed behind. READY on the console
// says that what came so far is on the screen.
#include "board.hpp"
#include "canvas.hpp"
#include "display.hpp"
#include "inkcell/shaping/devanagari.hpp"
#include "inkcell/shaping/text_shaper.hpp"
#include "notice.hpp"
#include "serial.hpp"

namespace {

namespace board = inkcell::board;
namespace demo = inkcell::demo;
using inkcell::Text;

// The longest word of a notice. 16 bytes a glyph.
inkcell::TextGlyph room[64];

char bytes[demo::kMostNotices][demo::kMostNoticeBytes];
demo::Notice notices[demo::kMostNotices];

// Reads a line, and drops the bytes that find no room.
Text read_line(char (&out)[demo::kMostNoticeBytes]) noexcept {
  size_t size = 0;
  for (char c = board::console_read(); c != '\n'; c = board::console_read()) {
    if (size < sizeof out) {
      out[size++] = c;
    }
  }
  return {out, size};
}

}  // namespace

int main(int, char**) {
  if (!board::display_init(demo::kFormat)) {
    board::print("no display\n");
    return 1;
  }
  if (demo::open_notices() != inkcell::Status::ok) {
    board::print("the fonts do not open\n");
    return 1;
  }
  inkcell::TextShaper shaper(room, inkcell::kDevanagari);
  for (size_t count = 0;; count = count % demo::kMostNotices + 1) {
    demo::show_notices({notices, count}, shaper);
    board::print("READY\n");
    const size_t next = count % demo::kMostNotices;
    notices[next] = read_line(bytes[next]);
  }
}
