/* The model that a live picture is drawn with: trained, kept and written. */
#ifndef MACULA_MODEL_H
#define MACULA_MODEL_H

#include <stdint.h>

#include "live.h"
#include "progress.h"
#include "status.h"

#ifdef __cplusplus
extern "C" {
#endif

enum {
    MACULA_MODEL_NONE = 0,      /* nothing was shown or trained yet, or what is shown has none */
    MACULA_MODEL_SEARCHING = 1, /* for a stored one, or for points to begin with */
    MACULA_MODEL_RESUMING = 2,  /* the stored one is drawn, while the rest of it is read */
    MACULA_MODEL_LEARNING = 3,
    MACULA_MODEL_RESTING = 4, /* it has learnt what its pictures can teach it */
    MACULA_MODEL_NOTHING_TO_SEE = 5,
    MACULA_MODEL_NO_ROOM = 6, /* the device has no memory for it */
    MACULA_MODEL_FAILED = 7
};

/* How far the model is. */
typedef struct macula_model {
    uint32_t size;
    int32_t stage;      /* MACULA_MODEL_NONE ... */
    int32_t is_resumed; /* it was in the store, or was shown before */
    uint32_t splats;
    uint64_t steps;         /* since it was begun, before it was stored too */
    uint64_t views;         /* pictures that it has learnt from or is judged by */
    double error;           /* mean difference to pictures that are held out; NaN: not known yet */
    double seconds;         /* of training since it was opened */
    const char* stage_name; /* texts live as long as the library is loaded */
    const char* origin;     /* why it is fresh or resumed, for a person */
} macula_model;
/* Of what is shown. */
MACULA_API macula_status macula_live_model(const macula_live* live, macula_model* model);

/* When to stop, whatever comes first; it stops by itself when the model rests. */
typedef struct macula_training {
    uint32_t size;
    uint32_t reserved; /* 0 */
    uint64_t steps;    /* at least so many more, as steps are made some tens at a time; 0: no end */
    double seconds;    /* for so long, preparing too; 0: no end */
} macula_training;
/* Trains without a frame to draw meanwhile; macula_live_frame does it at rest, in turns. `training` may be
 * null: until the model rests. `model` may be null. MACULA_CANCELLED keeps what was learnt. MACULA_USAGE
 * for looks that are not path-traced, and for lights that hang on the camera. */
MACULA_API macula_status macula_live_train(macula_live* live, const macula_training* training,
                                           const macula_progress* progress, macula_model* model);
/* To the store, now; closing does it too. Returns when it is there. */
MACULA_API macula_status macula_live_save(macula_live* live, const macula_progress* progress);
/* As .macula, with which `macula train --resume` goes on; or .ply, .spz or .glb, for other programs.
 * `overwrite`, not 0: a file that is there is replaced. */
MACULA_API macula_status macula_live_write_model(macula_live* live, const char* path, int32_t overwrite,
                                                 const macula_progress* progress);
/* What was learnt is saved first, which takes a while. */
MACULA_API void macula_live_close(macula_live* live);

#ifdef __cplusplus
}
#endif

#endif
