/* Where the viewer of a picture stands. */
#ifndef MACULA_CAMERA_H
#define MACULA_CAMERA_H

#include <stdint.h>

#include "status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Where the viewer stands, in patient LPS mm. */
typedef struct macula_camera {
    uint32_t size;
    uint32_t reserved; /* 0 */
    double position_mm[3];
    double target_mm[3];
    double up[3];              /* not parallel to the view */
    double vertical_fov_deg;   /* 0: 30 */
    double parallel_height_mm; /* above 0: rays are parallel, and the picture is as high as this */
} macula_camera;

#ifdef __cplusplus
}
#endif

#endif
