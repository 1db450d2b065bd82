/* Studies: their volumes, what is known about these, and their values. */
#ifndef MACULA_STUDY_H
#define MACULA_STUDY_H

#include <stdint.h>

#include "progress.h"
#include "status.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct macula_study macula_study;

/* How a study is opened. */
typedef struct macula_open {
    uint32_t size;
    int32_t join; /* not 0: images are one series if they differ only in identifiers that were made for each
                   * of them */
    const char* series_uid; /* which series of a folder, by its UID or its number in `macula info`, "3" */
} macula_open;

/* Opens a folder of DICOM files and loads its best volume; if it has several patients, that is an error that
 * lists their series by number, unless series_uid is given. Or opens an image of a folder, and loads its
 * series; a DICOMDIR; a NIfTI, NRRD or MetaImage file; or "phantom:", the built-in volume. `how` and
 * `progress` may be null. */
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

/* A volume in memory. Macula copies all of it. */
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
/* Makes a study of that volume alone. */
MACULA_API macula_status macula_study_of_voxels(const macula_voxels* voxels, const macula_progress* progress,
                                                macula_study** study);

/* How many volumes the study has, at least 1. */
MACULA_API uint32_t macula_study_volumes(const macula_study* study);
/* The title of a volume: a line for a person, which may name the patient if there are several. Null if the
 * index is too large. Lives as long as the study. */
MACULA_API const char* macula_study_title(const macula_study* study, uint32_t index);
/* Loads another volume of the study instead of the one that is loaded, whose views stay as they are. */
MACULA_API macula_status macula_study_choose(macula_study* study, uint32_t index,
                                             const macula_progress* progress);
/* Sentences on which volume was taken, and on what was assumed, left out or repaired in it: show them. Null
 * if the index is too large. They live until another volume is chosen or the study is closed. */
MACULA_API const char* macula_study_note(const macula_study* study, uint32_t index);
/* Everything that was found in the folder, as JSON: what `macula info --json --patient` writes
 * (docs/dicom.md), with each file that was left out, and why; and "volumes", the place of each volume in it,
 * in the order of macula_study_title. It names patients. Without a folder its lists are empty. Lives until
 * this is called again, another volume is chosen, or the study is closed. */
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
        unit_name; /* for a person: "HU", "SUV"; empty for numbers without one. Lives as long as the volume */
    const char* modality;          /* "CT"; may be empty. Lives as long as the volume */
    double low;                    /* the smallest value that is not padding; NaN if all is padding */
    double high;                   /* the largest */
    double spacing_mm[3];          /* between the centres of voxels along i, j, k */
    double patient_from_voxel[16]; /* as in macula_voxels */
    /* (0020,000D), (0020,000E), (0020,0052); empty if there are none. They may lead to the patient. They live
     * as long as the volume */
    const char* study_uid;
    const char* series_uid;
    const char* frame_of_reference_uid;
    int32_t is_uncalibrated; /* spacing_mm is an estimate, and with it each length, area and volume */
    int32_t reserved;        /* 0 */
} macula_volume;
/* Describes the volume that is loaded; loads nothing. */
MACULA_API macula_status macula_study_volume(const macula_study* study, macula_volume* volume);
/* Copies the values, in the volume's unit, i fastest; `count` is columns * rows * slices. Padding is what the
 * file has there. These are the values that are drawn, of 16 bits: if that rounds them, a note says so. */
MACULA_API macula_status macula_study_values(const macula_study* study, float* values, uint64_t count);

/* Closes the study, and frees its texts; its views stay open. */
MACULA_API void macula_study_close(macula_study* study);

#ifdef __cplusplus
}
#endif

#endif
