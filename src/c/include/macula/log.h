/* The log of the library. */
#ifndef MACULA_LOG_H
#define MACULA_LOG_H

#include <stdint.h>

#include "status.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { MACULA_LOG_DEBUG = 0, MACULA_LOG_INFO = 1, MACULA_LOG_WARNING = 2, MACULA_LOG_ERROR = 3 };
/* Receives a line for those who support Macula, without its end of line; it lives for the call. Called from
 * any thread, never two at once. It must not call Macula, nor throw. */
typedef void (*macula_log_line)(void* user, int32_t level, const char* line);
/* From now on `told` receives the lines of level `least` and above, and which device was opened; null: nobody
 * does. Returns once no call of the previous receiver is under way. */
MACULA_API macula_status macula_log_to(macula_log_line told, void* user, int32_t least);

#ifdef __cplusplus
}
#endif

#endif
