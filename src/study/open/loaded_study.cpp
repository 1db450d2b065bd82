#include "study/open/loaded_study.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/fingerprint.h"
#include "base/parsing.h"
#include "base/phantom.h"
#include "base/sha256.h"
#include "dicom/loader.h"
#include "dicom/presentation/presentation_state.h"
#include "dicom/scan.h"
#include "formats/volume_file.h"
#include "study/open/found_volumes.h"
#include "study/open/scanned_place.h"

namespace macula::study {

namespace {

const dicom::Series* atPlace(const dicom::Scan& scan, std::size_t place) {
    for (const dicom::Study& study : scan.studies) {
        if (place <= study.series.size()) return place == 0 ? nullptr : &study.series[place - 1];
        place -= study.series.size();
    }
    return nullptr;
}

// The stack of the chosen series at `place` from 1, or its best.
Result<dicom::ChosenStack> chooseStack(const dicom::Series& series, std::optional<std::size_t> place) {
    if (!place) {
        dicom::ChosenStack choice = dicom::bestVolume(series);
        if (choice) {
            if (series.stacks.size() == 1) choice.why = {};
            return choice;
        }
        for (const Message& message : series.messages) {
            if (message.severity >= Severity::blocksVolume) {
                return Error{ErrorCode::inputNotUsable, message.sentence, {}, message.action};
            }
        }
        return Error{ErrorCode::inputNotUsable,
                     choice.why,
                     {},
                     Text("Choose another series; macula info lists them.")};
    }
    if (*place < 1 || *place > series.stacks.size()) {
        return Error{ErrorCode::usage,
                     series.stacks.size() == 1
                         ? Text("The series has 1 stack of images.")
                         : Text("The series has {} stacks of images.", series.stacks.size()),
                     {},
                     Text("See macula info for the list.")};
    }
    return dicom::ChosenStack{&series, &series.stacks[*place - 1], {}};
}

// The requested series, otherwise the one that the presentation state refers to; empty if neither is given.
Result<std::string> requestedSeries(const StudyPlace& place, const dicom::Scan& scan) {
    if (!place.series.empty() || place.presentation.empty()) return place.series;
    MACULA_TRY(const dicom::PresentationState read, dicom::readPresentationState(place.presentation));
    const std::string& uid = read.presentation.series.seriesInstanceUid;
    // A deidentified state refers to its series by a UID that the folder lacks.
    return dicom::findAllSeries(scan, uid).empty() ? std::string() : uid;
}

}  // namespace

const dicom::Series* seriesMeant(const dicom::Scan& scan, const std::string& wanted) {
    if (!dicom::findAllSeries(scan, wanted).empty()) return dicom::findSeries(scan, wanted);
    const std::size_t point = wanted.find('.');
    const auto place = parseNumber<std::size_t>(std::string_view(wanted).substr(0, point));
    if (point != std::string::npos && !parseNumber<std::size_t>(std::string_view(wanted).substr(point + 1)))
        return nullptr;
    return place ? atPlace(scan, *place) : nullptr;
}

Result<dicom::ChosenStack> chooseVolume(const dicom::Scan& scan, const std::string& wanted,
                                        std::size_t volume) {
    const std::optional<std::size_t> given = volume > 0 ? std::optional(volume) : std::nullopt;
    if (wanted.empty()) {
        if (dicom::ChosenStack best = dicom::bestVolume(scan))
            return given ? chooseStack(*best.series, given) : best;
        return Error{ErrorCode::inputNotUsable,
                     dicom::bestVolume(scan).why,
                     {},
                     Text("Choose another folder; macula info tells more about this one.")};
    }
    const std::size_t point = wanted.find('.');
    const bool isUid = !dicom::findAllSeries(scan, wanted).empty();
    const auto stack = isUid || point == std::string::npos
                           ? given
                           : parseNumber<std::size_t>(std::string_view(wanted).substr(point + 1));
    const dicom::Series* series = seriesMeant(scan, wanted);
    if (series != nullptr && (stack || isUid || point == std::string::npos))
        return chooseStack(*series, stack);
    if (isUid) {
        return Error{ErrorCode::usage, Text("Several patients have a series of this UID."), wanted,
                     Text("Choose by the number in front of it in macula info.")};
    }
    return Error{
        ErrorCode::usage, Text("There is no such series in the folder."), wanted,
        Text("See macula info for the list; --series takes the number in front (3, or 3.2 for its second "
             "stack), or the series UID.")};
}

Result<LoadedStudy> loadStudy(const std::filesystem::path& path, const std::string& series,
                              Progress& progress, std::size_t volume, const dicom::ScanOptions& how,
                              PetUnit petUnit) {
    LoadedStudy input;
    if (formats::isVolumeFileName(path)) {
        if (!series.empty()) {
            return Error{ErrorCode::usage,
                         Text("The file is one volume; there is nothing to choose from."),
                         {},
                         Text("Leave --series and --volume out.")};
        }
        MACULA_TRY(input.volume, formats::readVolumeFile(path, progress, std::max<std::size_t>(volume, 1)));
        input.notes = input.volume->provenance().assumptions;
        input.seriesDigest = fingerprint(*input.volume);
        return input;
    }
    if (path.empty() || path == "phantom:") {
        if (!series.empty()) {
            return Error{ErrorCode::usage,
                         Text("The phantom has no series to choose from."),
                         {},
                         Text("Leave --series out.")};
        }
        if (path.empty()) input.notes.push_back(Text("No folder was given: this is the built-in phantom."));
        input.volume = std::make_shared<const Volume>(phantom::make());
        input.seriesDigest = "phantom";
        input.identity.isOfNobody = true;
        return input;
    }

    MACULA_TRY(const ScannedPlace place, scanPlace(path, progress, how));
    return loadStudy(place.scan, path, series, progress, volume, petUnit);
}

Result<LoadedStudy> loadStudy(const dicom::Scan& scan, const std::filesystem::path& path,
                              const std::string& series, Progress& progress, std::size_t volume,
                              PetUnit petUnit) {
    LoadedStudy input;
    auto chosen = chooseVolume(scan, series, volume);
    if (!chosen) {
        Error error = chosen.error();
        if (error.where.empty()) error.where = path.string();
        return error;
    }
    if (series.empty() && scan.patients > 1) {  // nobody chose the patient who is shown
        const Text why =
            chosen->why.empty() ? Text("This folder is of {}.", dicom::patientsText(scan)) : chosen->why;
        input.notes.push_back(Text::joined(
            {why, Text("Check that it is of the patient you mean; macula info lists all series.")}, " "));
        input.warnings.push_back(input.notes.back());
    } else if (!chosen->why.empty() && chosen->why != "The only volume.") {
        input.notes.push_back(chosen->why);
    }
    if (!scan.skipped.empty()) {
        input.notes.push_back(scan.skipped.size() == 1 ? Text("1 file was left out; macula info says why.")
                                                       : Text("{} files were left out; macula info says why.",
                                                              scan.skipped.size()));
    }
    const auto note = [&](const std::vector<Message>& messages) {
        for (const Message& message : messages) {
            if (message.severity != Severity::warning) continue;
            input.notes.push_back(Text::joined({message.sentence, message.action}, " "));
            input.warnings.push_back(input.notes.back());
        }
    };
    note(scan.messages);
    note(chosen->series->messages);
    note(chosen->stack->messages);
    MACULA_TRY(input.volume, dicom::loadVolume(*chosen->series, *chosen->stack, progress,
                                               {.onCoarse = {}, .inSuv = petUnit == PetUnit::suv}));
    note(input.volume->provenance().messages);
    for (const Text& assumption : input.volume->provenance().assumptions) {
        // Most assumptions repeat a warning that is a note already, there with the advised action.
        const std::string said = assumption.english();
        const bool known =
            std::ranges::any_of(input.notes, [&](const Text& n) { return n.english().starts_with(said); });
        if (!known) input.notes.push_back(assumption);
    }
    input.images = imagesOf(*chosen->stack);
    input.frameOfReferenceUid = frameOfReferenceOf(*chosen->stack);
    input.seriesDigest = sha256Hex(chosen->series->seriesInstanceUid);
    const std::vector<FoundVolume> volumes = volumesOf(scan);
    const auto at = std::ranges::find(volumes, chosen->stack, &FoundVolume::stack);
    if (at == volumes.end()) return input;
    input.identity = identityOf(*at);
    input.volumeKey = volumeKeys(volumes).at(std::size_t(at - volumes.begin()));
    return input;
}

void bringTo16Bits(LoadedStudy& study) {
    const std::size_t known = study.volume->provenance().assumptions.size();
    study.volume = in16Bits(std::move(study.volume));
    const std::vector<Text>& assumptions = study.volume->provenance().assumptions;
    study.notes.insert(study.notes.end(), assumptions.begin() + static_cast<std::ptrdiff_t>(known),
                       assumptions.end());
}

bool mayHoldSegmentations(const std::filesystem::path& path) {
    return !path.empty() && path != "phantom:" && !formats::isVolumeFileName(path);
}

Result<ReadStudy> readStudy(const StudyPlace& place, bool needsSegmentations, Progress& progress) {
    ReadStudy study;
    study.how = place.how;
    if (!mayHoldSegmentations(place.path)) {
        MACULA_TRY(study.input, loadStudy(place.path, place.series, progress, 0, place.how));
        return study;
    }
    MACULA_TRY(ScannedPlace scanned, scanPlace(place.path, progress, place.how));
    MACULA_TRY(study.series, requestedSeries(place, scanned.scan));
    MACULA_TRY(study.input, loadStudy(scanned.scan, place.path, study.series, progress));
    if (needsSegmentations) study.found = foundVolumesOf(std::move(scanned));
    return study;
}

}  // namespace macula::study
