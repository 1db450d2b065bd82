#include "study/hanging/hanging_images.h"

#include <algorithm>
#include <array>
#include <set>

#include "dicom/planar/planar_header.h"

namespace macula::study {

namespace {

constexpr std::array<std::string_view, 3> kXrays{"CR", "DX", "RG"};

bool isXray(const std::string& modality) {
    return std::ranges::find(kXrays, modality) != kXrays.end();
}

// The modalities of images, as areAlike counts them.
std::set<std::string> modalitiesOf(const dicom::Study& study) {
    std::set<std::string> all;
    for (const dicom::Series& series : study.series)
        for (const dicom::Stack& stack : series.stacks)
            all.insert(isXray(stack.modality) ? std::string(kXrays.front()) : stack.modality);
    return all;
}

void addFacts(HangingImage& image) {
    const dicom::Frame& frame = image.of.stack->frames[image.place];
    const auto header = dicom::readPlanarHeader(frame.instance->file, frame.number);
    if (!header) return;
    image.bodyPart = header->bodyPart;
    image.laterality = header->laterality;
    image.view = header->viewPosition;
}

}  // namespace

bool areAlike(const std::string& modality, const std::string& other) {
    return modality == other || (isXray(modality) && isXray(other));
}

const dicom::Study& studyToRead(const dicom::Study& study, const FoundVolumes& found) {
    const dicom::Study* newest = &study;
    if (study.date.empty()) return study;
    const std::set<std::string> own = modalitiesOf(study);
    for (const dicom::Study& other : found.scan().studies) {
        const std::set<std::string> theirs = modalitiesOf(other);
        const bool isAlike =
            std::ranges::any_of(theirs, [&](const auto& each) { return own.contains(each); });
        if (other.patient == study.patient && isAlike && other.date > newest->date) newest = &other;
    }
    return *newest;
}

std::vector<const dicom::Study*> priorsOf(const dicom::Study& study, const FoundVolumes& found) {
    std::vector<const dicom::Study*> priors;
    if (study.date.empty()) return priors;
    const std::set<std::string> own = modalitiesOf(study);
    for (const dicom::Study& other : found.scan().studies) {
        const bool isOlder = !other.date.empty() && other.date < study.date;
        const std::set<std::string> theirs = modalitiesOf(other);
        const bool isAlike =
            std::ranges::any_of(theirs, [&](const auto& each) { return own.contains(each); });
        if (&other != &study && other.patient == study.patient && isOlder && isAlike)
            priors.push_back(&other);
    }
    std::ranges::stable_sort(priors, std::ranges::greater(), &dicom::Study::date);
    if (priors.size() > kMostPriors) priors.resize(kMostPriors);
    return priors;
}

Result<HangingImages> hangingImages(const dicom::Study& study, const FoundVolumes& found,
                                    Progress& progress) {
    HangingImages all{.studies = priorsOf(study, found), .images = {}};
    all.studies.insert(all.studies.begin(), &study);
    for (std::size_t prior = 0; prior < all.studies.size(); ++prior) {
        const dicom::Study& of = *all.studies[prior];
        for (const dicom::Series& series : of.series)
            for (const dicom::Stack& stack : series.stacks) {
                if (stack.frames.empty()) continue;
                HangingImage image{.of = {&of, &series, &stack},
                                   .prior = int(prior),
                                   .isVolume = stack.canBeVolume(),
                                   .isLocalizer = dicom::isLocalizer(stack),
                                   .modality = stack.modality,
                                   .bodyPart = {},
                                   .laterality = {},
                                   .view = {}};
                const std::vector<PlanarLoop> loops =
                    image.isVolume ? std::vector<PlanarLoop>{{0, stack.frames.size()}} : loopsOf(stack);
                for (const PlanarLoop& loop : loops) {
                    if (progress.cancelled())
                        return Error{ErrorCode::cancelled, Text("Reading headers was cancelled."), {}, {}};
                    image.place = loop.begin;
                    addFacts(image);
                    all.images.push_back(image);
                }
            }
    }
    return all;
}

}  // namespace macula::study
