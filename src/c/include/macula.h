/* The C interface of Macula: open a study, choose how it is drawn, draw it into memory or into an image of
 * your own device, show it live, and train, keep and resume the model that the live picture is drawn with.
 *
 * NOT FOR PRIMARY DIAGNOSIS. Macula is no medical device: docs/risk.md.
 *
 * Rules of all of it
 *   - Text is UTF-8 with a 0 at the end. Text that comes back belongs to Macula; each function says how long
 * it lives.
 *   - A struct begins with its size, which the caller sets: `macula_picture picture = {.size = sizeof
 * picture};` in C; in C++ `macula_picture picture{};` and `picture.size = sizeof picture;`. Every other
 * member may stay 0, and has its usual value then. A newer Macula takes the struct of an older header. A
 * struct for a result needs its size too.
 *   - An empty text is as null, where a function does not say otherwise.
 *   - Functions that can fail return a macula_status. macula_last_error() has the sentence for a person and
 * what to do. On failure nothing is changed, and handles come back null. No C++ exception gets out.
 *   - Lengths are millimetres. World is the patient's LPS: +x to the patient's left, +y to posterior, +z to
 * superior.
 *   - Handles are closed by the function of their name; null is allowed. A view holds on to its volume, so
 * the study may be closed before it.
 *   - Threads: calls that take a handle as const may go on at once in several threads; any other call has its
 * handles for itself. Different handles are used by different threads at once. Only macula_cancel_now() may
 * be called whenever. Calls block: run those that take a macula_progress beside the thread of your user
 * interface.
 *   - Mistakes are noticed where they can be: a handle that is closed, of another kind, or in use by another
 * call is MACULA_USAGE (no text, no number, where no status is returned), closing it once more does nothing,
 * and what is closed while a call uses it ends with that call. Do not rely on it: a new handle may be where a
 * closed one was, and handles that cancel are not watched.
 *   - Devices and live pictures are of the process that opened them: after fork() a child opens its own, and
 * leaves those open. Fork while no call is under way and no live picture is open: locks stay locked there.
 *   - Nothing is written to a file but what macula_live_open, macula_live_save and macula_live_write_model
 * are given places for. Nothing is printed: macula_log_to has the log, or stderr where MACULA_LOG is set in
 * the environment. Sentences, error texts, stages and the log name no patient; titles and the `place` of an
 * error may.
 *   - Where Macula finds a mistake of its own it does not go on with a wrong picture, and does not end your
 * program: the call returns MACULA_FAULT, and the handles that it was given are good for closing alone. Only
 * where that is found while something is closed or freed the program is ended.
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
    MACULA_FAULT = 6, /* of Macula itself: please report it */
    MACULA_OUTPUT = 7 /* a file or folder cannot be written */
};

/* Why a call failed. */
typedef struct macula_error {
    uint32_t size;
    macula_status status;
    const char* message; /* one sentence that a radiologist understands; names no patient */
    const char* advice;  /* what to do; may be empty */
    const char* place;   /* the file or object concerned, U+FFFD for what is no UTF-8 in it; may be empty, may
                            name a patient, and belongs in no log */
} macula_error;

/* The error of the last call of this thread that failed. Its texts live until the next call of this thread.
 */
MACULA_API macula_status macula_last_error(macula_error* error);

/* ---- Log ---- */

enum { MACULA_LOG_DEBUG = 0, MACULA_LOG_INFO = 1, MACULA_LOG_WARNING = 2, MACULA_LOG_ERROR = 3 };
/* A line for those who support Macula, without its end; lives for the call. From any thread, never two at
 * once. It must not call Macula, nor throw. */
typedef void (*macula_log_line)(void* user, int32_t level, const char* line);
/* From now on `told` has the lines of `least` and above, and which device was opened; null: nobody has.
 * Returns when no line is on its way to whoever had them before. */
MACULA_API macula_status macula_log_to(macula_log_line told, void* user, int32_t least);

/* ---- Progress and cancellation ---- */

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
/* All that is built in, with titles, and what presets are for (modality, unit), as JSON: what `macula presets
 * --json` writes. Lives as long as the library is loaded. */
MACULA_API macula_status macula_built_in(const char** json);

/* ---- Studies ---- */

typedef struct macula_study macula_study;

/* How a study is opened. */
typedef struct macula_open {
    uint32_t size;
    int32_t join; /* not 0: take images for one series that agree in all but identifiers made anew for each of
                     them */
    const char* series_uid; /* the series of a folder that is meant, or its number in `macula info`, "3" */
} macula_open;

/* A folder of DICOM files, of which the best volume is loaded: of several patients it is an error that lists
 * their series by number, unless series_uid is given. One of its images, and its own series is; a DICOMDIR; a
 * NIfTI, NRRD or MetaImage file; "phantom:", the built-in one. `how` and `progress` may be null. */
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
/* A study of that volume alone. */
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
/* Sentences on which volume was taken, and on what was assumed, left out or repaired in it: show them. Null
 * for an index that is too large. Live until another volume is chosen or the study is closed. */
