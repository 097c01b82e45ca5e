// A firmware that shows a page of Chinese. Its font is on the board's card,
// from the first byte on: no file system. It has outlines, or strikes alone.
//
// Arguments: frame=N shows page N, and says what was read for it. READY on the
// console says that it is on the screen.
#include "arguments.hpp"
#include "board.hpp"
#include "card.hpp"
#include "display.hpp"
#include "inkcell/stored/stored_font.hpp"
#include "inkcell/strike/strike.hpp"
#include "page.hpp"

namespace {

namespace board = inkcell::board;
namespace demo = inkcell::demo;
using inkcell::Status;
using inkcell::StoredFont;
using inkcell::StoredStats;

// Room for the glyphs of a line, each on a page of its own that another block
// of the index names.
constexpr size_t kBlockBytes = 1024;
constexpr size_t kBlocks = 32;

alignas(8) uint8_t ram[StoredFont::ram_bytes(kBlockBytes, kBlocks)];

void print_costs(const StoredStats& from, const StoredStats& to) noexcept {
  board::print_decimal(to.reads - from.reads);
  board::print(" reads of ");
  board::print_decimal(to.bytes - from.bytes);
  board::print(" bytes for the page, with ");
  board::print_decimal(sizeof ram);
  board::print(" bytes of RAM for blocks\n");
}

bool fail(const char* what, Status why) noexcept {
  board::print(what);
  board::print_decimal(static_cast<uint32_t>(why));
  board::print("\n");
  return false;
}

bool show(uint32_t page) noexcept {
  const Status card = board::card_init();
  if (card != Status::ok) {
    return fail("the card does not answer: status ", card);
  }
  StoredFont stored;
  const inkcell::Storage storage = {board::card_read, nullptr};
  Status opened = StoredFont::open(storage, ram, stored);
  if (opened == Status::unsupported) {
    opened = StoredFont::open(storage, ram, inkcell::kStrikeCoding, stored);
  }
  if (opened != Status::ok) {
    return fail("the card does not hold a font: status ", opened);
  }
  const StoredStats before = stored.stats();
  const Status shown = demo::show_page(stored.font(), page);
  if (shown != Status::ok) {
    return fail("the page is not whole: status ", shown);
  }
  if (stored.status() != Status::ok) {
    return fail("the card cannot be read: status ", stored.status());
  }
  print_costs(before, stored.stats());
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  if (!board::display_init(demo::kFormat)) {
    board::print("no display\n");
    return 1;
  }
  uint32_t page = 0;
  static_cast<void>(demo::find_number(argc, argv, "frame=", page));
  if (!show(page)) {
    return 1;
  }
  board::print("READY\n");
  for (;;) {
  }
}
