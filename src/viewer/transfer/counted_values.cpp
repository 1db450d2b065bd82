#include "viewer/transfer/counted_values.h"

#include <new>
#include <utility>

#include "pipeline/volume/volume_fit.h"

namespace macula::viewer {

namespace {

using Fit = TransferFunction::Fit;

bool isFittedToForeground(const TransferFunction& function) {
    return function.fitToVolume && function.fitToVolume->to == Fit::To::foreground;
}

// The volume's foreground is the same for all presets that are fitted to it.
ValueRange foregroundOf(std::shared_ptr<const Volume> volume) {
    const TransferFunction any{.fitToVolume = Fit{.low = 0.0, .high = 1.0, .to = Fit::To::foreground}};
    return fitOf(any, *in16Bits(std::move(volume)))->volume;
}

}  // namespace

CountedValues::CountedValues()
    : job_(this, {.ended = [this](const Result<SeenResult>& outcome) { take(outcome); }}) {}

void CountedValues::begin(std::shared_ptr<const Volume> volume) {
    job_.cancel();
    seen_.reset();
    volume_ = std::move(volume);
}

void CountedValues::count(bool withForeground) {
    job_.start([volume = volume_, withForeground, known = seen_](Progress& progress) -> Result<SeenResult> {
        try {
            Seen seen;
            if (known) {
                seen = *known;
            } else if (const std::optional<scene::Bins> bins = scene::binsOf(*volume)) {
                MACULA_TRY(seen.histogram, scene::histogramOf(*volume, *bins, progress.token()));
            }
            if (withForeground && !seen.foreground) seen.foreground = foregroundOf(volume);
            return std::make_shared<const Seen>(std::move(seen));
        } catch (const std::bad_alloc&) {
            return Error{ErrorCode::outOfMemory,
                         Text("There is not enough memory to count the values."),
                         {},
                         Text("Close other programs, and open the study again.")};
        }
    });
}

void CountedValues::take(const Result<SeenResult>& outcome) {
    if (!volume_) return;
    if (!outcome) {
        if (outcome.error().code != ErrorCode::cancelled) Q_EMIT failed(outcome.error());
        return;
    }
    seen_ = *outcome;
    Q_EMIT counted();
}

const std::optional<scene::Histogram>& CountedValues::histogram() const {
    static const std::optional<scene::Histogram> kNone;
    return seen_ ? seen_->histogram : kNone;
}

std::optional<scene::ValueMap> CountedValues::mapFor(const TransferFunction& function) const {
    if (!isFittedToForeground(function)) return scene::ValueMap::of(fitOf(function, *volume_));
    if (!seen_ || !seen_->foreground) return std::nullopt;
    return scene::ValueMap::of(VolumeFit{.preset = {function.fitToVolume->low, function.fitToVolume->high},
                                         .volume = *seen_->foreground,
                                         .to = Fit::To::foreground});
}

}  // namespace macula::viewer
