// One fixed-point format assigned to another.
// refused: conversion from|no viable conversion|could not convert
#include "inkcell/fixed.hpp"

inkcell::Q16_16 widen(inkcell::Q26_6 length) noexcept {
#if REFUSED
  return length;
#else
  return inkcell::Q16_16::from_raw(length.raw * 1024);
#endif
}
