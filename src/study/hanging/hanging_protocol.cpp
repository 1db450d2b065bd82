#include "study/hanging/hanging_protocol.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "study/list/search_text.h"

namespace macula::study {

namespace {

bool hasWords(const std::string& text, const std::string& words) {
    return holdsAll(foldedForSearch(text), searchWords(words));
}

bool isEqual(const std::string& value, const std::string& asked) {
    return asked.empty() || value == asked;
}

bool fits(const HangingImage& image, const ImageSet& set, const HangingProtocol& protocol) {
    if (image.prior != set.prior) return false;
    if (!set.modality.empty() && !areAlike(image.modality, set.modality)) return false;
    if (protocol.isOfSlices && (!image.isVolume || image.isLocalizer)) return false;
    return hasWords(image.of.series->description, set.description) &&
           isEqual(image.laterality, set.laterality) && isEqual(image.view, set.view);
}

double voxelsOf(const dicom::Stack& stack) {
    return double(stack.columns) * stack.rows * double(stack.frames.size());
}

// Series that are looked at come before others: slices of the patient before what was computed from them,
// and of equals those that are called as the ones of the study that is read.
std::vector<std::size_t> inOrder(std::vector<std::size_t> places, const HangingImages& images,
                                 const std::string& called) {
    const auto rank = [&](std::size_t place) {
        const HangingImage& image = images.images[place];
        const bool isSame = !called.empty() && image.of.series->description == called;
        const bool isVolume = image.isVolume && !image.isLocalizer;
        return std::array{isSame ? 0.0 : 1.0, isVolume ? 0.0 : 1.0,
                          isVolume && dicom::isOriginalPrimary(*image.of.stack) ? 0.0 : 1.0,
                          isVolume ? -voxelsOf(*image.of.stack) : 0.0};
    };
    std::ranges::stable_sort(places, {}, rank);
    return places;
}

HangingProtocol builtIn(Text title, const char* modality, int rows, int columns,
                        std::vector<ImageSet> boxes) {
    HangingProtocol made{.name = {}, .title = std::move(title)};
    made.modality = modality;
    made.rows = rows;
    made.columns = columns;
    made.boxes = std::move(boxes);
    return made;
}

// The right breast lies on the left, and both chest walls meet in the middle.
std::vector<ImageSet> mammograms(int prior) {
    std::vector<ImageSet> all;
    for (const char* view : {"CC", "MLO"})
        for (const char* side : {"R", "L"})
            all.push_back({.prior = prior, .modality = "MG", .laterality = side, .view = view});
    return all;
}

std::vector<ImageSet> together(std::vector<ImageSet> all, const std::vector<ImageSet>& more) {
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

HangingProtocol slicesWithPriors(Text title, int priors, int rows, int columns) {
    std::vector<ImageSet> boxes;
    for (int prior = 0; prior <= priors; ++prior) boxes.push_back({.prior = prior});
    HangingProtocol made = builtIn(std::move(title), "", rows, columns, std::move(boxes));
    made.isOfSlices = true;
    made.isLinked = true;
    return made;
}

std::vector<HangingProtocol> makeBuiltIns() {
    std::vector<HangingProtocol> all;
    all.push_back(
        builtIn(Text("Mammograms above the prior"), "MG", 2, 4, together(mammograms(0), mammograms(1))));
    all.push_back(builtIn(Text("Four mammograms"), "MG", 2, 2, mammograms(0)));
    all.push_back(builtIn(Text("Mammograms of both sides"), "MG", 1, 2,
                          {{.modality = "MG", .laterality = "R"}, {.modality = "MG", .laterality = "L"}}));
    all.push_back(builtIn(Text("X-ray beside the prior"), "DX", 1, 2,
                          {{.modality = "DX"}, {.prior = 1, .modality = "DX"}}));
    all.push_back(
        builtIn(Text("Two X-rays"), "DX", 1, 2, {{.modality = "DX"}, {.modality = "DX", .number = 1}}));
    all.push_back(slicesWithPriors(Text("Slices with three priors"), 3, 2, 2));
    all.push_back(slicesWithPriors(Text("Slices with two priors"), 2, 1, 3));
    all.push_back(slicesWithPriors(Text("Slices beside the prior"), 1, 1, 2));
    HangingProtocol two = slicesWithPriors(Text("Two series of slices"), 0, 1, 2);
    two.boxes.push_back({.number = 1});
    all.push_back(std::move(two));
    return all;
}

bool isOfStudy(const HangingProtocol& protocol, const HangingImages& images) {
    if (images.studies.empty()) return false;
    if (!hasWords(images.studies.front()->description, protocol.description)) return false;
    return std::ranges::any_of(images.images, [&](const HangingImage& image) {
        const bool isAsked = protocol.modality.empty() || areAlike(image.modality, protocol.modality);
        return image.prior == 0 && isAsked && isEqual(image.bodyPart, protocol.bodyPart);
    });
}

}  // namespace

const std::vector<HangingProtocol>& builtInHangingProtocols() {
    static const std::vector<HangingProtocol> all = makeBuiltIns();
    return all;
}

std::vector<std::optional<std::size_t>> hang(const HangingProtocol& protocol, const HangingImages& images) {
    std::vector<std::optional<std::size_t>> hung;
    std::string called;  // the first series of the study that is read
    for (const ImageSet& set : protocol.boxes) {
        std::vector<std::size_t> places;
        for (std::size_t i = 0; i < images.images.size(); ++i)
            if (fits(images.images[i], set, protocol)) places.push_back(i);
        places = inOrder(std::move(places), images, called);
        std::optional<std::size_t> chosen;
        if (set.number < places.size()) chosen = places[set.number];
        if (std::ranges::find(hung, chosen) != hung.end()) chosen.reset();
        if (chosen && called.empty()) called = images.images[*chosen].of.series->description;
        hung.push_back(chosen);
    }
    return hung;
}

bool isFor(const HangingProtocol& protocol, const HangingImages& images) {
    if (!isOfStudy(protocol, images)) return false;
    const auto hung = hang(protocol, images);
    const auto isFilled = [](const std::optional<std::size_t>& each) { return each.has_value(); };
    return protocol.title.empty() ? std::ranges::any_of(hung, isFilled) : std::ranges::all_of(hung, isFilled);
}

HangingProtocol protocolOf(std::string_view name, int rows, int columns,
                           std::span<const std::optional<std::size_t>> shown, bool isLinked,
                           const HangingImages& images) {
    HangingProtocol made{.name = std::string(name)};
    made.rows = rows;
    made.columns = columns;
    made.isLinked = isLinked;
    const auto isSlices = [&](const std::optional<std::size_t>& place) {
        return !place || (images.images[*place].isVolume && !images.images[*place].isLocalizer);
    };
    made.isOfSlices = std::ranges::all_of(shown, isSlices);
    for (const auto& place : shown) {
        // An empty box asks for a study that nobody has.
        if (!place) {
            made.boxes.push_back({.prior = int(kMostPriors) + 1});
            continue;
        }
        const HangingImage& image = images.images[*place];
        if (image.prior == 0 && made.modality.empty()) {
            made.modality = image.modality;
            made.bodyPart = image.bodyPart;
        }
        made.boxes.push_back({.prior = image.prior,
                              .modality = image.modality,
                              .description = image.isVolume ? image.of.series->description : std::string(),
                              .laterality = image.laterality,
                              .view = image.view});
        // Of several that fit the same, which one it is: as many as it takes to find it again.
        ImageSet& set = made.boxes.back();
        const auto hangs = [&] { return hang(made, images).back() == place; };
        while (!hangs() && set.number < images.images.size()) ++set.number;
        if (set.number == images.images.size()) set.number = 0;
    }
    return made;
}

}  // namespace macula::study
