// A firmware that shows a TrueType file, which is on the board's card as it is,
// from the first byte on: no generator, no file system.
//
// READY on the console says that it is on the screen.
#include "board.hpp"
#include "card.hpp"
#include "display.hpp"
#include "face.hpp"
#include "inkcell/truetype/stored_truetype.hpp"

namespace {

namespace board = inkcell::board;
namespace demo = inkcell::demo;
using inkcell::Status;
using inkcell::StoredTrueType;

alignas(8) uint8_t lent[StoredTrueType::ram_bytes(8)];

Status show() noexcept {
  INKCELL_TRY(board::card_init());
  StoredTrueType stored;
  INKCELL_TRY(StoredTrueType::open({board::card_read, nullptr}, lent, stored));
  INKCELL_TRY(demo::show_face(stored.font()));
  board::print_decimal(stored.stats().reads);
  board::print(" reads of 512 bytes, with ");
  board::print_decimal(sizeof lent);
  board::print(" bytes of RAM\n");
  return stored.status();
}

}  // namespace

int main() {
  const Status shown =
      board::display_init(demo::kFormat) ? show() : Status::unsupported;
  if (shown != Status::ok) {
    board::print("the file on the card does not show: status ");
    board::print_decimal(static_cast<uint32_t>(shown));
    board::print("\n");
    return 1;
  }
  board::print("READY\n");
  for (;;) {
  }
}
