/* Where the members of the structs of macula.h are, as a C compiler has them. */
#ifndef TESTS_C_LAYOUT_H
#define TESTS_C_LAYOUT_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

struct place {
    const char* name; /* "macula_error", or "macula_error.message" */
    size_t size;      /* of a struct */
    size_t offset;    /* of a member */
};

/* The end has no name. */
extern const struct place kLayout[];

#ifdef __cplusplus
}
#endif

#endif
