// What a sketch includes.
#pragma once

#include "inkcell/inkcell.hpp"