MACULA_API const char* macula_study_note(const macula_study* study, uint32_t index);
/* All that was found in the folder, as JSON: what `macula info --json --patient` writes (docs/dicom.md), with
 * each file that was left out, and why; and "volumes", the place there of each volume, in the order of
 * macula_study_title. It names patients. Without a folder its lists are empty. Lives until this is asked
 * again, another volume is chosen, or the study is closed. */
MACULA_API macula_status macula_study_found(macula_study* study, const char** json);

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
    /* (0020,000D), (0020,000E), (0020,0052); empty where there are none. They may lead to the patient. As
     * long as the volume */
    const char* study_uid;
    const char* series_uid;
    const char* frame_of_reference_uid;
    int32_t is_uncalibrated; /* spacing_mm is an estimate, and with it each length, area and volume */
    int32_t reserved;        /* 0 */
} macula_volume;
/* What is known of it; nothing is loaded. */
MACULA_API macula_status macula_study_volume(const macula_study* study, macula_volume* volume);
/* The values, in its unit, i fastest; `count` is columns * rows * slices. Padding is what the file has there.
 * Values are those that are drawn, of 16 bits: where that rounds them, a note says so. */
MACULA_API macula_status macula_study_values(const macula_study* study, float* values, uint64_t count);

/* And what it said; views of it stay. */
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

/* Where the viewer stands, in patient LPS mm. */
typedef struct macula_camera {
    uint32_t size;
    uint32_t reserved; /* 0 */
    double position_mm[3];
    double target_mm[3];
    double up[3];              /* not parallel to the view */
    double vertical_fov_deg;   /* 0: 30 */
    double parallel_height_mm; /* above 0: rays are parallel, and the picture is so high */
} macula_camera;
/* Replaces a direction. */
MACULA_API macula_status macula_view_set_camera(macula_view* view, const macula_camera* camera);
/* "anterior", "posterior", "left", "right", "superior", "inferior": where the viewer stands; what is seen
 * fills the picture. null: "anterior". Replaces a camera. From the front, the patient's left is at the right
 * of the picture. */
MACULA_API macula_status macula_view_set_direction(macula_view* view, const char* direction);
/* All that was chosen, as the JSON of views that the viewer and --session of `macula render` save and open.
 * Lives until this is asked again or the view is closed. MACULA_USAGE for lights of a panorama. */
MACULA_API macula_status macula_view_state(macula_view* view, const char** json);
/* Takes the place of all that was chosen. MACULA_INPUT for what is no state, and for one of another series.
 */
MACULA_API macula_status macula_view_set_state(macula_view* view, const char* json);
/* And what it said; what it drew stays. */
MACULA_API void macula_view_close(macula_view* view);

/* ---- Drawing ---- */

typedef struct macula_device macula_device;

/* By its number or a part of its name; null: MACULA_DEVICE of the environment, or else the best. Without a
 * graphics card, Mesa's lavapipe draws on the CPU. */
MACULA_API macula_status macula_device_open(const char* preferred, macula_device** device);

/* Called before and after each use of a queue, by the thread that uses it. They must not call Macula, nor
 * throw. */
typedef void (*macula_queue_call)(void* user);

/* A device of yours, in place of one of Macula's own: of Vulkan 1.3, with VK_KHR_push_descriptor, and with
 * the features timelineSemaphore, scalarBlockLayout, synchronization2 and maintenance4. Nothing of it is
 * destroyed here; close what was opened with it first. */
typedef struct macula_lent_device {
    uint32_t size;
    uint32_t queue_family; /* of the queue */
    void* instance;        /* VkInstance, made for Vulkan 1.3 */
    void* physical_device; /* VkPhysicalDevice */
    void* device;          /* VkDevice */
    void* queue;           /* VkQueue, with compute */
    /* Null both: you do not use the queue while a call of Macula runs that uses this device, and lend it once
     * at a time. */
    macula_queue_call lock_queue;
    macula_queue_call unlock_queue;
    void* user; /* for both */
} macula_lent_device;
/* As macula_device_open, with that one. */
MACULA_API macula_status macula_device_lend(const macula_lent_device* lent, macula_device** device);

/* Which card and driver a device is of, to every program: VkPhysicalDeviceIDProperties, or GL_DEVICE_UUID_EXT
 * and GL_DRIVER_UUID_EXT. */
typedef struct macula_device_identity {
    uint32_t size;
    uint32_t reserved; /* 0 */
    uint8_t device_uuid[16];
    uint8_t driver_uuid[16];
} macula_device_identity;
/* So that macula_shared_memory can be of the same card. */
MACULA_API macula_status macula_device_identify(macula_device* device, macula_device_identity* identity);

