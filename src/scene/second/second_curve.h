// A second volume in the same 3D picture as the study.
#pragma once

#include <optional>
#include <string>

#include "base/result.h"
#include "base/volume.h"
#include "pipeline/volume/additions.h"
#include "pipeline/volume/transfer_function.h"
#include "scene/second/second_study.h"
#include "scene/second/second_volume_state.h"

namespace macula::scene {

// The transfer function of a second volume without a preset: the colours and the window used over slices. The
// lowest quarter of the window is clear, so that regions without uptake hide nothing; at its upper end the
// opacity of a millimetre is 0.95 * `opacity`.
TransferFunction secondCurve(const Volume& second, const DisplayWindow& window, slices::ColourTable colours,
                             double opacity);

// Whether the state shows the second volume in 3D: in3d is set, and it is linked and not hidden.
bool isSecondIn3d(const SecondVolumeState& state);

// The state with defaults in the fields that the 3D picture does not depend on: view, boundMm, rivalMm,
// isodoses, and, if it has a preset, window, opacity and colours.
SecondVolumeState secondPartIn3d(SecondVolumeState state);

// Whether both may be in one picture. Only slices show a second volume of another patient; there each pane
// names its patient.
bool maySecondBeIn3d(const study::Identity& study, const study::Identity& second);

// The second volume as the state shows it. Fitting its preset may take as long as reading all voxels.
// `second` is stored16, and the volume that the state names.
DrawnSecondVolume secondIn3d(const SecondVolumeState& state, std::shared_ptr<const Volume> second);

// The remark for pictures, without patient data: "with PT", and whether the registration is doubtful, or the
// patient is, or may be, another.
Text secondRemark(const Volume& second, const SecondVolumeState& state, study::SamePatient patient);

}  // namespace macula::scene
