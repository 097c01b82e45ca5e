// The smallest program that draws a TrueType file of an SD card, made without
// the generator.
#include <inkcell/inkcell.hpp>
#include <inkcell/truetype/stored_truetype.hpp>

using namespace inkcell;

extern uint8_t pixels[128 * 64];
uint8_t pixels[128 * 64];

// Your driver or file system, which reads `count` bytes from `offset` on.
static bool read(void* file, uint32_t offset, uint8_t* bytes, uint32_t count);

alignas(8) static uint8_t lent[StoredTrueType::ram_bytes(8)];

static Status draw(const Strip& strip) {
  StoredTrueType sans;
  INKCELL_TRY(StoredTrueType::open({read, nullptr}, lent, sans));
  const port::A8Canvas canvas(strip);
  Painter(canvas).text(sans.font(), Style(24_px), {4, 28}, "Any words");
  return sans.status();
}

int main() {
  return static_cast<int>(draw({pixels, 0, 0, 128, 64, 128}));
}

// A card whose bytes are all the same.
static bool read(void*, uint32_t, uint8_t* bytes, uint32_t count) {
  for (; count != 0; --count) {
    *bytes++ = 0;
  }
  return true;
}
