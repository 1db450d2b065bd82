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
    MACULA_MODEL_NONE = 0,      /* nothing was shown or trained yet, or what is shown can have no model */
    MACULA_MODEL_SEARCHING = 1, /* for a stored model, or for points to begin with */
    MACULA_MODEL_RESUMING = 2,  /* the stored model is drawn, while the rest of it is read */
    MACULA_MODEL_LEARNING = 3,
    MACULA_MODEL_RESTING = 4, /* it has learnt what its pictures can teach it */
    MACULA_MODEL_NOTHING_TO_SEE = 5,
    MACULA_MODEL_NO_ROOM = 6, /* the device has no memory for it */
    MACULA_MODEL_FAILED = 7
};

/* The state of the model. */
typedef struct macula_model {
    uint32_t size;
    int32_t stage;      /* MACULA_MODEL_NONE ... */
    int32_t is_resumed; /* it was in the store, or was shown before */
    uint32_t splats;
    uint64_t steps;         /* since training began, earlier runs included */
    uint64_t views;         /* pictures that it has learnt from or is judged by */
    double error;           /* mean difference from held-out pictures; NaN: not known yet */
    double seconds;         /* of training since the live picture was opened */
    const char* stage_name; /* texts live as long as the library is loaded */
    const char* origin;     /* why the model is new or resumed, for a person */
} macula_model;
/* Fills in the state of the model of what is shown. */
MACULA_API macula_status macula_live_model(const macula_live* live, macula_model* model);

/* When training stops: at the first of these limits, or as soon as the model rests. */
typedef struct macula_training {
    uint32_t size;
    uint32_t reserved; /* 0 */
    uint64_t steps;    /* at least so many more, because some tens are taken at a time; 0: no limit */
    double seconds;    /* including preparation; 0: no limit */
} macula_training;
/* Trains without drawing frames; macula_live_frame trains too, at rest, in turns with tracing. `training` may
 * be null: until the model rests. `model` may be null. MACULA_CANCELLED keeps what was learnt. MACULA_USAGE
 * for looks that are not path-traced, and for lights that move with the camera. */
MACULA_API macula_status macula_live_train(macula_live* live, const macula_training* training,
                                           const macula_progress* progress, macula_model* model);
/* Stores the model now; closing does so too. Returns when it is on disk. */
MACULA_API macula_status macula_live_save(macula_live* live, const macula_progress* progress);
/* Writes the model as .macula, which `macula train --resume` goes on with, or as .ply, .spz or .glb for other
 * programs. If `overwrite` is not 0, replaces an existing file. */
MACULA_API macula_status macula_live_write_model(macula_live* live, const char* path, int32_t overwrite,
                                                 const macula_progress* progress);
/* Stores what was learnt first, which takes a while. */
MACULA_API void macula_live_close(macula_live* live);

#ifdef __cplusplus
}
#endif

#endif
