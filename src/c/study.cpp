#include "c/study.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "base/english.h"
#include "base/fingerprint.h"
#include "c/handles.h"
#include "c/last_error.h"
#include "c/sized.h"
#include "c/told_progress.h"
#include "c/utf8_text.h"
#include "formats/raw_image.h"
#include "study/open/found_volumes.h"
#include "study/spool/spool.h"
#include "study/spool/spool_record.h"

namespace macula::c {

namespace {

constexpr std::size_t kMostReasons = 8;  // the rest is in macula_study_found

// Why files of the folder were left out: each reason once, with the number of its files.
std::vector<std::string> reasonsOf(const dicom::Scan& scan) {
    std::vector<std::pair<std::string, std::size_t>> files;
    for (const dicom::SkippedFile& file : scan.skipped) {
        const std::string sentence = file.message.sentence.english();
        const auto known = std::ranges::find(files, sentence, &decltype(files)::value_type::first);
        if (known == files.end())
            files.emplace_back(sentence, 1);
        else
            ++known->second;
    }
    std::vector<std::string> reasons;
    for (const auto& [sentence, count] : files) {
        if (reasons.size() == kMostReasons) break;
        reasons.push_back(fmt::format("Left out, {} {}: {}", count, count == 1 ? "file" : "files", sentence));
    }
    return reasons;
}

// Why this volume was loaded although nobody chose it: which patient is shown must not be a matter of luck.
// The reason says if there are several patients.
std::string choiceOf(const study::OpenedStudy& study) {
    const int patients = study.found == nullptr ? 1 : study.found->scan().patients;
    if (patients > 1) return study.whyThisSeries.english() + " Check that it is of the patient you mean.";
    return study.volumeTitles.size() > 1 ? study.whyThisSeries.english() : std::string();
}

// A part of a study that was fetched must not pass for all of it. Of the user's own it is noted that it was
// used: those that nobody used for long are purged first.
std::string doubtOf(const std::filesystem::path& path) {
    const std::filesystem::path folder = path.has_filename() ? path : path.parent_path();
    static_cast<void>(study::useSpooled(folder));
    const auto record = study::readSpoolRecord(folder);
    if (!record || record->isComplete) return {};
    return "This study is not known to be complete: images that the archive has may be missing. Fetch it "
           "again.";
}

// The messages about the study, and what loading assumed; nothing twice.
std::vector<std::string> notesOf(const study::OpenedStudy& study) {
    std::vector<std::string> notes = inEnglish(study.messages);
    if (study.found != nullptr) {
        const std::vector<std::string> reasons = reasonsOf(study.found->scan());
        notes.insert(notes.end(), reasons.begin(), reasons.end());
    }
    for (const std::string& assumption : inEnglish(study.volume->provenance().assumptions)) {
        const bool isKnown =
            std::ranges::any_of(notes, [&](const std::string& note) { return note.starts_with(assumption); });
        if (!isKnown) notes.push_back(assumption);
    }
    return notes;
}

Result<std::unique_ptr<macula_study>> studyOf(study::OpenedStudy opened) {
    if (!opened.joinQuestion.empty())
        return Error{
            ErrorCode::inputNotUsable,
            opened.joinQuestion,
            {},
            Text("Ask who knows the images; if they are one series, open them with macula_open::join.")};
    auto study = std::make_unique<macula_study>();
    // File names need not be UTF-8.
    for (const auto& title : opened.volumeTitles)
        study->titles.push_back(utf8Of(Text("{}", title).english()));
    if (study->titles.empty()) study->titles = {utf8Of(opened.description.english())};
    study->notes = notesOf(opened);
    study->unitName = opened.volume->unitName();
    study->opened = std::move(opened);
    return study;
}

Result<formats::ScalarType> scalarTypeOf(std::int32_t type) {
    using formats::ScalarType;
    constexpr std::array kTypes{
        std::pair{MACULA_INT8, ScalarType::int8},       std::pair{MACULA_UINT8, ScalarType::uint8},
        std::pair{MACULA_INT16, ScalarType::int16},     std::pair{MACULA_UINT16, ScalarType::uint16},
        std::pair{MACULA_INT32, ScalarType::int32},     std::pair{MACULA_UINT32, ScalarType::uint32},
        std::pair{MACULA_FLOAT32, ScalarType::float32}, std::pair{MACULA_FLOAT64, ScalarType::float64}};
    for (const auto& [code, known] : kTypes)
        if (code == type) return known;
    return badArgument(Text("The voxels are of a type that is not known."),
                       Text("Use MACULA_INT8 to MACULA_FLOAT64."));
}

// Row by row in C, column by column in GLM.
Result<glm::dmat4> affineOf(const double (&rows)[16]) {
    glm::dmat4 affine(1.0);
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) affine[column][row] = rows[4 * row + column];
    const bool isAffine = glm::transpose(affine)[3] == glm::dvec4(0.0, 0.0, 0.0, 1.0);
    if (!isAffine || !isInvertibleAffine(affine))
        return badArgument(
            Text("The place of the voxels in the patient is not known."),
            Text("Set patient_from_voxel: finite numbers, three axes that span a volume, and 0 0 0 1 in "
                 "the last row."));
    return affine;
}

Result<formats::RawImage> imageOf(const macula_voxels& voxels) {
    formats::RawImage image;
    image.size = {voxels.columns, voxels.rows, voxels.slices};
    MACULA_TRY(image.type, scalarTypeOf(voxels.type));
    MACULA_TRY(image.worldFromVoxel, affineOf(voxels.patient_from_voxel));
    if (voxels.unit != MACULA_UNIT_NONE && voxels.unit != MACULA_UNIT_HOUNSFIELD)
        return badArgument(Text("The unit of the voxels is not known."),
                           Text("Use MACULA_UNIT_NONE or MACULA_UNIT_HOUNSFIELD."));
    const bool isHounsfield = voxels.unit == MACULA_UNIT_HOUNSFIELD;
    image.unit = isHounsfield ? Unit::hounsfield : Unit::raw;
    image.modality = isHounsfield ? "CT" : "";
    if (!isHounsfield)
        image.assumptions.emplace_back(
            "No unit was given: values are taken as they are. Presets for Hounsfield units do not fit.");
    image.slope = voxels.slope == 0.0 ? 1.0 : voxels.slope;
    image.intercept = voxels.intercept;
    // Before bytes(): only this makes sure that the product of the sides does not overflow.
    MACULA_TRY_VOID(formats::checkLayout(image, std::numeric_limits<std::uint64_t>::max(), false));
    if (voxels.data == nullptr || voxels.bytes != image.bytes())
        return badArgument(
            Text("{} bytes are no {} x {} x {} voxels of {}.", voxels.data == nullptr ? 0 : voxels.bytes,
                 voxels.columns, voxels.rows, voxels.slices, formats::nameOf(image.type)),
            Text("Give all voxels, and their number of bytes."));
    const auto* bytes = static_cast<const std::byte*>(voxels.data);
    image.data.assign(bytes, bytes + voxels.bytes);
    return image;
}

Result<std::unique_ptr<macula_study>> studyOfVoxels(const macula_voxels& voxels, Progress& progress) {
    MACULA_TRY(formats::RawImage image, imageOf(voxels));
    MACULA_TRY(std::shared_ptr<const Volume> volume, formats::volumeOf(std::move(image), progress));
    study::OpenedStudy opened;
    opened.seriesDigest = fingerprint(*volume);
    opened.volume = in16Bits(std::move(volume));
    opened.description = Text("Volume in memory");
    return studyOf(std::move(opened));
}

macula_volume described(const macula_study& study) {
    const Volume& volume = *study.opened.volume;
    macula_volume told{};
    told.index = static_cast<std::uint32_t>(study.opened.volumeIndex);
    told.columns = volume.size().x;
    told.rows = volume.size().y;
    told.slices = volume.size().z;
    told.unit = volume.unit() == Unit::hounsfield ? MACULA_UNIT_HOUNSFIELD : MACULA_UNIT_NONE;
    told.unit_name = study.unitName.c_str();
    told.study_uid = volume.provenance().studyInstanceUid.c_str();
    told.series_uid = volume.provenance().seriesInstanceUid.c_str();
    told.frame_of_reference_uid = study.opened.frameOfReferenceUid.c_str();
    told.modality = volume.modality().c_str();
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const ValueRange range = volume.valueRange().value_or(ValueRange{kNone, kNone});
    told.low = range.low;
    told.high = range.high;
    told.is_uncalibrated = volume.provenance().isCalibrated ? 0 : 1;
    const glm::dvec3 spacing = volume.spacingMm();
    for (int axis = 0; axis < 3; ++axis) told.spacing_mm[axis] = spacing[axis];
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            told.patient_from_voxel[4 * row + column] = volume.worldFromVoxel()[column][row];
    return told;
}

// Opens a handle for the result of `make(progress)`, which returns a Result of a unique_ptr.
template <class Handle, class Make>
macula_status made(const macula_progress* progress, Handle** out, const Make& make) {
    if (out != nullptr) *out = nullptr;
    return guarded([&]() -> Result<void> {
        if (out == nullptr) return nullHandle();
        return withProgress(progress, [&](Progress& to) -> Result<void> {
            MACULA_TRY(std::unique_ptr<Handle> handle, make(to));
            *out = opened(std::move(handle));
            return {};
        });
    });
}

}  // namespace