/* Ends what macula_device_open or macula_device_lend began. What is opened or drawn with it goes on until its
 * own close. */
MACULA_API void macula_device_close(macula_device* device);

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

/* ---- The live picture ----
 *
 * Frame by frame: while a hand or a head moves, splats of a model that is learnt on the way, with a traced
 * part where the eye looks, or smaller traced pictures until a model has learnt for 120 steps; at rest
 * traced, until nothing changes any more. Show what macula_shown says of it. */

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

/* An image on the device that is lent: VkImage of R8G8B8A8 (UNORM, or SRGB: bits are copied), of the size of
 * the frame, with VK_IMAGE_USAGE_TRANSFER_DST_BIT, not used by others meanwhile. */
typedef struct macula_lent_image {
    uint32_t size;
    int32_t layout;    /* VkImageLayout that it is left in, 0: general; what it held before is lost */
    uint64_t image;    /* VkImage */
    uint32_t layer;    /* of the image */
    uint32_t reserved; /* 0 */
} macula_lent_image;

/* An image of yours on another device object than Macula's, of the same card: of your own VkDevice, which is
 * not lent, or of OpenGL (GL_EXT_memory_object_fd), for which a VkDevice made the memory. Describe it just as
 * it was made; a driver need not notice what is wrong. For Linux: handles of Windows are not taken.
 *
 * It is a VkImage with VkExternalMemoryImageCreateInfo of VK_EXTERNAL_MEMORY_HANDLE_TYPE_OPAQUE_FD_BIT, of
 * two dimensions, one level, one layer and one sample, VK_SHARING_MODE_EXCLUSIVE. Macula writes the whole of
 * it without acquiring it: what it held is lost. It is left released to VK_QUEUE_FAMILY_EXTERNAL in `layout`;
 * acquire it from there with that as the old and the new layout.
 *
 * Semaphores are binary VkSemaphores of VK_EXTERNAL_SEMAPHORE_HANDLE_TYPE_OPAQUE_FD_BIT, and may be missing.
 * Each frame that is delivered waits for `wait_fd` once, before it writes, and signals `signal_fd` once, when
 * it has written; a call that fails does neither, unless the device was lost. Submit the signal that it waits
 * for before the call, and the wait for what it signals before the next: a signal that never comes is waited
 * for for ever. After a call that failed it is still there for the next. Where Macula's device is lost, also
 * after a call, what it was to signal may never be: wait for your own submission with a limit of time, and
 * once that has passed share the image anew, with new semaphores. Not every device can share them: lavapipe
 * cannot. */
typedef struct macula_shared_memory {
    uint32_t size;
    int32_t memory_fd;       /* of vkGetMemoryFdKHR, above 0 */
    uint8_t device_uuid[16]; /* of the card: macula_device_identify tells Macula's */
    uint8_t driver_uuid[16];
    uint64_t bytes;       /* VkMemoryAllocateInfo: allocationSize */
    uint64_t offset;      /* bytes, where the image is bound */
    uint32_t memory_type; /* VkMemoryAllocateInfo: memoryTypeIndex */
    int32_t is_dedicated; /* not 0: with VkMemoryDedicatedAllocateInfo of the image */
    int32_t width;        /* pixels, 1 to 16384 */
    int32_t height;
    int32_t format;    /* VkFormat: R8G8B8A8, UNORM or SRGB: bits are copied, encoded for display */
    int32_t tiling;    /* VkImageTiling: optimal or linear */
    uint32_t usage;    /* VkImageUsageFlags, with TRANSFER_DST: of transfers, sampling, storage, colour */
    uint32_t flags;    /* VkImageCreateFlags: mutable format, extended usage, alias, or 0 */
    int32_t layout;    /* VkImageLayout that it is left in, 0: general */
    int32_t wait_fd;   /* of vkGetSemaphoreFdKHR, above 0; else the image may be written to at once */
    int32_t signal_fd; /* the same; else the picture is there when the call returns */
    uint32_t reserved; /* 0 */
} macula_shared_memory;

typedef struct macula_shared_image macula_shared_image;
/* Macula duplicates the file descriptors: yours stay open, and are yours to close, at once if you like. Which
 * card draws shows with the first frame, and that fails where it is another one (MACULA_USAGE), or where it
 * cannot share images, or semaphores (MACULA_DEVICE). A device that was lost and replaced has the image again
 * by itself; of semaphores see above. */
MACULA_API macula_status macula_shared_image_create(const macula_shared_memory* memory,
                                                    macula_shared_image** image);
/* What a live picture has of it goes with its next frame to another shared image, or with its close. */
MACULA_API void macula_shared_image_close(macula_shared_image* image);

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

/* ---- Its model ---- */

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
