/* Pictures of views: draws them into memory, and finds what of the patient a place in them shows. */
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
    MACULA_AS_QUALITY = 0, /* as the quality says; without one, not denoised */
    MACULA_DENOISED = 1,
    MACULA_PLAIN = 2
};

/* The picture to draw, and where its pixels go. */
typedef struct macula_picture {
    uint32_t size;
    int32_t width; /* pixels, 1 to 16384 */
    int32_t height;
    int32_t denoise;            /* MACULA_AS_QUALITY ... */
    uint32_t samples_per_pixel; /* 0: that of the quality; without one 64, or 8 for looks without noise */
    uint32_t seed;              /* the same seed on the same device gives the same picture */
    const char* quality;        /* by name or file; may be null */
    double most_noise;          /* above 0: traces until the noise, as a share of black to white, is this
                                 * small, with about samples_per_pixel at most */
    /* Where the pixels go: display-encoded (sRGB), red green blue alpha, the top row first, over the
     * background of the view; alpha is 255. */
    uint8_t* rgba;
    uint64_t bytes;     /* of rgba */
    uint64_t row_bytes; /* from row to row; 0: 4 * width */
    /* For cinematic and clear: a lens of this diameter, above 0, blurs what is nearer or farther than its
     * focus; focus_mm is the distance from the camera along its axis, 0: that of what the middle of the
     * picture shows. */
    double lens_mm;
    double focus_mm;
    double fog_mm; /* above 0: what lies behind the nearest matter fades, to 37 % over so many mm; not in
                    * projections */
} macula_picture;

/* What was drawn. Texts live until the view is drawn again or closed. */
typedef struct macula_drawn {
    uint32_t size;
    int32_t is_denoised;      /* small things may be gone: see docs/risk.md */
    int32_t is_empty;         /* nothing is visible: a note says why */
    int32_t is_coarse;        /* not all voxels had room on the device: a note says how coarse */
    double samples_per_pixel; /* on average */
    double noise;             /* estimated, of black to white, before denoising */
    double seconds;
    const char* preset; /* "custom" for one from a file */
    const char* device;
    macula_camera camera; /* that it was drawn with; its size is set */
} macula_drawn;

/* Draws the view. `drawn` may be null. Blocks; MACULA_CANCELLED leaves the pixels as they were. The scene
 * stays on the device, so that the view's next picture takes little more than its samples, until another view
 * is drawn there, or the view or the device is closed. If a table is left out or voxels are cut, all but the
 * voxels is made again. No thread may close a view that was drawn on a lent device while another closes the
 * device. */
MACULA_API macula_status macula_draw(macula_device* device, macula_view* view, const macula_picture* picture,
                                     const macula_progress* progress, macula_drawn* drawn);
/* Sentences that whoever sees the last picture should know: show them. Null if the index is too large. They
 * live until the view is drawn again or closed. */
MACULA_API const char* macula_view_note(const macula_view* view, uint32_t index);

/* A place in a picture of a view. */
typedef struct macula_pick {
    uint32_t size;
    int32_t width; /* of the picture, pixels */
    int32_t height;
    uint32_t reserved; /* 0 */
    double x;          /* pixels from the left edge of the picture: 0.5 is the centre of the first */
    double y;          /* from the upper edge */
    const macula_camera* camera; /* of the picture; null: that of the view's last picture by macula_draw */
} macula_pick;

/* What a place shows. */
typedef struct macula_picked {
    uint32_t size;
    int32_t is_something; /* 0: nothing is visible there */
    double point_mm[3];   /* patient LPS, on the first visible matter; for mip and minip, where their value
                           * lies */
} macula_picked;
/* Finds what of the patient a place in a picture shows: in the volume, not in a model, with the preset, clip
 * and look that the view has now. Takes some 20 ms and no device; longer if a preset is fitted or a table is
 * left out. */
MACULA_API macula_status macula_view_pick(const macula_view* view, const macula_pick* pick,
                                          const macula_progress* progress, macula_picked* picked);

/* How the last picture was made, as JSON: what `macula render --json` writes. Lives until the view is drawn
 * again or closed. MACULA_USAGE before the first. */
MACULA_API macula_status macula_view_record(const macula_view* view, const char** json);

#ifdef __cplusplus
}
#endif

#endif
