#include "scene/state/state_bytes.h"

#include "base/check.h"

namespace macula::scene {

namespace {

template <class T>
std::size_t bytesOf(const std::vector<T>& all) {
    return all.size() * sizeof(T);
}

std::size_t bytesOf(const TransferFunction& function) {
    return sizeof function + bytesOf(function.opacity) + bytesOf(function.colour) +
           bytesOf(function.steep.opacity) + bytesOf(function.steep.colour) +
           bytesOf(function.gradientOpacity) + function.document.size();
}

// The bytes of the state, without those that it shares with others.
std::size_t ownBytesOf(const StudyState& state) {
    std::size_t bytes = sizeof state + state.otherKeys.size() + bytesOf(state.measurements) +
                        bytesOf(state.cuts.scissors) + bytesOf(state.namedClips) +
                        bytesOf(state.segmentations);
    for (const slices::Measurement& measurement : state.measurements) {
        bytes += measurement.label.size();
        if (const auto* outline = std::get_if<slices::Outline>(&measurement.shape))
            bytes += bytesOf(outline->pointsMm);
        if (const auto* line = std::get_if<slices::OpenLine>(&measurement.shape))
            bytes += bytesOf(line->pointsMm);
    }
    for (const NamedClip& clip : state.namedClips) bytes += clip.name.size() + bytesOf(clip.cuts.scissors);
    for (const SegmentationSettings& choice : state.segmentations) bytes += bytesOf(choice.segments);
    if (const auto& beside = state.secondVolume)
        bytes += beside->seriesDigest.size() + beside->volumeKey.size() + beside->pair.size();
    return bytes;
}

// Calls tell(what, bytes) for each object that copies of the state share.
template <class Tell>
void forEachShared(const StudyState& state, const Tell& tell) {
    const auto tellOf = [&](const Cuts& cuts) {
        for (const ScissorCut& cut : cuts.scissors) {
            if (cut.outline.identity() != nullptr)
                tell(cut.outline.identity(), bytesOf(cut.outline.points()));
        }
    };
    tellOf(state.cuts);
    for (const NamedClip& clip : state.namedClips) tellOf(clip.cuts);
    if (state.preset) tell(state.preset.get(), bytesOf(*state.preset));
    if (state.secondVolume && state.secondVolume->preset)
        tell(state.secondVolume->preset.get(), bytesOf(*state.secondVolume->preset));
    if (state.lights) tell(state.lights.get(), sizeof *state.lights);
}

}  // namespace

void StateBytes::add(const StudyState& state) {
    own_ += ownBytesOf(state);
    forEachShared(state, [this](const void* what, std::size_t bytes) { use(what, bytes); });
}

void StateBytes::remove(const StudyState& state) {
    own_ -= ownBytesOf(state);
    forEachShared(state, [this](const void* what, std::size_t) { leave(what); });
}

void StateBytes::use(const void* what, std::size_t bytes) {
    Shared& shared = known_[what];
    if (shared.users++ > 0) return;
    shared.bytes = bytes;
    shared_ += bytes;
}

void StateBytes::leave(const void* what) {
    const auto found = known_.find(what);
    MACULA_CHECK(found != known_.end());
    if (--found->second.users > 0) return;
    shared_ -= found->second.bytes;
    known_.erase(found);
}

}  // namespace macula::scene
