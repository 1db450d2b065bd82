/* The C interface of Macula: open a study, choose how it is drawn, and draw it into memory.
 *
 * NOT FOR PRIMARY DIAGNOSIS. Macula is no medical device: docs/risk.md.
 *
 * Rules of all of it
 *   - Text is UTF-8 with a 0 at the end. Text that comes back belongs to Macula; each function says how long
 * it lives.
 *   - A struct begins with its size, which the caller sets: `macula_picture picture = {sizeof picture};`.
 * Every other member may stay 0, and has its usual value then. A newer Macula takes the struct of an older
 * header.
 *   - Functions that can fail return a macula_status. macula_last_error() has the sentence for a person and
 * what to do. On failure nothing is changed, and handles that would come back are null. No C++ exception gets
 * out.
 *   - Lengths are millimetres. World is the patient's LPS: +x to the patient's left, +y to posterior, +z to
 * superior.
 *   - Handles are closed by the function of their name; null is allowed. A view holds on to its volume, so
 * the study may be closed before it.
 *   - Threads: a handle is used by one thread at a time; different handles by different threads at once. Only
 *     macula_cancel_now() may be called whenever. Calls block: run those that take a macula_progress beside
 * the thread of your user interface.
 *   - Nothing is written to a file and no session is kept. Sentences, error texts and stages name no patient;
 * titles and the `place` of an error may.
 */
#ifndef MACULA_H
#define MACULA_H

#include <stdint.h>

#if defined(__GNUC__)
#define MACULA_API __attribute__((visibility("default")))
#else
#define MACULA_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Version and errors ---- */

/* Of the library, as "0.1.0". Until 1.0.0 each minor version may change the interface, and then its SONAME.
 */
MACULA_API const char* macula_version(void);

typedef int32_t macula_status;
enum {
    MACULA_DONE = 0,
    MACULA_USAGE = 1,  /* asked for something that does not exist, or with an argument that means nothing */
    MACULA_INPUT = 2,  /* missing, unreadable, malformed or unsupported */
    MACULA_DEVICE = 3, /* no Vulkan driver, or no such device, or lost too often */
    MACULA_MEMORY = 4, /* of the host or of the device */
    MACULA_CANCELLED = 5,
    MACULA_FAULT = 6 /* of Macula itself: please report it */
};

typedef struct macula_error {
    uint32_t size;
    macula_status status;
    const char* message; /* one sentence that a radiologist understands; names no patient */
    const char* advice;  /* what to do; may be empty */
    const char*
        place; /* the file or object concerned; may be empty, may name a patient, and belongs in no log */
} macula_error;

/* The error of the last call of this thread that failed. Its texts live until the next call of this thread.
 */
MACULA_API macula_status macula_last_error(macula_error* error);

/* ---- Progress and cancellation ---- */

typedef struct macula_cancel macula_cancel;
MACULA_API macula_status macula_cancel_create(macula_cancel** cancel);
/* From any thread, for as long as the handle is open: what it was given to ends soon with MACULA_CANCELLED,
 * and so does whatever it is given to later. */
MACULA_API void macula_cancel_now(macula_cancel* cancel);
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

/* ---- Names ---- */

enum {
    MACULA_PRESETS = 0,  /* of macula_view_set_preset */
    MACULA_CLIPS = 1,    /* of macula_view_set_clip */
    MACULA_LIGHTS = 2,   /* of macula_view_set_lights */
    MACULA_LOOKS = 3,    /* of macula_view_set_look */
    MACULA_QUALITIES = 4 /* of macula_picture */
};
/* What is built in. Null for an index that is too large; names live as long as the library is loaded. */
MACULA_API const char* macula_name(int32_t kind, uint32_t index);

/* ---- Studies ---- */

typedef struct macula_study macula_study;

typedef struct macula_open {
    uint32_t size;
    int32_t join; /* not 0: take images for one series that agree in all but identifiers made anew for each of
                     them */
} macula_open;

/* A folder with DICOM files, of which the best volume is loaded; one of its images, and its own series is; a
 * DICOMDIR; a NIfTI, NRRD or MetaImage file; or "phantom:", the built-in phantom. `how` and `progress` may be
 * null. */
MACULA_API macula_status macula_study_open(const char* path, const macula_open* how,
                                           const macula_progress* progress, macula_study** study);

enum {
    MACULA_INT8 = 1,
    MACULA_UINT8 = 2,
    MACULA_INT16 = 3,
    MACULA_UINT16 = 4,
    MACULA_INT32 = 5,
    MACULA_UINT32 = 6,
    MACULA_FLOAT32 = 7,
    MACULA_FLOAT64 = 8
};
enum {
    MACULA_UNIT_NONE = 0, /* the scanner's own numbers */
    MACULA_UNIT_HOUNSFIELD = 1
};

/* A volume in memory. All of it is copied. */
typedef struct macula_voxels {
    uint32_t size;
    int32_t type;    /* MACULA_INT16 ... */
    int32_t columns; /* i, the fastest; each side 2 or more */
    int32_t rows;    /* j */
    int32_t slices;  /* k */
    int32_t unit;    /* MACULA_UNIT_HOUNSFIELD ... */
    const void* data;
    uint64_t bytes; /* of data, all of them: columns * rows * slices * size of the type */
    double slope;   /* value = slope * voxel + intercept; a slope of 0 means 1 */
    double intercept;
    /* Row by row: (x, y, z, 1) in patient LPS mm = this * (i, j, k, 1) at the centre of a voxel. The last row
     * is 0 0 0 1. May be oblique, anisotropic, sheared, mirrored: the patient's left stays the patient's
     * left. */
    double patient_from_voxel[16];
} macula_voxels;
MACULA_API macula_status macula_study_of_voxels(const macula_voxels* voxels, const macula_progress* progress,
                                                macula_study** study);

