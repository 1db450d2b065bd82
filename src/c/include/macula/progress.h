/* Progress and cancellation of calls that block. */
#ifndef MACULA_PROGRESS_H
#define MACULA_PROGRESS_H

#include <stdint.h>

#include "status.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct macula_cancel macula_cancel;
/* What cancels a call that it is given to: see macula_progress. */
MACULA_API macula_status macula_cancel_create(macula_cancel** cancel);
/* From any thread, for as long as the handle is open: what it was given to ends soon with MACULA_CANCELLED,
 * and so does whatever it is given to later. */
MACULA_API void macula_cancel_now(macula_cancel* cancel);
/* When no call has it any more. */
MACULA_API void macula_cancel_close(macula_cancel* cancel);

/* `stage` is for a person and lives for the call; `fraction` is 0 to 1, of this stage. At most some ten times
 * a second, from any thread, never two at once. Anything but 0 cancels, the handle too if there is one. It
 * must not call Macula, nor throw. */
typedef int32_t (*macula_told)(void* user, const char* stage, double fraction);

/* Null wherever it is taken: nobody is told, and nothing cancels. */
typedef struct macula_progress {
    uint32_t size;
    uint32_t reserved;     /* 0 */
    macula_told told;      /* may be null */
    void* user;            /* for `told` */
    macula_cancel* cancel; /* may be null */
} macula_progress;

#ifdef __cplusplus
}
#endif

#endif
