#include "scene/second/second_input.h"

#include <memory>
#include <optional>
#include <utility>

#include "base/fingerprint.h"
#include "base/sha256.h"
#include "registration/rigid_registration.h"
#include "scene/choice/study_preset.h"
#include "scene/second/second_curve.h"

namespace macula::scene {

namespace {

void warn(DrawableSecond& drawn, Text sentence) {
    drawn.notes.push_back(sentence);
    drawn.warnings.push_back(std::move(sentence));
}

void addNotes(const std::vector<Text>& notes, const std::vector<Text>& warnings, DrawableSecond& drawn) {
    for (const Text& note : notes) drawn.notes.push_back(Text("Second volume: {}", note));
    for (const Text& warning : warnings) drawn.warnings.push_back(Text("Second volume: {}", warning));
}

// Places the second volume by positions alone, which are comparable in one frame of reference (PS3.3
// C.7.4.1).
void placeByPositions(const study::LoadedStudy& study, const study::LoadedStudy& second,
                      SecondVolumeState& state, DrawableSecond& drawn) {
    const std::string& frame = study.frameOfReferenceUid;
    if (frame.empty() || second.frameOfReferenceUid.empty()) {
        warn(
            drawn,
            Text(
                "Nothing says that the positions of the second volume are the study's: not both have a frame "
                "of reference. Register both by --registration search."));
    } else if (frame != second.frameOfReferenceUid) {
        warn(
            drawn,
            Text("The second volume has another frame of reference than the study: its positions are not the "
                 "study's. Register both by --registration search."));
    } else {
        state.link = SecondVolumeLink::sameFrame;
        drawn.notes.push_back(
            Text("Second volume: Same frame of reference, not registered: the patient may have moved."));
    }
}

Result<void> place(const SecondVolumeRequest& request, const study::LoadedStudy& ofStudy,
                   const study::LoadedStudy& ofSecond, bool isPlaced, SecondVolumeState& state,
                   DrawableSecond& drawn, Progress& progress) {
    const Volume& study = *ofStudy.volume;
    const Volume& second = *ofSecond.volume;
    if (request.link == SecondPlacement::search) {
        MACULA_TRY(const registration::RigidRegistration found,
                   registration::registerRigid(study, second, progress));
        state.link = SecondVolumeLink::registered;
        state.secondFromStudy = found.movingFromFixed;
        state.boundMm = found.boundMm;
        state.isDoubtful = found.isDoubtful();
        if (found.hasRival()) state.rivalMm = found.rivalMm;
        drawn.notes.push_back(Text("The second volume was registered, to {:.1f} mm.", found.boundMm));
        if (found.hasRival())
            warn(drawn, Text("The second volume fits the study nearly as well {:.0f} mm from where it was "
                             "registered, as a spine does one vertebra off.",
                             found.rivalMm));
        if (found.isDoubtful())
            warn(drawn, Text("The registration of the second volume is doubtful: look at both on slices "
                             "before you rely on the picture."));
    } else if (!isPlaced) {
        placeByPositions(ofStudy, ofSecond, state, drawn);
    }
    if (registration::boxOverlap(study, second, state.secondFromStudy) > 0.0) return {};
    return Error{
        ErrorCode::inputNotUsable,
        Text("Nothing of the second volume lies in the study."),
        {},
        Text("Choose another series by --second-series, or register both by --registration search.")};
}

// A registration of one phase says nothing about another.
bool namesSecond(const SecondVolumeState& beside, const study::LoadedStudy& second) {
    const bool isOtherVolume =
        !beside.volumeKey.empty() && !second.volumeKey.empty() && beside.volumeKey != second.volumeKey;
    return beside.isLinked() && beside.seriesDigest == second.seriesDigest && !isOtherVolume;
}

// What the view says about the second volume; nothing if it names another volume. `isPlaced`: its place was
// found for these voxels and positions.
struct Known {
    std::optional<SecondVolumeState> state;
    bool isPlaced = false;
};
Known known(const SecondVolumeState* beside, const study::LoadedStudy& study,
            const study::LoadedStudy& second, DrawableSecond& drawn) {
    if (beside == nullptr) return {};
    if (!namesSecond(*beside, second)) {
        if (isSecondIn3d(*beside))
            drawn.notes.push_back(Text(
                "The view was saved with another second volume: its place and look are not those of this "
                "one."));
        return {};
    }
    if (beside->pair == pairDigest(fingerprint(*study.volume), fingerprint(*second.volume)))
        return {.state = *beside, .isPlaced = true};
    warn(drawn,
         Text("The view was saved when the images of the study or of the second volume had other values or "
              "positions, or by an older Macula: where it lies there is not believed."));
    return {.state = withLookOf({}, *beside)};
}

// Volumes from single files are compared by path only (see resolveAdditions), and the phantom may be its own
// second volume.
bool isTheStudy(const study::LoadedStudy& study, const study::LoadedStudy& second) {
    static const std::string kOfNoUid = sha256Hex("");
    return !second.volumeKey.empty() && study.volumeKey == second.volumeKey &&
           study.seriesDigest == second.seriesDigest && second.seriesDigest != kOfNoUid &&
           fingerprint(*study.volume) == fingerprint(*second.volume);  // and was not exported again
}

Result<study::SamePatient> patientOf(const study::LoadedStudy& study, const study::LoadedStudy& second,
                                     DrawableSecond& drawn) {
    const study::SamePatient same = study::samePatient(study.identity, second.identity);
    if (same == study::SamePatient::no)
        return Error{ErrorCode::inputNotUsable,
                     Text("The second volume is of another patient than the study."),
                     {},
                     Text("Choose a series of the same patient by --second and --second-series.")};
    if (same == study::SamePatient::unknown)
        drawn.notes.push_back(Text("The images do not tell whether both volumes are of one patient."));
    return same;
}

}  // namespace

Error secondIsTheStudy() {
    return {
        ErrorCode::inputNotUsable,
        Text("The second volume is the study itself."),
        {},
        Text("Choose another series by --second-series, of those that macula info lists, or another file by "
             "--second.")};
}

Result<void> check(const SecondVolumeRequest& request, bool linkIsGiven) {
    if (request.isGiven() || (request.series.empty() && request.preset.empty() && !linkIsGiven)) return {};
    return Error{ErrorCode::usage,
                 Text("There is no second volume."),
                 {},
                 Text("Give its folder or file by --second, or leave out what else is said of it.")};
}

Result<DrawableSecond> secondToDraw(const SecondVolumeRequest& request, const study::LoadedStudy& study,
                                    const SecondVolumeState* beside, Progress& progress) {
    MACULA_TRY(study::LoadedStudy input,
               study::loadStudy(request.path, request.series, progress, 0, request.how));
    DrawableSecond drawn;
    MACULA_TRY(const study::SamePatient patient, patientOf(study, input, drawn));
    study::bringTo16Bits(input);
    if (isTheStudy(study, input)) return secondIsTheStudy();
    addNotes(input.notes, input.warnings, drawn);
    const Known view = known(beside, study, input, drawn);
    SecondVolumeState state = view.state.value_or(SecondVolumeState());
    MACULA_TRY_VOID(place(request, study, input, view.isPlaced, state, drawn, progress));
    if (!request.preset.empty()) {
        MACULA_TRY(presets::ImportedPreset preset, presetToDraw(request.preset, false));
        const PresetNotes told = notesToDraw(preset, *input.volume);
        addNotes(told.notes, told.warnings, drawn);
        state.preset = std::make_shared<const TransferFunction>(std::move(preset.function));
    }
    if (state.preset && usesGradientOpacity(*state.preset))
        drawn.notes.push_back(Text("The gradient opacity of the second volume's preset is not drawn."));
    if (state.preset && usesSteepCurves(*state.preset))
        drawn.notes.push_back(
            Text("The second volume's preset is drawn without its curves of steep matter."));
    drawn.remark = secondRemark(*input.volume, state, patient);
    drawn.second = secondIn3d(state, input.volume);
    return drawn;
}

}  // namespace macula::scene
