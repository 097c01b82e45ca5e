// Draws the jobs of pictures.mjs on the host.
//
// Usage: inkcell_web_pictures FONT JOBS PICTURES
//
// JOBS is a row of 23 numbers of 32 bits a picture: the members of web_job_t
// from `width` on, the bytes of its pixels, which begin as a pattern, and for a
// morph its box, both characters and its progress; of a field a box of width -1
// and its character, of points a box of width -2.
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <vector>

#include "web.h"

namespace {

constexpr int kWords = 23;
constexpr char kText[] = "Hamburg 0189 \xc3\xa9!";

std::vector<char> read(const char* path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    return 2;
  }
  const std::vector<char> font = read(argv[1]);
  std::vector<uint32_t> rom((font.size() + 3) / 4);
  std::memcpy(rom.data(), font.data(), font.size());
  const std::vector<char> jobs = read(argv[2]);
  std::ofstream out(argv[3], std::ios::binary);
  for (size_t at = 0; at < jobs.size(); at += kWords * 4) {
    web_job_t job = {};
    int32_t more[kWords - 16];
    std::memcpy(&job.width, jobs.data() + at, 64);
    std::memcpy(more, jobs.data() + at + 64, sizeof more);
    std::vector<uint8_t> pixels(static_cast<size_t>(more[0]));
    for (size_t i = 0; i < pixels.size(); ++i) {
      pixels[i] = static_cast<uint8_t>(i * 37 >> 3);
    }
    job.rom = reinterpret_cast<const uint8_t*>(rom.data());
    job.rom_size = font.size();
    job.text = kText;
    job.text_size = sizeof kText - 1;
    job.pixels = pixels.data();
    job.pixels_size = pixels.size();
    const int status =
        more[1] == -2   ? web_points(&job, static_cast<uint32_t>(more[4]))
        : more[1] == -1 ? web_field(&job, static_cast<uint32_t>(more[4]))
        : more[1] == 0  ? web_draw(&job)
                        : web_morph(&job, more[1], more[2], more[3],
                                    static_cast<uint32_t>(more[4]),
                                    static_cast<uint32_t>(more[5]), more[6]);
    out.put(static_cast<char>(status));
    out.write(reinterpret_cast<const char*>(pixels.data()),
              static_cast<std::streamsize>(pixels.size()));
  }
  return out ? 0 : 1;
}
