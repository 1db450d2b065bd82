/* The live picture, frame by frame. While a hand or a head moves, it shows splats of a model that it learns
 * on the way, with a traced part where the eye looks; or smaller traced pictures, until a model has learnt
 * for 120 steps. At rest it is traced, until nothing changes any more. Show your user what macula_shown says
 * about it. */
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
    /* The folder where models are kept between runs, created if it is missing. Empty: that of the viewer;
     * null: models are not kept. It names patients by digests only: docs/privacy.md. If it cannot be used,
     * frames are drawn all the same, with a note, and macula_live_save fails. */
    const char* store;
    uint64_t store_bytes; /* for all models in it; the least recently used are removed; 0: 2 GB */
} macula_live_options;

/* Opens a live picture of what the view shows now. If the store has a model of exactly that, the model goes
 * on learning. `options` may be null. You may use and close the view and the device meanwhile: the live
 * picture opens the device again, or shares a lent one. */
MACULA_API macula_status macula_live_open(const macula_device* device, const macula_view* view,
                                          const macula_live_options* options, const macula_progress* progress,
                                          macula_live** live);
/* From now on shows what that view shows now, of the same study or another. What was learnt about the
 * previous scene is kept. On failure the live picture stays as it was. */
MACULA_API macula_status macula_live_show(macula_live* live, const macula_view* view,
                                          const macula_progress* progress);

/* The frame that you want, and where its pixels go. */
typedef struct macula_frame {
    uint32_t size;
    int32_t width; /* pixels, 1 to 16384 */
    int32_t height;
    int32_t is_moving;           /* not 0: a hand or a head moves; be fast */
    const macula_camera* camera; /* null: that of the view */
    double gaze[2];              /* where the eye looks, -1 to 1; right and up are positive */
    double for_about_ms;         /* 0: a little. The first picture of a pose may take longer */
    /* Where the pixels go, as in macula_picture; or null. */
    uint8_t* rgba;
    uint64_t bytes;
    uint64_t row_bytes;
    const macula_lent_image* image;    /* also to this; or null. Complete when the call returns */
    const macula_shared_image* shared; /* also to this, which has the size of the frame; or null */
} macula_frame;

enum {
    MACULA_SHOWN_SMALL = 1,  /* traced, smaller than wanted */
    MACULA_SHOWN_MODEL = 2,  /* splats, and perhaps a traced part where the eye looks */
    MACULA_SHOWN_FADING = 3, /* splats that fade into the traced picture */
    MACULA_SHOWN_TRACED = 4  /* all pixels, not yet all samples unless it is final */
};

/* What the frame shows. Texts live until the next call for this handle. */
typedef struct macula_shown {
    uint32_t size;
    int32_t picture;  /* MACULA_SHOWN_SMALL ... */
    int32_t is_final; /* the picture stays as it is until you ask for another */
    int32_t is_new;   /* 0: it is still the picture of the previous frame */
    int32_t is_denoised;
    int32_t scale;            /* pixels of the frame per drawn pixel, each way */
    double samples_per_pixel; /* of the traced pixels */
    double noise;             /* estimated, of black to white; infinite before it is known, 0 for splats */
    double latency_ms;        /* from the call to the picture */
    double fovea_age_ms;      /* of the traced part over splats; below 0: there is none */
    const char* fidelity;     /* how this differs from a complete traced picture, for a person; or empty */
    const char* device;
    macula_camera camera; /* that it was drawn with; its size is set */
} macula_shown;

/* Draws the next frame; `shown` may be null. MACULA_CANCELLED leaves the pixels as they were. */
MACULA_API macula_status macula_live_frame(macula_live* live, const macula_frame* frame,
                                           const macula_progress* progress, macula_shown* shown);
/* Sentences that whoever sees the last frame should know: show them. Null if the index is too large. They
 * live until another function is called for this handle. */
MACULA_API const char* macula_live_note(const macula_live* live, uint32_t index);

/* Where the time of the calls for this handle went, as JSON: a list of {"stage", "times", "ms", "waitedMs",
 * "longestMs"}, the longest first. Lives until the next call for this handle other than macula_live_note. */
MACULA_API macula_status macula_live_times(macula_live* live, const char** json);

#ifdef __cplusplus
}
#endif

#endif
