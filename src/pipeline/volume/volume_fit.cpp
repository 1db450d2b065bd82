#include "pipeline/volume/volume_fit.h"

#include <algorithm>

namespace macula {

namespace {

constexpr double kLowPercentile = 0.02;
constexpr double kHighPercentile = 0.98;

// The foreground is not below the mean of all voxels except padding. Air is the lowest and largest peak of
// every MR histogram, and the mean lies above that.
struct Foreground {
    ValueRange range;
    bool fromBackground = false;
};

Foreground foregroundOf(const Volume& volume) {
    std::vector<std::uint64_t> histogram(65536, 0);
    for (const std::uint16_t stored : volume.voxels()) ++histogram[stored];
    if (volume.padding()) {
        for (int v = volume.padding()->low; v <= volume.padding()->high; ++v) histogram[std::size_t(v)] = 0;
    }
    double count = 0.0;
    double sum = 0.0;
    for (std::size_t v = 0; v < histogram.size(); ++v) {
        count += double(histogram[v]);
        sum += double(histogram[v]) * double(v);
    }
    const auto threshold = static_cast<std::size_t>(count > 0.0 ? sum / count : 0.0);
    double foreground = 0.0;
    for (std::size_t v = threshold; v < histogram.size(); ++v) foreground += double(histogram[v]);
    // In masks and label maps the curves begin at the background: otherwise the lowest label would be
    // invisible.
    constexpr std::ptrdiff_t kFewestGreys = 8;
    const auto isThere = [](std::uint64_t voxels) { return voxels > 0; };
    const auto firstOfForeground = histogram.begin() + static_cast<std::ptrdiff_t>(threshold);
    const bool isOfLabels = std::count_if(firstOfForeground, histogram.end(), isThere) < kFewestGreys;
    const auto background =
        std::find_if(std::make_reverse_iterator(firstOfForeground), histogram.rend(), isThere);
    const auto percentile = [&](double fraction) {
        double below = 0.0;
        std::size_t v = threshold;
        while (v + 1 < histogram.size() && (below += double(histogram[v])) < fraction * foreground) ++v;
        return volume.unitsFromStored()(double(v));
    };
    const double high = percentile(kHighPercentile);
    if (isOfLabels && background != histogram.rend())
        return {{volume.unitsFromStored()(double(histogram.rend() - background - 1)), high}, true};
    return {{percentile(kLowPercentile), high}, false};
}

}  // namespace

std::optional<VolumeFit> fitOf(const TransferFunction& function, const Volume& volume) {
    if (!function.fitToVolume) return std::nullopt;
    VolumeFit fit;
    fit.preset = {function.fitToVolume->low, function.fitToVolume->high};
    fit.to = function.fitToVolume->to;
    if (fit.to == TransferFunction::Fit::To::foreground) {
        const Foreground foreground = foregroundOf(volume);
        fit.volume = foreground.range;
        fit.fromBackground = foreground.fromBackground;
    } else {
        fit.volume = volume.valueRange().value_or(ValueRange{0.0, 0.0});
    }
    // With a single value in the volume, the curves would have no width.
    fit.volume.high = std::max(fit.volume.high, fit.volume.low + volume.unitsFromStored().slope);
    return fit;
}

TransferFunction fitted(const TransferFunction& function, const Volume& volume) {
    const std::optional<VolumeFit> fit = fitOf(function, volume);
    if (!fit) return function;
    TransferFunction result = function;
    for (OpacityPoint& point : result.opacity) point.value = (*fit)(point.value);
    for (ColourPoint& point : result.colour) point.value = (*fit)(point.value);
    for (OpacityPoint& point : result.steep.opacity) point.value = (*fit)(point.value);
    for (ColourPoint& point : result.steep.colour) point.value = (*fit)(point.value);
    result.steep.gradientPerMm *= fit->scale();
    for (OpacityPoint& point : result.gradientOpacity) point.value *= fit->scale();
    result.surface.gradientPerMm *= fit->scale();
    if (result.effectiveRange)
        result.effectiveRange = {(*fit)(result.effectiveRange->low), (*fit)(result.effectiveRange->high)};
    result.fitToVolume.reset();
    return result;
}

Result<TransferFunction> withFit(TransferFunction function) {
    if (function.fitToVolume) return function;
    if (!function.effectiveRange) {
        return Error{ErrorCode::inputNotUsable,
                     Text("The preset has no range of values that could be fitted."), function.name,
                     Text("Use it without fitting, or give it an effectiveRange.")};
    }
    function.fitToVolume = TransferFunction::Fit{function.effectiveRange->low, function.effectiveRange->high};
    return function;
}

Message fitMessage(const VolumeFit& fit) {
    const bool foreground = fit.to == TransferFunction::Fit::To::foreground;
    Message message;
    message.key = "preset.fitted";
    message.arguments = {{"presetLow", fit.preset.low},
                         {"presetHigh", fit.preset.high},
                         {"volumeLow", fit.volume.low},
                         {"volumeHigh", fit.volume.high},
                         {"to", std::string(foreground ? "foreground" : "valueRange")}};
    message.sentence =
        Text("The preset was stretched to this volume: its {:g} to {:g} are drawn at {:g} to {:g}, {}.",
             fit.preset.low, fit.preset.high, fit.volume.low, fit.volume.high,
             fit.fromBackground ? Text("the background and the 98th percentile of the foreground")
             : foreground       ? Text("the 2nd and 98th percentile of the foreground")
                                : Text("the smallest and largest value"));
    message.action = Text("Compare brightness and colours only within this volume.");
    return message;
}

}  // namespace macula
