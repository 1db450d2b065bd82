#include "scene/second/second_study.h"

#include <algorithm>
#include <vector>

#include "base/sha256.h"
#include "study/open/same_place.h"

namespace macula::scene {

namespace {

constexpr double kUsualDoseOpacity = 0.35;  // the anatomy and the lines stay visible

// Empty if the study does not come from a folder.
std::string keyOf(const study::OpenedStudy& study) {
    const bool isFound = study.found && study.volumeIndex < study.found->volumes().size();
    return isFound ? study.found->key(study.volumeIndex) : std::string();
}

// A dose was computed on the images of its frame of reference: its place is theirs, and beside them it says
// nothing. Its colours begin at no dose.
void layOver(SecondVolumeState& state, const Volume& dose) {
    state.view = SecondVolumePlace::over;
    state.opacity = kUsualDoseOpacity;
    state.isodoses = usualIsodoses();
    const double most = dose.valueRange() ? dose.valueRange()->high : 0.0;
    if (most > 0.0)
        state.window =
            DisplayWindow{.center = 0.5 * most, .width = most, .explanation = {}, .function = "LINEAR_EXACT"};
}

}  // namespace

PlaceInSeries placeInSeries(const study::OpenedStudy& study) {
    PlaceInSeries at;
    if (!study.found || study.volumeIndex >= study.found->volumes().size()) return at;
    const std::vector<study::FoundVolume>& volumes = study.found->volumes();
    at.count = 0;
    for (std::size_t n = 0; n < volumes.size(); ++n) {
        if (volumes[n].series != volumes[study.volumeIndex].series) continue;
        if (n == study.volumeIndex) at.place = at.count;
        ++at.count;
    }
    return at;
}

Text plainTag(const study::OpenedStudy& study) {
    if (study.identity.isOfNobody) return Text("phantom");
    const std::string& modality = study.volume->modality();
    const std::string day = study::studyDay(study.identity);
    std::vector<Text> facts{modality.empty() ? Text("images") : Text::verbatim(modality),
                            day.empty() ? Text("no study date") : Text::verbatim(study::dateForPeople(day))};
    if (study.found && study.volumeIndex < study.found->volumes().size()) {
        if (const auto& number = study.found->volumes()[study.volumeIndex].series->number)
            facts.push_back(Text("series {}", *number));
        if (const PlaceInSeries at = placeInSeries(study); at.count > 1)
            facts.push_back(Text("volume {} of {}", at.place + 1, at.count));
    }
    return Text::joined(std::move(facts), ", ");
}

SecondVolumeState firstLink(const study::OpenedStudy& study, const study::OpenedStudy& second,
                            const std::string& pair) {
    SecondVolumeState state;
    state.pair = pair;
    state.seriesDigest = second.seriesDigest;
    if (const PlaceInSeries at = placeInSeries(second); at.count > 1) state.volume = at.place;
    state.volumeKey = keyOf(second);
    state.linksWindow = study::arePhases(study, second);
    if (study::shareFrameOfReference(study, second)) {
        state.link = SecondVolumeLink::sameFrame;
        if (second.dose && !study.dose) layOver(state, *second.measured());
        return state;
    }
    const glm::dvec3 shift = second.volume->worldBox().centre() - study.volume->worldBox().centre();
    state.secondFromStudy[3] = glm::dvec4(shift, 1.0);
    return state;
}

std::string pairDigest(const std::string& studyFingerprint, const std::string& secondFingerprint) {
    return sha256Hex(studyFingerprint + " " + secondFingerprint);
}

SecondVolumeState withLookOf(SecondVolumeState place, const SecondVolumeState& before) {
    const bool mayLieOver = place.isLinked() || before.view != SecondVolumePlace::over;
    place.view = mayLieOver ? before.view : SecondVolumePlace::beside;
    place.window = before.window;
    place.linksWindow = before.linksWindow;
    place.opacity = before.opacity;
    place.colours = before.colours;
    place.in3d = before.in3d;
    place.preset = before.preset;
    place.isodoses = before.isodoses;
    return place;
}

bool isPlacedFor(const SecondVolumeState& state, const study::OpenedStudy& second, const std::string& pair) {
    return !pair.empty() && state.pair == pair && namesSecond(state, second);
}

bool namesSecond(const SecondVolumeState& state, const study::OpenedStudy& second) {
    if (state.seriesDigest != second.seriesDigest) return false;
    if (!state.volumeKey.empty() && second.found) return keyOf(second) == state.volumeKey;
    const PlaceInSeries at = placeInSeries(second);
    return state.volume ? *state.volume == at.place : at.count == 1;
}

std::optional<std::size_t> volumeOf(const study::FoundVolumes& found, const SecondVolumeState& state) {
    std::vector<std::size_t> ofSeries;
    for (std::size_t n = 0; n < found.volumes().size(); ++n)
        if (sha256Hex(found.volumes()[n].series->seriesInstanceUid) == state.seriesDigest)
            ofSeries.push_back(n);
    if (!state.volumeKey.empty()) {
        const auto same =
            std::ranges::find_if(ofSeries, [&](std::size_t n) { return found.key(n) == state.volumeKey; });
        // The state means no other volume, even if only one is left: namesSecond agrees.
        return same != ofSeries.end() ? std::optional(*same) : std::nullopt;
    }
    if (!state.volume && ofSeries.size() != 1) return std::nullopt;
    const std::size_t place = state.volume.value_or(0);
    return place < ofSeries.size() ? std::optional(ofSeries[place]) : std::nullopt;
}

}  // namespace macula::scene
