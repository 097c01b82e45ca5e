// Semihosting: exit code, arguments and files of the host that runs the
// emulator or the debugger.
//
// Without a host every call returns -1: start-up code catches the unhandled
// trap. So firmware may call these on real hardware, too.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace inkcell::semihosting {

enum class Mode : uint32_t { read = 1, write = 5 };  // both binary

/// Opens a file; relative names start in the emulator's working directory.
/// Returns a handle, or -1. ":tt" with Mode::write is standard output.
intptr_t open(const char* name, Mode mode) noexcept;

/// Both return whether all `size` bytes were transferred.
bool read(intptr_t file, void* bytes, size_t size) noexcept;
bool write(intptr_t file, const void* bytes, size_t size) noexcept;

/// The length of an open file [bytes], or -1.
intptr_t length(intptr_t file) noexcept;

void close(intptr_t file) noexcept;

/// Writes the command line, joined by single blanks and zero-terminated, to
/// `line`. False, with an empty line, if it does not fit or there is none.
bool command_line(char* line, size_t size) noexcept;

/// Ends the emulator with this exit code. Returns if there is none.
void exit(int code) noexcept;

}  // namespace inkcell::semihosting
