// Makes the drawing of a study from its state.
#pragma once

#include <memory>
#include <string>

#include "base/text.h"
#include "base/volume.h"
#include "pipeline/trace/look.h"
#include "pipeline/volume/additions.h"
#include "pipeline/volume/clip.h"
#include "scene/choice/catalogue.h"
#include "scene/drawing/drawing.h"
#include "scene/drawing/projection_windows.h"
#include "scene/state/study_state.h"

namespace macula::scene {

// The settings that a state is drawn with: a ray cast is shaded if both the preset and the state ask for it,
// and a projection has the window of the state, otherwise that of the series. Without a volume no window is
// set.
trace::Settings settingsOf(const StudyState& state, const SeriesWindows& seriesWindows, const Volume* volume);

// The drawing of the open volume, or of none. `clip` is clipOf the state, made once per change because it may
// be as large as the volume. Without lights the catalogue's default for the look is used. Remarks say what a
// user must know about pictures of it: "shaded", "W 400 L 40 HU", "hues kept", what the mask leaves out,
// "clipped", each setting that is not at its default ("exposure 3"), and for a path-traced look each number
// of an edited preset that its original does not have ("roughness 0.2"), except gradients, which change with
// the width of the curve.
Drawing drawingOf(const StudyState& state, const Catalogue& catalogue, const SeriesWindows& seriesWindows,
                  const std::shared_ptr<const Volume>& volume, std::shared_ptr<const Clip> clip);

// The remark on these additions for a picture of that look; empty for a projection, which does not draw them.
Text remarkOf(const Additions& additions, trace::Look look);

// Sets the additions and appends their remark. Null: there are none. A projection keeps them undrawn, so that
// they are there when the look changes back.
void setAdditions(Drawing& drawing, std::shared_ptr<const Additions> additions);

// The clip of the state with `mask`, if anything is hidden; otherwise null.
std::shared_ptr<const Clip> clipOf(const StudyState& state, const Volume& volume, std::optional<Mask> mask);

}  // namespace macula::scene
