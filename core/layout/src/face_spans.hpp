// Words in a face of their own: an object of its own, which programs without
// FaceSpans do not link.
#pragma once

#include "pen.hpp"
