// Likewise.
#pragma once

#include "py/obj.h"

void mp_raise_msg_varg(const mp_obj_type_t* type, const char* text, ...);
void mp_arg_check_num(
    size_t n_args, size_t n_kw, size_t least, size_t most, bool takes_kw);
void mp_arg_parse_all(size_t n_pos,
                      const mp_obj_t* pos,
                      mp_map_t* kws,
                      size_t n_allowed,
                      const mp_arg_t* allowed,
                      mp_arg_val_t* out);
