/* Version and errors. */
#ifndef MACULA_STATUS_H
#define MACULA_STATUS_H

#include <stdint.h>

#if defined(__GNUC__)
#define MACULA_API __attribute__((visibility("default")))
#else
#define MACULA_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* The version of the library, such as "0.1.0". Until 1.0.0 each minor version may change the interface, and
 * then its SONAME. */
MACULA_API const char* macula_version(void);

typedef int32_t macula_status;
enum {
    MACULA_DONE = 0,
    MACULA_USAGE = 1,  /* something that does not exist was asked for, or an argument means nothing */
    MACULA_INPUT = 2,  /* input that is missing, unreadable, malformed or unsupported */
    MACULA_DEVICE = 3, /* no Vulkan driver, or no such device, or lost too often */
    MACULA_MEMORY = 4, /* not enough, on the host or on the device */
    MACULA_CANCELLED = 5,
    MACULA_FAULT = 6,  /* a mistake of Macula itself: please report it */
    MACULA_OUTPUT = 7, /* a file or folder cannot be written */
    MACULA_ARCHIVE = 8 /* a PACS that cannot be reached, or refuses */
};

/* Why a call failed. */
typedef struct macula_error {
    uint32_t size;
    macula_status status;
    const char* message; /* one sentence that a radiologist understands; names no patient */
    const char* advice;  /* what to do; may be empty */
    const char* place;   /* the file or object concerned, U+FFFD for bytes that are not UTF-8; may be empty,
                          * may name a patient, and belongs in no log */
} macula_error;

/* The error of the last call of this thread that failed. Its texts live until the next call of this thread.
 */
MACULA_API macula_status macula_last_error(macula_error* error);

#ifdef __cplusplus
}
#endif

#endif
