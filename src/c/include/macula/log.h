/* The log of the library. */
#ifndef MACULA_LOG_H
#define MACULA_LOG_H

#include <stdint.h>

#include "status.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { MACULA_LOG_DEBUG = 0, MACULA_LOG_INFO = 1, MACULA_LOG_WARNING = 2, MACULA_LOG_ERROR = 3 };
/* A line for those who support Macula, without its end; lives for the call. From any thread, never two at
 * once. It must not call Macula, nor throw. */
typedef void (*macula_log_line)(void* user, int32_t level, const char* line);
/* From now on `told` has the lines of `least` and above, and which device was opened; null: nobody has.
 * Returns when no line is on its way to whoever had them before. */
MACULA_API macula_status macula_log_to(macula_log_line told, void* user, int32_t least);

#ifdef __cplusplus
}
#endif

#endif
