// Transfer functions as palettes of presentation states, and back.
#pragma once

#include "dicom/presentation/volume_presentation.h"
#include "pipeline/volume/transfer_function.h"

namespace macula::scene {

// Samples the curves from their first to their last point, at each whole value if these span 16 to 65535.
// Colours include the albedo; opacities are those of a layer of layerMmOf() millimetres. `function` is
// already fitted to its volume. A step becomes a ramp between two entries. The gradient opacity is left out.
dicom::Palette paletteOf(const TransferFunction& function);

// Thickness of the layer whose opacities the palette holds: unitDistanceMm / density.
double layerMmOf(const TransferFunction& function);

// Fits curves of few points that stay within a level of 65535 of each entry. A palette without colours goes
// from black to white, one without alpha from clear to opaque. Its opacities are those of a layer `layerMm`
// thick.
TransferFunction transferOf(const dicom::Palette& palette, double layerMm);

}  // namespace macula::scene
