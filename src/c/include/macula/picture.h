/* Pictures of views: drawn into memory, and what of the patient is at a place of them. */
#ifndef MACULA_PICTURE_H
#define MACULA_PICTURE_H

#include <stdint.h>

#include "camera.h"
#include "device.h"
#include "progress.h"
#include "status.h"
#include "view.h"

#ifdef __cplusplus
extern "C" {
#endif

enum {
    MACULA_AS_QUALITY = 0, /* of a quality, or else not denoised */
    MACULA_DENOISED = 1,
    MACULA_PLAIN = 2
};

/* What is to be drawn, and where to. */
typedef struct macula_picture {
    uint32_t size;
    int32_t width; /* pixels, 1 to 16384 */
    int32_t height;
    int32_t denoise;            /* MACULA_AS_QUALITY ... */
    uint32_t samples_per_pixel; /* 0: that of the quality, or else 64, or 8 for looks without chance */
    uint32_t seed;              /* the same seed on the same device gives the same picture */
    const char* quality;        /* by name or file; may be null */
    double most_noise;          /* above 0: traced until its noise, of black to white, is this small, and
                                 * samples_per_pixel is about the most */
    /* Where to: display-encoded (sRGB), red green blue alpha, the upper row first, over black; alpha is 255.
     */
    uint8_t* rgba;
    uint64_t bytes;     /* of rgba */
    uint64_t row_bytes; /* from row to row; 0: 4 * width */
    /* Of cinematic and clear: the diameter of a lens, above 0, blurs what is nearer or farther than its
     * focus; focus_mm is from the camera along its axis, 0: what the middle of the picture shows. */
    double lens_mm;
    double focus_mm;
    double fog_mm; /* above 0: what lies behind the nearest matter fades, to 37 % over so many mm; not of
                    * projections */
} macula_picture;

/* What was drawn. Texts live until the view is drawn again or closed. */
typedef struct macula_drawn {
    uint32_t size;
    int32_t is_denoised;      /* small things may be gone: see docs/risk.md */
    int32_t is_empty;         /* nothing is seen: a note says why */
    int32_t is_coarse;        /* not all voxels had room on the device: a note says how coarse */
    double samples_per_pixel; /* on average */
    double noise;             /* estimated, of black to white, before denoising */
    double seconds;
    const char* preset; /* "custom" for one of a file */
    const char* device;
    macula_camera camera; /* that it was drawn with; its size is set */
} macula_drawn;

/* `drawn` may be null. Blocks; MACULA_CANCELLED leaves the pixels as they were. The view's scene stays on the
 * device, so that its next picture takes little more than its samples, until another view is drawn there or
 * one of both is closed. With a table left out or voxels cut, all but the voxels is made anew. No thread
 * closes a view that was drawn on a lent device while another closes the device. */
MACULA_API macula_status macula_draw(macula_device* device, macula_view* view, const macula_picture* picture,
                                     const macula_progress* progress, macula_drawn* drawn);
/* Sentences that whoever sees the last picture should know: show them. Null for an index that is too large.
 * Live until the view is drawn again or closed. */
MACULA_API const char* macula_view_note(const macula_view* view, uint32_t index);

/* A place in a picture of a view. */
typedef struct macula_pick {
    uint32_t size;
    int32_t width; /* of the picture, pixels */
    int32_t height;
    uint32_t reserved; /* 0 */
    double x;          /* pixels from the left edge of the picture: 0.5 is the middle of the first */
    double y;          /* from the upper edge */
    const macula_camera* camera; /* of the picture; null: of the last that macula_draw drew of the view */
} macula_pick;

/* What is there. */
typedef struct macula_picked {
    uint32_t size;
    int32_t is_something; /* 0: nothing that is seen */
    double point_mm[3];   /* patient LPS, on the first matter that is seen; of mip and minip where their value
                             is */
} macula_picked;
/* What of the patient is at a place of a picture, found in the volume and not in a model, with the preset,
 * clip and look that the view has now. Some 20 ms, no device; longer for a preset that is fitted, and for a
 * table that is left out. */
MACULA_API macula_status macula_view_pick(const macula_view* view, const macula_pick* pick,
                                          const macula_progress* progress, macula_picked* picked);

/* How the last picture was made, as JSON: what `macula render --json` writes. Lives until the view is drawn
 * again or closed. MACULA_USAGE before the first. */
MACULA_API macula_status macula_view_record(const macula_view* view, const char** json);

#ifdef __cplusplus
}
#endif

#endif
