// Curves made for other numbers, stretched to those of a volume. The preset itself is never changed: a fit is
// made anew for each volume, and leaving it out gives the preset's own numbers back.
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
    bool fromBackground = false;  // of a foreground with few values: volume.low is what lies below it

    double scale() const { return (volume.high - volume.low) / (preset.high - preset.low); }
    double operator()(double value) const { return volume.low + (value - preset.low) * scale(); }
};

// Where the function's curves fall on the volume; nothing when it asks for no fit. The foreground are the
// voxels that are not padding and not below the mean of all that are not; where these have fewer than eight
// values, as in a mask, the curves begin at the background. The volume must be stored16.
std::optional<VolumeFit> fitOf(const TransferFunction& function, const Volume& volume);

// The function with its curves stretched to the volume, its gradients with them, or itself when it asks for
// no fit.
TransferFunction fitted(const TransferFunction& function, const Volume& volume);

// The function, asking for a fit of its effective range to the foreground; as it is when it asks for one.
// Fails with inputNotUsable when it has no effective range.
Result<TransferFunction> withFit(TransferFunction function);

// What was done, for the person who looks at the picture; key "preset.fitted".
Message fitMessage(const VolumeFit& fit);

}  // namespace macula
