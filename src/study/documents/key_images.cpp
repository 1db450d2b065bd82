#include "study/documents/key_images.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <span>
#include <string_view>
#include <utility>

#include "base/exceptions.h"
#include "dicom/documents/document.h"
#include "dicom/documents/read_document.h"

namespace macula::study {

namespace {

constexpr std::string_view kKeyObjectSelection = "1.2.840.10008.5.1.4.1.1.88.59";

bool isOneOf(const CodedName& title, std::span<const std::string_view> values) {
    return title.scheme == "DCM" && std::ranges::find(values, title.value) != values.end();
}

// CID 7011: rejected for reasons of quality, patient safety, an incorrect worklist entry, its age.
bool isRejection(const CodedName& title) {
    constexpr std::array<std::string_view, 4> kRejections{"113001", "113037", "113038", "113039"};
    return isOneOf(title, kRejections);
}

// Manifests, and the complete content of a study or an acquisition, name images without choosing any.
bool isManifest(const CodedName& title) {
    constexpr std::array<std::string_view, 6> kManifests{"113030", "113031", "113032",
                                                         "113033", "113034", "113035"};
    return isOneOf(title, kManifests);
}

using Seen = std::set<std::pair<const dicom::Stack*, std::size_t>>;

// A reference to several frames names each of them.
void addImages(const dicom::StudyDocument& selection, const ImagePlaces& places, Seen& seen,
               std::vector<KeyImage>& images) {
    const bool isRejected = isRejection(selection.titleCode);
    for (const dicom::DocumentReference& reference : selection.references()) {
        std::vector<int> frames = reference.frames;
        if (frames.empty()) frames.push_back(0);  // all of them: the first stands for the image
        for (const int frame : frames) {
            dicom::DocumentReference one = reference;
            one.frames.clear();
            if (frame > 0) one.frames = {frame};
            const std::optional<ImagePlace> place = places.of(one);
            if (!place || images.size() >= kMostKeyImages) continue;
            if (!seen.insert({place->stack, place->frame}).second) continue;
            images.push_back({.place = *place, .why = selection.title, .isRejected = isRejected});
        }
    }
}

}  // namespace

std::vector<std::size_t> KeyImages::inOrder() const {
    std::vector<std::size_t> places;
    for (std::size_t n = 0; n < images_.size(); ++n)
        if (!images_[n].isRejected) places.push_back(n);
    return places;
}

template <class IsMeant>
std::vector<Text> KeyImages::lines(bool withTitles, const IsMeant& isMeant) const {
    std::vector<Text> lines;
    for (const bool isRejected : {false, true}) {
        std::size_t count = 0;
        std::vector<Text> titles;
        for (const KeyImage& image : images_) {
            if (image.isRejected != isRejected || !isMeant(image.place)) continue;
            ++count;
            constexpr std::size_t kMostTitles = 3;
            const std::string said = image.why.english();
            const bool isKnown =
                std::ranges::any_of(titles, [&](const Text& known) { return known == said; });
            if (!isKnown && !image.why.empty() && titles.size() < kMostTitles) titles.push_back(image.why);
        }
        if (count == 0) continue;
        Text line = isRejected   ? Text("Rejected images: {}", count)
                    : count == 1 ? Text("★ 1 key image")
                                 : Text("★ {} key images", count);
        if (withTitles && !titles.empty())
            line = Text("{}: {}", std::move(line), Text::joined(std::move(titles), ", "));
        lines.push_back(std::move(line));
    }
    return lines;
}

std::vector<Text> KeyImages::linesOf(const dicom::Series& series, bool withTitles) const {
    return lines(withTitles, [&](const ImagePlace& place) { return place.series == &series; });
}

std::vector<Text> KeyImages::linesOf(const dicom::Stack& stack, bool withTitles) const {
    return lines(withTitles, [&](const ImagePlace& place) { return place.stack == &stack; });
}

Result<KeyImages> findKeyImages(const FoundVolumes& found, Progress& progress) try {
    std::vector<KeyImage> images;
    Seen seen;
    std::map<int, ImagePlaces> places;  // by patient
    for (const dicom::Study& study : found.scan().studies) {
        for (const dicom::Series& series : study.series) {
            for (const dicom::OtherObject& object : series.objects) {
                if (object.sopClassUid != kKeyObjectSelection) continue;
                if (progress.cancelled())
                    return Error{ErrorCode::cancelled, Text("Reading the key images was cancelled."), {}, {}};
                const auto selection = dicom::readDocument(object.file);
                if (!selection || isManifest(selection->titleCode)) continue;
                const auto of = places.try_emplace(study.patient, found, study.patient).first;
                addImages(*selection, of->second, seen, images);
            }
        }
    }
    return KeyImages(std::move(images));
} catch (const std::exception& thrown) {
    return errorOf(thrown, Text("read the key images"));
}

}  // namespace macula::study
