/* Views: what of a volume is drawn, and how. */
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

/* Of the volume that is loaded now: all of it, from the usual direction, with the usual preset. */
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

/* Replaces a direction. */
MACULA_API macula_status macula_view_set_camera(macula_view* view, const macula_camera* camera);
/* "anterior", "posterior", "left", "right", "superior", "inferior", "oblique", "three-quarter", "turned":
 * where the viewer stands; what is seen fills the picture. null: by what was scanned, as `macula render`; the
 * record of the picture tells which and why. Replaces a camera. From the front, the patient's left is at the
 * right of the picture. */
MACULA_API macula_status macula_view_set_direction(macula_view* view, const char* direction);
/* Behind the patient, as it is displayed: "black", "white", "grey" or "#rrggbb". null: black, and nearly
 * black in live pictures. */
MACULA_API macula_status macula_view_set_background(macula_view* view, const char* background);
/* All that was chosen, as the JSON of views that the viewer and --session of `macula render` save and open.
 * Lives until this is asked again or the view is closed. MACULA_USAGE for lights of a panorama. */
MACULA_API macula_status macula_view_state(macula_view* view, const char** json);
/* Takes the place of all that was chosen. MACULA_INPUT for what is no state, and for one of another series.
 */
MACULA_API macula_status macula_view_set_state(macula_view* view, const char* json);
/* And what it said; what it drew stays. */
MACULA_API void macula_view_close(macula_view* view);

#ifdef __cplusplus
}
#endif

#endif
