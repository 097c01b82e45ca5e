// What the module uses of MicroPython, for where its sources are absent: the
// shapes of types and functions, so that the module can be compiled and not
// run.
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "qstrs.h"  // made by the test: MP_QSTR_...

#define MICROPY_PY_BUILTINS_FLOAT 1
#define MP_ARRAY_SIZE(array) (sizeof(array) / sizeof((array)[0]))
#define MP_ERROR_TEXT(text) text
#define MP_ROM_QSTR(name) ((mp_rom_obj_t)(uintptr_t)(name))
#define MP_ROM_PTR(object) ((mp_rom_obj_t)(object))
#define MP_OBJ_FROM_PTR(object) ((mp_obj_t)(object))
#define MP_OBJ_TO_PTR(object) ((void*)(object))
#define MP_BUFFER_READ 1
#define MP_BUFFER_RW 3
#define MP_TYPE_FLAG_NONE 0
enum {
  MP_ARG_BOOL = 1,
  MP_ARG_INT = 2,
  MP_ARG_OBJ = 3,
  MP_ARG_REQUIRED = 0x100,
  MP_ARG_KW_ONLY = 0x200
};

typedef void* mp_obj_t;
typedef const void* mp_rom_obj_t;
typedef intptr_t mp_int_t;
typedef float mp_float_t;
typedef uint16_t qstr;
typedef struct mp_obj_type_t mp_obj_type_t;
typedef struct mp_map_t mp_map_t;
typedef struct mp_obj_base_t {
  const mp_obj_type_t* type;
} mp_obj_base_t;
typedef struct mp_buffer_info_t {
  void* buf;
  size_t len;
} mp_buffer_info_t;
typedef union mp_arg_val_t {
  bool u_bool;
  mp_int_t u_int;
  mp_obj_t u_obj;
  mp_rom_obj_t u_rom_obj;
} mp_arg_val_t;
typedef struct mp_arg_t {
  uint16_t qst;
  uint16_t flags;
  mp_arg_val_t defval;
} mp_arg_t;
typedef struct mp_rom_map_elem_t {
  mp_rom_obj_t key;
  mp_rom_obj_t value;
} mp_rom_map_elem_t;
typedef struct mp_obj_dict_t {
  mp_obj_base_t base;
  const mp_rom_map_elem_t* table;
} mp_obj_dict_t;
typedef struct mp_obj_module_t {
  mp_obj_base_t base;
  mp_obj_dict_t* globals;
} mp_obj_module_t;
typedef mp_obj_t (*mp_make_new_t)(const mp_obj_type_t*,
                                  size_t,
                                  size_t,
                                  const mp_obj_t*);
struct mp_obj_type_t {
  qstr name;
  mp_make_new_t make_new;
  const mp_obj_dict_t* locals_dict;
};

#define MP_DEFINE_CONST_FUN_OBJ_KW(object, least, function) \
  const struct {                                            \
    mp_obj_t (*call)(size_t, const mp_obj_t*, mp_map_t*);   \
  } object = {function}
#define MP_DEFINE_CONST_FUN_OBJ_2(object, function) \
  const struct { mp_obj_t (*call)(mp_obj_t, mp_obj_t); } object = {function}
#define MP_DEFINE_CONST_DICT(dict, elements) \
  const mp_obj_dict_t dict = {{NULL}, elements}
#define MP_DEFINE_CONST_OBJ_TYPE(type, name, flags, a, make, b, locals) \
  const mp_obj_type_t type = {name, make, locals}
#define MP_DEFINE_STR_OBJ(object, text) \
  const struct { const char* data; } object = {text}
#define MP_REGISTER_MODULE(name, module) \
  extern const mp_obj_module_t* registered

extern const mp_obj_type_t mp_type_module;
extern const mp_obj_type_t mp_type_ValueError;
extern const mp_obj_t mp_const_none;
mp_obj_t mp_obj_new_int(mp_int_t value);
mp_int_t mp_obj_get_int(mp_obj_t object);
mp_float_t mp_obj_get_float(mp_obj_t object);
bool mp_obj_is_float(mp_obj_t object);
mp_obj_t mp_obj_new_list(size_t count, mp_obj_t* items);
mp_obj_t mp_obj_list_append(mp_obj_t list, mp_obj_t item);
const char* mp_obj_str_get_data(mp_obj_t object, size_t* count);
void mp_get_buffer_raise(mp_obj_t object, mp_buffer_info_t* out, int flags);
void* mp_obj_malloc_helper(size_t size, const mp_obj_type_t* type);
#define mp_obj_malloc(type, kind) \
  ((type*)mp_obj_malloc_helper(sizeof(type), kind))
void* m_malloc(size_t size);
#define m_new(type, count) ((type*)m_malloc(sizeof(type) * (count)))
typedef struct vstr_t {
  char* buf;
} vstr_t;
void vstr_init(vstr_t* string, size_t capacity);
void vstr_add_strn(vstr_t* string, const char* text, size_t count);
void vstr_add_byte(vstr_t* string, uint8_t byte);
mp_obj_t mp_obj_new_str_from_vstr(vstr_t* string);
