/* Views: which part of a volume is drawn, and how. */
#ifndef MACULA_VIEW_H
#define MACULA_VIEW_H

#include <stdint.h>

#include "camera.h"
#include "status.h"
#include "study.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct macula_view macula_view;

/* Makes a view of all of the volume that is loaded now, from the usual direction, with the usual preset. */
MACULA_API macula_status macula_view_create(const macula_study* study, macula_view** view);
/* Sets the preset by name, number or file, as --preset of `macula render`; null: the one that fits the
 * series. If `fit` is not 0, stretches its range to the volume, for MR. */
MACULA_API macula_status macula_view_set_preset(macula_view* view, const char* preset, int32_t fit);
/* "cinematic", "clear", "dvr", "mip", "minip", "average"; null: "cinematic". */
MACULA_API macula_status macula_view_set_look(macula_view* view, const char* look);
/* Sets the lights by name, file, or HDR or EXR panorama; null: those for the look. */
MACULA_API macula_status macula_view_set_lights(macula_view* view, const char* lights);
/* Sets the window of mip, minip and average: black at centre - width / 2, white at centre + width / 2. A
 * width of 0: the window of the preset that was set, or of the series. */
MACULA_API macula_status macula_view_set_window(macula_view* view, double centre, double width);
/* Sets the clip by name or file; null: nothing is clipped. Replaces a box. */
MACULA_API macula_status macula_view_set_clip(macula_view* view, const char* clip);
/* Shows what lies between two corners, along the patient's axes. Replaces any clip. */
MACULA_API macula_status macula_view_set_box(macula_view* view, const double low_mm[3],
                                             const double high_mm[3]);
/* If `remove` is not 0, leaves out the table of a CT, and other things next to the patient. A note says what
 * was left out. */
MACULA_API macula_status macula_view_remove_table(macula_view* view, int32_t remove);

/* Sets the camera. Replaces a direction. */
MACULA_API macula_status macula_view_set_camera(macula_view* view, const macula_camera* camera);
/* "anterior", "posterior", "left", "right", "superior", "inferior", "oblique", "three-quarter", "turned":
 * where the viewer stands; what is visible fills the picture. null: by what was scanned, as `macula render`;
 * the record of the picture says which and why. Replaces a camera. From the front, the patient's left is on
 * the right of the picture. */
MACULA_API macula_status macula_view_set_direction(macula_view* view, const char* direction);
/* Sets the colour behind the patient, as displayed: "black", "white", "grey" or "#rrggbb". null: black, and
 * nearly black in live pictures. */
MACULA_API macula_status macula_view_set_background(macula_view* view, const char* background);
/* Everything that was chosen, as the JSON of views that the viewer and --session of `macula render` save and
 * open. Lives until this is called again or the view is closed. MACULA_USAGE if the lights are a panorama. */
MACULA_API macula_status macula_view_state(macula_view* view, const char** json);
/* Replaces everything that was chosen. MACULA_INPUT if it is not a state, or is one of another series. */
MACULA_API macula_status macula_view_set_state(macula_view* view, const char* json);
/* Closes the view, and frees its texts; pictures that it drew stay. */
MACULA_API void macula_view_close(macula_view* view);

#ifdef __cplusplus
}
#endif

#endif
