#include "study/open/found_volumes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/sha256.h"
#include "dicom/best_volume.h"
#include "study/open/loaded_study.h"
#include "study/open/stack_label_text.h"

namespace macula::study {

namespace {

Error notUsable(Text sentence, const std::filesystem::path& where) {
    return {ErrorCode::inputNotUsable, std::move(sentence), where.string(),
            Text("Choose a folder with a CT or MR series of several parallel slices.")};
}

bool sameFile(const std::filesystem::path& a, const std::filesystem::path& b) {
    if (a.filename() != b.filename()) return false;  // the scan was of the file's own folder
    std::error_code notThere;
    return a == b || std::filesystem::equivalent(a, b, notThere);
}

// "CT, series 3: Thorax, kernel B30f, phase 2 of 20"
Text seriesLine(const dicom::Series& series, const dicom::Stack& stack) {
    const std::string& modality = stack.modality.empty() ? series.modality : stack.modality;
    std::vector<Text> facts{modality.empty() ? Text("Modality unknown") : Text::verbatim(modality)};
    if (series.description.empty()) {
        facts.push_back(series.number ? Text("series {}", *series.number) : Text("series without a number"));
        facts.push_back(Text("no description"));
    } else {
        facts.push_back(series.number ? Text("series {}: {}", *series.number, series.description)
                                      : Text("series without a number: {}", series.description));
    }
    for (const dicom::StackLabel& label : stack.splitBy) facts.push_back(textOf(label));
    if (stack.phases > 1) facts.push_back(Text("phase {} of {}", stack.phase + 1, stack.phases));
    return Text::joined(std::move(facts), ", ");
}

// Rounds, because programs write the same direction with different numbers of digits.
long long thousandths(double value) {
    return std::llround(1000.0 * value);
}

std::string directionText(const glm::dvec3& direction) {
    return fmt::format(" {} {} {}", thousandths(direction.x), thousandths(direction.y),
                       thousandths(direction.z));
}

std::string factsOf(const dicom::Stack& stack) {
    if (stack.frames.empty()) return {};
    const dicom::Frame& first = stack.frames.front();
    std::string facts = fmt::format("{} {}", stack.modality, first.frameOfReferenceUid);
    if (first.plane)
        facts += directionText(first.plane->rowDirection) + directionText(first.plane->columnDirection);
    for (std::size_t n = 0; n < first.attributes.size(); ++n) {
        const std::string& value = first.attributes[n];
        const bool isOfAll = std::ranges::all_of(stack.frames, [&](const dicom::Frame& frame) {
            return n < frame.attributes.size() && frame.attributes[n] == value;
        });
        // Written with its length, so that no value can be mistaken for two.
        if (isOfAll && !value.empty()) facts += fmt::format(" {}:{}:{}", n, value.size(), value);
    }
    return facts;
}

}  // namespace

FoundVolumes::FoundVolumes(dicom::Scan scan, Extent extent)
    : scan_(std::move(scan)), extent_(extent), volumes_(volumesOf(scan_)), keys_(volumeKeys(volumes_)) {}

std::vector<FoundVolume> volumesOf(const dicom::Scan& scan) {
    std::vector<FoundVolume> volumes;
    for (const dicom::Study& study : scan.studies) {
        for (const dicom::Series& series : study.series) {
            for (const dicom::Stack& stack : series.stacks) {
                if (stack.canBeVolume()) volumes.push_back({&study, &series, &stack});
            }
        }
    }
    return volumes;
}

std::vector<Text> FoundVolumes::titles() const {
    std::vector<Text> titles;
    for (const FoundVolume& volume : volumes_) {
        const Identity identity = identityOf(volume);
        std::vector<Text> facts;
        if (scan_.patients > 1) {
            const std::vector<Text> lines = linesOf(identity);
            facts = {lines[0], lines[1]};
        }
        if (scan_.studies.size() > 1)
            facts.push_back(identity.studyDate.empty() ? Text("no study date")
                                                       : Text::verbatim(dateForPeople(identity.studyDate)));
        facts.push_back(identity.series);
        facts.push_back(
            Text("{} × {} × {}", volume.stack->columns, volume.stack->rows, volume.stack->slices.size()));
        titles.push_back(Text::joined(std::move(facts), ", "));
    }
    return titles;
}

Result<FoundVolumes::ChosenVolume> FoundVolumes::best(const std::filesystem::path& folder) const {
    const dicom::ChosenStack choice = dicom::bestVolume(scan_);
    const auto index = indexOf(choice.stack);
    if (!index) return notUsable(choice.why, folder);
    return ChosenVolume{*index, choice.why};
}

std::optional<std::size_t> FoundVolumes::bestWithout(const std::vector<std::size_t>& failed) const {
    std::vector<const dicom::Stack*> without;
    for (const std::size_t index : failed) without.push_back(volumes_.at(index).stack);
    std::vector<const dicom::Stack*> orOfOthers = without;
    for (std::size_t index = 0; index < volumes_.size(); ++index) {
        if (!areOfOnePatient(index, failed.front())) orOfOthers.push_back(volumes_[index].stack);
    }
    if (const auto own = indexOf(dicom::bestVolume(scan_, orOfOthers).stack)) return own;
    return indexOf(dicom::bestVolume(scan_, without).stack);
}

// As the scan distinguished patients.
bool FoundVolumes::areOfOnePatient(std::size_t a, std::size_t b) const {
    return volumes_.at(a).study->patient == volumes_.at(b).study->patient;
}

Result<FoundVolumes::ChosenVolume> FoundVolumes::ofSeries(const std::string& wanted,
                                                          const std::filesystem::path& folder) const {
    const auto all = dicom::findAllSeries(scan_, wanted);
    const bool isNumber = wanted.find('.') == std::string::npos;  // a UID has points
    const dicom::Series* series = all.size() == 1 ? all.front()
                                  : isNumber      ? seriesMeant(scan_, wanted)
                                                  : nullptr;
    if (series == nullptr)
        return Error{ErrorCode::inputNotUsable,
                     all.empty() ? Text("The series that was asked for is not in this folder.")
                                 : Text("Several studies of this folder have the series that was asked for."),
                     folder.string(),
                     Text("Check its Series Instance UID or number, or choose another folder.")};
    const dicom::ChosenStack choice = dicom::bestVolume(*series);
    const auto index = indexOf(choice.stack);
    if (!index) return notUsable(choice.why, folder);
    return ChosenVolume{*index, choice.why};
}

Result<FoundVolumes::ChosenVolume> FoundVolumes::holding(const std::filesystem::path& file) const {
    for (const dicom::Study& study : scan_.studies) {
        for (const dicom::Series& series : study.series) {
            for (const dicom::Stack& stack : series.stacks) {
                const bool holds =
                    std::any_of(stack.frames.begin(), stack.frames.end(),
                                [&](const dicom::Frame& f) { return sameFile(f.instance->file, file); });
                if (!holds) continue;
                const auto index = indexOf(&stack);
                if (index) return ChosenVolume{*index, Text("The images of the file that was opened.")};
                const Message* reason = stack.whyNoVolume();
                return notUsable(reason != nullptr ? reason->sentence : Text("The images are no volume."),
                                 file);
            }
            for (const dicom::OtherObject& object : series.objects) {
                if (sameFile(object.file, file))
                    return notUsable(Text("{}: this is no image.", object.kind), file);
            }
        }
    }
    for (const dicom::SkippedFile& skipped : scan_.skipped) {
        if (sameFile(skipped.file, file)) return notUsable(skipped.message.sentence, file);
    }
    return notUsable(Text("The file is not a DICOM image."), file);
}

std::optional<std::size_t> FoundVolumes::indexOf(const dicom::Stack* stack) const {
    const auto found = std::find_if(volumes_.begin(), volumes_.end(),
                                    [&](const FoundVolume& volume) { return volume.stack == stack; });
    if (found == volumes_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - volumes_.begin());
}

std::vector<dicom::ReferencedFrames> imagesOf(const dicom::Stack& stack) {
    std::vector<dicom::ReferencedFrames> images;
    for (const dicom::Frame& frame : stack.frames) {
        if (frame.instance->sopInstanceUid.empty()) return {};
        dicom::ReferencedFrames& image = images.emplace_back();
        image.sopInstanceUid = frame.instance->sopInstanceUid;
        if (frame.instance->frames > 1) image.numbers.push_back(frame.number + 1);
    }
    return dicom::byImage(std::move(images));
}

std::string frameOfReferenceOf(const dicom::Stack& stack) {
    if (stack.frames.empty()) return {};
    const std::string& first = stack.frames.front().frameOfReferenceUid;
    const bool isOne = std::ranges::all_of(
        stack.frames, [&](const dicom::Frame& frame) { return frame.frameOfReferenceUid == first; });
    return isOne ? first : std::string();
}

Identity identityOf(const FoundVolume& volume) {
    Identity identity = identityOf(*volume.study);
    identity.series = seriesLine(*volume.series, *volume.stack);
    return identity;
}

Identity identityOf(const dicom::Study& study) {
    return {.patientName = study.patientName,
            .patientId = study.patientId,
            .birthDate = study.patientBirthDate,
            .sex = study.patientSex,
            .studyDate = study.date,
            .studyDescription = study.description,
            .series = {},
            .studyInstanceUid = study.studyInstanceUid};
}

std::vector<std::string> volumeKeys(std::span<const FoundVolume> volumes) {
    std::map<std::pair<const dicom::Series*, std::string>, int> alike;
    std::vector<std::string> keys;
    keys.reserve(volumes.size());
    for (const FoundVolume& volume : volumes) {
        std::string digest = sha256Hex(factsOf(*volume.stack));
        const int count = ++alike[{volume.series, digest}];
        keys.push_back(count == 1 ? std::move(digest) : fmt::format("{}-{}", digest, count));
    }
    return keys;
}

}  // namespace macula::study
