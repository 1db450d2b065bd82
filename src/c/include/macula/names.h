/* What is built in: presets, clips, lights, looks and qualities. */
#ifndef MACULA_NAMES_H
#define MACULA_NAMES_H

#include <stdint.h>

#include "status.h"

#ifdef __cplusplus
extern "C" {
#endif

enum {
    MACULA_PRESETS = 0,  /* for macula_view_set_preset */
    MACULA_CLIPS = 1,    /* for macula_view_set_clip */
    MACULA_LIGHTS = 2,   /* for macula_view_set_lights */
    MACULA_LOOKS = 3,    /* for macula_view_set_look */
    MACULA_QUALITIES = 4 /* for macula_picture */
};
/* A built-in name. Null if the index is too large; names live as long as the library is loaded. */
MACULA_API const char* macula_name(int32_t kind, uint32_t index);
/* Everything that is built in, with titles and what presets are for (modality, unit), as JSON: what `macula
 * presets --json` writes. Lives as long as the library is loaded. */
MACULA_API macula_status macula_built_in(const char** json);

#ifdef __cplusplus
}
#endif

#endif
