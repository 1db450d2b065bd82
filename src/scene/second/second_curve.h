// A second volume in the same 3D picture as the study.
#pragma once

#include <optional>
#include <string>

#include "base/result.h"
#include "base/volume.h"
#include "pipeline/volume/additions.h"
#include "pipeline/volume/transfer_function.h"
#include "scene/second/beside_state.h"
#include "scene/second/second_study.h"

namespace macula::app {

// What the second volume is drawn with where nobody chose a preset: the colours and the window that it has
// over slices. The lowest quarter of the window is clear, so that what takes up nothing hides nothing; at its
// end a millimetre is as opaque as `opacity` says.
TransferFunction secondCurve(const Volume& second, const DisplayWindow& window, slices::ColourTable colours,
                             double opacity);

// Whether the state shows it in 3D: it is linked, and not hidden.
bool isIn3d(const BesideState& state);

// What of it the picture in 3D depends on; the rest is as by default. How it looks on slices does not matter
// where a preset says what it looks like there.
BesideState partIn3d(BesideState state);

// Whether both may be in one picture. Of another patient a second volume is on slices alone, where each pane
// says whose it is.
bool mayBeIn3d(const Identity& study, const Identity& second);

// As the state shows it; its preset is fitted to the volume, which may take as long as reading all of its
// voxels. `second` is stored16, and what the state is of.
SecondVolume secondIn3d(const BesideState& state, std::shared_ptr<const Volume> second);

// What pictures have to say of it, without patient data: "with PT", and whether its place is in doubt, or
// whose it is.
std::string secondRemark(const Volume& second, const BesideState& state, SamePatient patient);

}  // namespace macula::app