extern "C" {

macula_status macula_study_open(const char* path, const macula_open* how, const macula_progress* progress,
                                macula_study** study) {
    return made(progress, study, [&](Progress& to) -> Result<std::unique_ptr<macula_study>> {
        MACULA_TRY(const macula_open options, taken(how));
        if (path == nullptr || *path == '\0')
            return badArgument(Text("No folder and no file was named."),
                               Text("Give a path, or phantom: for the phantom."));
        const std::string_view named(path);
        const study::StudySource source = named == "phantom:" ? std::nullopt : study::StudySource(named);
        const std::string series = options.series_uid == nullptr ? "" : options.series_uid;
        MACULA_TRY(study::OpenedStudy opened,
                   study::openStudy(source, to,
                                    {.join = options.join != 0, .series = series, .asksWhichPatient = true}));
        const std::string choice = series.empty() ? choiceOf(opened) : std::string();
        MACULA_TRY(std::unique_ptr<macula_study> made, studyOf(std::move(opened)));
        const std::string doubt = source ? doubtOf(*source) : std::string();
        for (const std::string& note : {doubt, choice})
            if (!note.empty()) made->notes.insert(made->notes.begin(), note);
        return made;
    });
}

macula_status macula_study_of_voxels(const macula_voxels* voxels, const macula_progress* progress,
                                     macula_study** study) {
    return made(progress, study, [&](Progress& to) -> Result<std::unique_ptr<macula_study>> {
        if (voxels == nullptr) return nullHandle();
        MACULA_TRY(const macula_voxels given, taken(voxels));
        return studyOfVoxels(given, to);
    });
}

std::uint32_t macula_study_volumes(const macula_study* study) {
    std::uint32_t volumes = 0;
    guarded([&]() -> Result<void> {
        MACULA_TRY(const Held<const macula_study> of, reading(study));
        volumes = static_cast<std::uint32_t>(of->titles.size());
        return {};
    });
    return volumes;
}

const char* macula_study_title(const macula_study* study, std::uint32_t index) {
    return textAt(
        study, index, [](const macula_study& of) -> const auto& { return of.titles; });
}

macula_status macula_study_choose(macula_study* study, std::uint32_t index, const macula_progress* progress) {
    return guarded([&]() -> Result<void> {
        MACULA_TRY(const Held<macula_study> of, changing(study));
        if (index >= of->titles.size())
            return badArgument(Text("The study has no volume {}.", index),
                               Text("Give 0 to {}.", of->titles.size() - 1));
        if (index == of->opened.volumeIndex) return {};
        return withProgress(progress, [&](Progress& to) -> Result<void> {
            MACULA_TRY(study::OpenedStudy other, study::openFoundVolume(of->opened.found, index, to));
            MACULA_TRY(std::unique_ptr<macula_study> chosen, studyOf(std::move(other)));
            chosen->titles = std::move(of->titles);  // a host may still show them
            *of = std::move(*chosen);
            return {};
        });
    });
}

const char* macula_study_note(const macula_study* study, std::uint32_t index) {
    return textAt(
        study, index, [](const macula_study& of) -> const auto& { return of.notes; });
}

macula_status macula_study_volume(const macula_study* study, macula_volume* volume) {
    return guarded([&]() -> Result<void> {
        MACULA_TRY(const Held<const macula_study> of, reading(study));
        return give(described(*of), volume) ? Result<void>() : wrongSize(volume);
    });
}

macula_status macula_study_values(const macula_study* study, float* values, std::uint64_t count) {
    return guarded([&]() -> Result<void> {
        if (values == nullptr) return nullHandle();
        MACULA_TRY(const Held<const macula_study> of, reading(study));
        const Volume& volume = *of->opened.volume;
        const auto voxels = volume.voxels();
        if (count != voxels.size())
            return badArgument(Text("The volume has {} voxels.", voxels.size()),
                               Text("Give room for as many."));
        const UnitsFromStored units = volume.unitsFromStored();
        std::ranges::transform(voxels, values,
                               [&](std::uint16_t stored) { return static_cast<float>(units(stored)); });
        return {};
    });
}

void macula_study_close(macula_study* study) {
    close(study);
}

}  // extern "C"

}  // namespace macula::c
