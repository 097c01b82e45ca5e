// stb_truetype as a library, as it comes.
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb_truetype.h>
