// Stretches curves to the values of a volume. The preset itself never changes: each volume gets its own fit,
// and without one the preset's own numbers hold.
#pragma once

#include <string>

#include "base/message.h"
#include "base/volume.h"
#include "pipeline/volume/transfer_function.h"

namespace macula {

// value' = volume.low + (value - preset.low) / (preset.high - preset.low) * (volume.high - volume.low)
struct VolumeFit {
    ValueRange preset;  // in the preset's values
    ValueRange volume;  // in units of the volume
    TransferFunction::Fit::To to = TransferFunction::Fit::To::foreground;
    bool fromBackground = false;  // a foreground of few values: volume.low is the background

    double scale() const { return (volume.high - volume.low) / (preset.high - preset.low); }
    double operator()(double value) const { return volume.low + (value - preset.low) * scale(); }
};

// How the function's curves are stretched to the volume; nothing if the function asks for no fit. The
// foreground is all voxels, except padding, that are not below the mean of these. If it has fewer than eight
// different values, as in a mask, the curves begin at the background. The volume must be stored16.
std::optional<VolumeFit> fitOf(const TransferFunction& function, const Volume& volume);

// The function with its curves and gradients stretched to the volume; unchanged if it asks for no fit.
TransferFunction fitted(const TransferFunction& function, const Volume& volume);

// Makes the function ask for a fit of its effective range to the foreground; unchanged if it asks for one
// already. Fails with inputNotUsable if it has no effective range.
Result<TransferFunction> withFit(TransferFunction function);

// The message about the fit, for the person who looks at the picture; key "preset.fitted".
Message fitMessage(const VolumeFit& fit);

}  // namespace macula
