// Transfer functions as palettes of presentation states, and back.
#pragma once

#include "dicom/presentation/volume_presentation.h"
#include "pipeline/volume/transfer_function.h"

namespace macula::app {

// Over all points of the curves, at each whole value where they span enough of them; colours with the albedo
// in them, opacities of a layer of layerMmOf. The function is fitted to its volume already. Steps become as
// steep as entries lie close. The gradient opacity is left out.
dicom::Palette paletteOf(const TransferFunction& function);

// In which matter of its opacities is as dense as it is drawn: the denser, the thinner.
double layerMmOf(const TransferFunction& function);

// Curves with as few points as come within a level of 65535 of each entry. A palette without colours is from
// black to white, one without alpha from clear to opaque. `layerMm` is what its opacities are of.
TransferFunction transferOf(const dicom::Palette& palette, double layerMm);

}  // namespace macula::app