/* How many volumes the study has, at least 1. */
MACULA_API uint32_t macula_study_volumes(const macula_study* study);
/* A line for a person, which may name the patient where there are several. Null for an index that is too
 * large. Lives as long as the study. */
MACULA_API const char* macula_study_title(const macula_study* study, uint32_t index);
/* Loads another volume of the study in place of the one that is loaded. Views of that one stay as they are.
 */
MACULA_API macula_status macula_study_choose(macula_study* study, uint32_t index,
                                             const macula_progress* progress);
/* Sentences on what was assumed, left out or repaired in the volume that is loaded: show them. Null for an
 * index that is too large. Live until another volume is chosen or the study is closed. */
MACULA_API const char* macula_study_note(const macula_study* study, uint32_t index);

/* The volume that is loaded. */
typedef struct macula_volume {
    uint32_t size;
    uint32_t index; /* among the volumes of the study */
    int32_t columns;
    int32_t rows;
    int32_t slices;
    int32_t unit; /* MACULA_UNIT_NONE for every unit but HU: see unit_name */
    const char*
        unit_name; /* for a person: "HU", "SUV"; empty for numbers without one. As long as the volume */
    const char* modality;          /* "CT"; may be empty. As long as the volume */
    double low;                    /* the smallest value that is no padding; NaN where all is padding */
    double high;                   /* the largest */
    double spacing_mm[3];          /* between the centres of voxels along i, j, k */
    double patient_from_voxel[16]; /* as in macula_voxels */
} macula_volume;
MACULA_API macula_status macula_study_volume(const macula_study* study, macula_volume* volume);
/* The values, in its unit, i fastest; `count` is columns * rows * slices. Padding is what the file has there.
 * Values are those that are drawn, of 16 bits: where that rounds them, a note says so. */
MACULA_API macula_status macula_study_values(const macula_study* study, float* values, uint64_t count);

MACULA_API void macula_study_close(macula_study* study);

/* ---- Views: what of a volume is drawn, and how ---- */

typedef struct macula_view macula_view;

/* Of the volume that is loaded now: all of it, from the front, with the preset for what the series shows. */
MACULA_API macula_status macula_view_create(const macula_study* study, macula_view** view);
/* By name, number or file, as --preset of `macula render`; null: the one for what the series shows. `fit`,
 * not 0: its range is stretched to the volume, for MR. */
MACULA_API macula_status macula_view_set_preset(macula_view* view, const char* preset, int32_t fit);
/* "cinematic", "clear", "dvr", "mip", "minip", "average"; null: "cinematic". */
MACULA_API macula_status macula_view_set_look(macula_view* view, const char* look);
/* By name, file, or HDR or EXR panorama; null: those for the look. */
MACULA_API macula_status macula_view_set_lights(macula_view* view, const char* lights);
/* Of mip, minip and average: black at centre - width / 2, white at centre + width / 2. A width of 0: that of
 * the preset that was set, or of the series. */
MACULA_API macula_status macula_view_set_window(macula_view* view, double centre, double width);
/* By name or file; null: nothing is clipped. Replaces a box. */
MACULA_API macula_status macula_view_set_clip(macula_view* view, const char* clip);
/* Shows what lies between two corners, along the patient's axes. Replaces any clip. */
MACULA_API macula_status macula_view_set_box(macula_view* view, const double low_mm[3],
                                             const double high_mm[3]);
/* `remove`, not 0: the table of a CT, and what else lies beside the patient, is left out. What went is a
 * note. */
MACULA_API macula_status macula_view_remove_table(macula_view* view, int32_t remove);

typedef struct macula_camera {
    uint32_t size;
    uint32_t reserved; /* 0 */
    double position_mm[3];
    double target_mm[3];
    double up[3];              /* not parallel to the view */
    double vertical_fov_deg;   /* 0: 30 */
    double parallel_height_mm; /* above 0: rays are parallel, and the picture is so high */
} macula_camera;
MACULA_API macula_status macula_view_set_camera(macula_view* view, const macula_camera* camera);
/* "anterior", "posterior", "left", "right", "superior", "inferior": where the viewer stands; what is seen
 * fills the picture. null: "anterior". Replaces a camera. From the front, the patient's left is at the right
 * of the picture. */
MACULA_API macula_status macula_view_set_direction(macula_view* view, const char* direction);
MACULA_API void macula_view_close(macula_view* view);

/* ---- Drawing ---- */

typedef struct macula_device macula_device;

/* By its number or a part of its name; null: MACULA_DEVICE of the environment, or else the best. Without a
 * graphics card, Mesa's lavapipe draws on the CPU. */
MACULA_API macula_status macula_device_open(const char* preferred, macula_device** device);
MACULA_API void macula_device_close(macula_device* device);

enum {
    MACULA_AS_QUALITY = 0, /* of a quality, or else not denoised */
    MACULA_DENOISED = 1,
    MACULA_PLAIN = 2
};

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

/* `drawn` may be null. Blocks; MACULA_CANCELLED leaves the pixels as they were. */
MACULA_API macula_status macula_draw(macula_device* device, macula_view* view, const macula_picture* picture,
                                     const macula_progress* progress, macula_drawn* drawn);
/* Sentences that whoever sees the last picture should know: show them. Null for an index that is too large.
 * Live until the view is drawn again or closed. */
MACULA_API const char* macula_view_note(const macula_view* view, uint32_t index);

#ifdef __cplusplus
}
#endif

#endif
