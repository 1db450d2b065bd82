/* Progress and cancellation of calls that block. */
#ifndef MACULA_PROGRESS_H
#define MACULA_PROGRESS_H

#include <stdint.h>

#include "status.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct macula_cancel macula_cancel;
/* A handle that cancels the calls that it is given to: see macula_progress. */
MACULA_API macula_status macula_cancel_create(macula_cancel** cancel);
/* May be called from any thread while the handle is open: calls that have the handle end soon with
 * MACULA_CANCELLED, and so do calls that get it later. */
MACULA_API void macula_cancel_now(macula_cancel* cancel);
/* Close it when no call has it any more. */
MACULA_API void macula_cancel_close(macula_cancel* cancel);

/* `stage` is for a person and lives for the call; `fraction` is 0 to 1, of this stage. Called some ten times
 * a second at most, from any thread, never two at once. A result other than 0 cancels the call, and `cancel`
 * too if there is one. It must not call Macula, nor throw. */
typedef int32_t (*macula_told)(void* user, const char* stage, double fraction);

/* May be null in every call: then nothing reports progress, and nothing cancels. */
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
