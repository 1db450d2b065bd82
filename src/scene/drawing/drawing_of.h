// From what was chosen to what is drawn.
#pragma once

#include <memory>
#include <string>

#include "base/volume.h"
#include "pipeline/trace/look.h"
#include "pipeline/volume/additions.h"
#include "pipeline/volume/clip.h"
#include "scene/choice/catalogue.h"
#include "scene/drawing/drawing.h"
#include "scene/drawing/projection_windows.h"
#include "scene/state/study_state.h"

namespace macula::app {

// The settings that a state is drawn with: a ray cast is shaded where the preset asks for it and somebody did
// not say no, and a projection is seen through the window that somebody set, or else that of the series.
// Without a volume, there is no window.
trace::Settings settingsOf(const StudyState& state, const SeriesWindows& seriesWindows, const Volume* volume);

// The drawing of the volume that is open, or none. `clip` is what clipOf makes of the state: made once for
// each change, as it may be as large as the volume. What is not chosen is taken from the catalogue and from
// the volume. Remarks say what has to be known of pictures of it: "shaded", "W 400 L 40 HU", what the
// mask leaves out, "clipped", and each number that is not what it is by default, "exposure 3", or in the
// preset that an edited one was copied from: "roughness 0.2"; but for
// gradients, which change with the width of the curve.
Drawing drawingOf(const StudyState& state, const Catalogue& catalogue, const SeriesWindows& seriesWindows,
                  const std::shared_ptr<const Volume>& volume, std::shared_ptr<const Clip> clip);

// What has to be said of a picture with these additions in that look: nothing of a projection, which does not
// draw them.
std::string remarkOf(const Additions& additions, trace::Look look);

// Puts them into the drawing, with the remark. Null: there are none. A projection keeps them, though it does
// not draw them: so they are there when the look changes back.
void setAdditions(Drawing& drawing, std::shared_ptr<const Additions> additions);

// The clip of the state with `mask`, if anything is hidden; else null.
std::shared_ptr<const Clip> clipOf(const StudyState& state, const Volume& volume, std::optional<Mask> mask);

}  // namespace macula::app
