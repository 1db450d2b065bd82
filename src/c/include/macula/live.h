/* The live picture, frame by frame: while a hand or a head moves, splats of a model that is learnt on the
 * way, with a traced part where the eye looks, or smaller traced pictures until a model has learnt for 120
 * steps; at rest traced, until nothing changes any more. Show what macula_shown says of it. */
#ifndef MACULA_LIVE_H
#define MACULA_LIVE_H

#include <stdint.h>

#include "camera.h"
#include "device.h"
#include "progress.h"
#include "shared_image.h"
#include "status.h"
#include "view.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct macula_live macula_live;

enum { MACULA_WITH_MODEL = 0, MACULA_WITHOUT_MODEL = 1 };

/* How a live picture is opened. */
typedef struct macula_live_options {
    uint32_t size;
    int32_t model; /* MACULA_WITH_MODEL ... */
    /* The folder where models are kept between runs, which is made where it is missing; empty: that of the
     * viewer; null: none is kept. Patients are digests there: docs/privacy.md. Where it cannot be used there
     * is a picture all the same, with a note, and macula_live_save fails. */
    const char* store;
    uint64_t store_bytes; /* of all models in it, the least recently used go; 0: 2 GB */
} macula_live_options;

/* Of what the view shows now. A model of just that which is in the store is gone on with. `options` may be
 * null. View and device may be used and closed before it: it opens the device once more, or shares the one
 * that is lent. */
MACULA_API macula_status macula_live_open(const macula_device* device, const macula_view* view,
                                          const macula_live_options* options, const macula_progress* progress,
                                          macula_live** live);
/* From now on what that view shows now, of the same study or another. What was learnt of the one before is
 * kept. On failure it stays what it was. */
MACULA_API macula_status macula_live_show(macula_live* live, const macula_view* view,
                                          const macula_progress* progress);

/* What frame is wanted, and where to. */
typedef struct macula_frame {
    uint32_t size;
    int32_t width; /* pixels, 1 to 16384 */
    int32_t height;
    int32_t is_moving;           /* not 0: a hand or a head moves; be fast */
    const macula_camera* camera; /* null: that of the view */
    double gaze[2];              /* where the eye looks, -1 to 1; right and up are positive */
    double for_about_ms;         /* time for it; 0: a little. The first picture of a pose may take longer */
    /* Where to: as in macula_picture, or null. */
    uint8_t* rgba;
    uint64_t bytes;
    uint64_t row_bytes;
    const macula_lent_image* image;    /* and to; or null. It is there when the call returns */
    const macula_shared_image* shared; /* and to, of the size of the frame; or null */
} macula_frame;

enum {
    MACULA_SHOWN_SMALL = 1,  /* traced, smaller than wanted */
    MACULA_SHOWN_MODEL = 2,  /* splats, and perhaps a traced part where the eye looks */
    MACULA_SHOWN_FADING = 3, /* splats that fade into what is traced */
    MACULA_SHOWN_TRACED = 4  /* all pixels, not yet all samples unless it is final */
};

/* What the frame shows. Texts live until the next call for this handle. */
typedef struct macula_shown {
    uint32_t size;
    int32_t picture;  /* MACULA_SHOWN_SMALL ... */
    int32_t is_final; /* nothing changes until something else is asked for */
    int32_t is_new;   /* 0: it is the picture of the frame before */
    int32_t is_denoised;
    int32_t scale;            /* pixels of the frame for one that was drawn, each way */
    double samples_per_pixel; /* of what is traced */
    double noise;             /* estimated, of black to white; infinite before it is known, 0 for splats */
    double latency_ms;        /* from the call to the picture */
    double fovea_age_ms;      /* of the traced part over splats; below 0: there is none */
    const char* fidelity; /* what lies between this and a traced picture, for a person; empty for that one */
    const char* device;
    macula_camera camera; /* that it was drawn with; its size is set */
} macula_shown;

/* The next frame; `shown` may be null. MACULA_CANCELLED leaves the pixels as they were. */
MACULA_API macula_status macula_live_frame(macula_live* live, const macula_frame* frame,
                                           const macula_progress* progress, macula_shown* shown);
/* Sentences that whoever sees the last frame should know: show them. Null for an index that is too large.
 * Live until the next call for this handle but this. */
MACULA_API const char* macula_live_note(const macula_live* live, uint32_t index);

/* Where the time of the calls for this handle went, as JSON: a list of {"stage", "times", "ms", "waitedMs",
 * "longestMs"}, the longest first. Lives until the next call for this handle but macula_live_note. */
MACULA_API macula_status macula_live_times(macula_live* live, const char** json);

#ifdef __cplusplus
}
#endif

#endif
