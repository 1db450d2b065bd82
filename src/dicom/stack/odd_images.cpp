#include "dicom/stack/odd_images.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "dicom/read/transfer_syntax.h"
#include "dicom/stack/value_unit.h"

namespace macula::dicom {

namespace {

// At most one in this many images of a part counts as odd: more are not an accident.
constexpr std::size_t kOneOddOf = 10;

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

bool hasRescale(const Frame& frame) {
    return !frame.modalityLut && !frame.modalityLutInvalid && frame.instance->format &&
           frame.instance->format->kind == CellKind::integer;
}

bool isReadable(const Frame& frame) {
    return frame.instance->format &&
           transferSyntaxInfo(frame.instance->transferSyntaxUid).codec != Codec::unsupported;
}

bool isComplete(const Frame& frame) {
    return frame.slope && frame.intercept && !frame.rescaleInvalid;
}

// The largest magnitude that the stored bits can give.
double reachOf(const Frame& frame) {
    const CellFormat& format = *frame.instance->format;
    return std::abs(*frame.slope) * std::exp2(format.bitsStored) + std::abs(*frame.intercept);
}

// The rescale that the complete images have in common.
struct UsualRescale {
    bool positive = true;
    double slope = 1.0;  // magnitude
    double reach = 1.0;
    bool isOneAndZero = true;  // each of them
};

UsualRescale usualOf(const std::vector<Frame>& frames) {
    std::vector<double> slopes;
    std::vector<double> reaches;
    std::size_t negative = 0;
    UsualRescale usual;
    for (const Frame& frame : frames) {
        if (!hasRescale(frame) || !isComplete(frame)) continue;
        slopes.push_back(std::abs(*frame.slope));
        reaches.push_back(reachOf(frame));
        negative += *frame.slope < 0.0 ? 1 : 0;
        usual.isOneAndZero = usual.isOneAndZero && *frame.slope == 1.0 && *frame.intercept == 0.0;
    }
    usual.positive = 2 * negative <= slopes.size();
    usual.slope = median(slopes);
    usual.reach = median(reaches);
    return usual;
}

bool isAbsurd(const Frame& frame, const UsualRescale& usual, const std::string& modality) {
    if (modality == "CT") {  // PS3.3 C.8.2.1: Hounsfield units, whatever the scanner
        constexpr double kMostHu = 1e6;
        constexpr double kLeastSlope = 1e-5;
        return reachOf(frame) > kMostHu + usual.reach || std::abs(*frame.slope) < kLeastSlope * usual.slope;
    }
    constexpr double kMostTimesUsual = 1e6;  // PET slices of one series differ by thousands
    return reachOf(frame) > kMostTimesUsual * usual.reach ||
           std::abs(*frame.slope) * kMostTimesUsual < usual.slope;
}

bool hasNoRescale(const Frame& frame) {
    return !frame.slope && !frame.intercept && !frame.rescaleInvalid;
}

// Whether images without any rescale are of another kind than those with one, and not just a few, where no
// rescale is required (PS3.3 A.4.3, MR): magnitude has none, phase has one, in one series.
bool areOfAnotherKind(const std::vector<Frame>& frames, const std::string& modality) {
    if (modality == "CT" || modality == "PT" || modality == "RTDOSE") return false;
    std::set<std::vector<std::string>> without;
    std::set<std::vector<std::string>> with;
    std::size_t count = 0;
    for (const Frame& frame : frames) {
        (hasNoRescale(frame) ? without : with).insert(frame.imageType);
        count += hasNoRescale(frame) ? 1 : 0;
    }
    return kOneOddOf * count > frames.size() &&
           std::ranges::none_of(without, [&](const auto& type) { return with.contains(type); });
}

bool isOddRescale(const Frame& frame, const UsualRescale& usual, const std::string& modality) {
    if (!hasRescale(frame)) return false;
    if (frame.rescaleInvalid) return true;
    if (!isComplete(frame)) {
        return !(usual.isOneAndZero && frame.slope.value_or(1.0) == 1.0 &&
                 frame.intercept.value_or(0.0) == 0.0);
    }
    return isAbsurd(frame, usual, modality);
}

// A frame's position along the normal of the first frame, and its offset sideways.
struct Place {
    double alongMm;
    glm::dvec3 sidewaysMm;
    std::size_t frame;
};

std::vector<Place> placesOf(const std::vector<Frame>& frames) {
    std::vector<Place> places;
    const auto usable =
        std::ranges::find_if(frames, [](const Frame& f) { return f.plane && isUsable(*f.plane); });
    if (usable == frames.end()) return places;
    const glm::dvec3 normal = usable->plane->normal();
    for (std::size_t f = 0; f < frames.size(); ++f) {
        if (!frames[f].plane || !isUsable(*frames[f].plane)) continue;
        const glm::dvec3& at = frames[f].plane->positionMm;
        const double along = glm::dot(at, normal);
        places.push_back({along, at - along * normal, f});
    }
    std::ranges::sort(places, {}, &Place::alongMm);
    return places;
}

// Marks frames beyond a gap at one end of the stack, if they are too few to be a body region of their own.
void markFarEnds(const std::vector<Place>& places, double usualMm, std::vector<bool>& odd) {
    constexpr double kFarSteps = 8.0;
    const std::size_t most = std::max<std::size_t>(1, places.size() / (2 * kOneOddOf));
    const auto mark = [&](auto placeAt) {
        for (std::size_t n = 1; n <= most && n < places.size(); ++n) {
            const double gap = std::abs(placeAt(n).alongMm - placeAt(n - 1).alongMm);
            if (gap <= kFarSteps * usualMm) continue;
            for (std::size_t i = 0; i < n; ++i) odd[placeAt(i).frame] = true;
        }
    };
    mark([&](std::size_t n) -> const Place& { return places[n]; });
    mark([&](std::size_t n) -> const Place& { return places[places.size() - 1 - n]; });
}

// Marks frames off the line that most lie on, whose slope (of a tilted gantry) and height are medians.
void markSideways(const std::vector<Place>& places, double toleranceMm, std::vector<bool>& odd) {
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> slopes;
        for (std::size_t n = 1; n < places.size(); ++n) {
            const double step = places[n].alongMm - places[n - 1].alongMm;
            if (step <= kSamePositionMm) continue;
            slopes.push_back((places[n].sidewaysMm[axis] - places[n - 1].sidewaysMm[axis]) / step);
        }
        if (slopes.empty()) return;
        const double slope = median(slopes);
        const auto height = [&](const Place& place) {
            return place.sidewaysMm[axis] - slope * place.alongMm;
        };
        std::vector<double> heights;
        for (const Place& place : places) heights.push_back(height(place));
        const double usual = median(heights);
        for (const Place& place : places) {
            if (std::abs(height(place) - usual) > toleranceMm) odd[place.frame] = true;
        }
    }
}

bool areVolume(const std::vector<Frame>& frames, const std::vector<bool>& leftOut) {
    std::vector<StackedPlane> planes;
    for (std::size_t f = 0; f < frames.size(); ++f) {
        if (!leftOut[f] && frames[f].plane)
            planes.push_back({*frames[f].plane, frames[f].instance->instanceNumber.value_or(0)});
    }
    return stackPlanes(planes).quality != StackGeometry::Quality::none;
}

std::vector<bool> oddPositions(const std::vector<Frame>& frames) {
    std::vector<bool> odd(frames.size(), false);
    std::vector<bool> none = odd;
    if (frames.size() < kOneOddOf || std::ranges::any_of(frames, [](const Frame& f) { return !f.plane; }))
        return odd;
    const std::vector<Place> places = placesOf(frames);
    if (10 * places.size() < 9 * frames.size()) return odd;
    for (std::size_t f = 0; f < frames.size(); ++f) odd[f] = !isUsable(*frames[f].plane);
    std::vector<double> steps;
    for (std::size_t n = 1; n < places.size(); ++n)
        steps.push_back(places[n].alongMm - places[n - 1].alongMm);
    const double usualMm = median(steps);
    if (usualMm <= kSamePositionMm) return none;  // phases
    constexpr double kSidewaysOfStep = 0.10;      // as stackPlanes allows
    markFarEnds(places, usualMm, odd);
    markSideways(places, kSidewaysOfStep * std::max(usualMm, frames[places[0].frame].plane->columnSpacingMm),
                 odd);
    const auto count = static_cast<std::size_t>(std::ranges::count(odd, true));
    if (count == 0 || count > frames.size() / kOneOddOf || !areVolume(frames, odd)) return none;
    return odd;
}

// The units that frames name, the most common first; fewer than two when they agree. A frame that names none
// may have any unit.
std::vector<std::string> unitsOf(const std::vector<Frame>& frames, const std::string& modality) {
    std::map<std::string, std::size_t> counts;
    for (const Frame& frame : frames) {
        if (std::string term = unitTerm(modality, frame); !term.empty()) ++counts[std::move(term)];
    }
    std::vector<std::string> units;
    for (const auto& [unit, count] : counts) units.push_back(unit);
    std::ranges::stable_sort(units, [&](const std::string& a, const std::string& b) {
        return std::pair(counts[a], a == "HU") > std::pair(counts[b], b == "HU");
    });
    return units;
}

// Removes the frames in other units than the most common from `frames`, and returns a stack for each unit.
std::vector<OddImages> takeOtherUnits(std::vector<Frame>& frames, const std::string& modality) {
    std::vector<OddImages> taken;
    const std::vector<std::string> units = unitsOf(frames, modality);
    for (std::size_t u = 1; u < units.size(); ++u) {
        OddImages other{.frames = {}, .label = {}, .message = {}};
        std::vector<Frame> kept;
        for (Frame& frame : frames)
            (unitTerm(modality, frame) == units[u] ? other.frames : kept).push_back(std::move(frame));
        frames = std::move(kept);
        const Text name = unitText(valueUnit(modality, other.frames));
        const Text text = name.empty() ? Text("another unit") : name;
        other.label = {modality == "PT" ? "Units" : "RescaleType", text.english()};
        other.message =
            message(key::kInconsistentUnits, {{"count", std::int64_t(other.frames.size())}, {"unit", text}});
        taken.push_back(std::move(other));
    }
    return taken;
}

// Removes the frames that `odd` marks from `frames`, and returns them.
OddImages take(std::vector<Frame>& frames, const std::vector<bool>& odd, StackLabel label,
               std::string_view key) {
    OddImages taken{.frames = {}, .label = std::move(label), .message = {}};
    std::vector<Frame> kept;
    for (std::size_t f = 0; f < frames.size(); ++f)
        (odd[f] ? taken.frames : kept).push_back(std::move(frames[f]));
    frames = std::move(kept);
    std::vector<const Frame*> named;
    for (const Frame& frame : taken.frames) named.push_back(&frame);
    taken.message =
        message(key, {{"count", std::int64_t(taken.frames.size())}, {"numbers", describeNumbers(named)}});
    return taken;
}

}  // namespace

std::vector<OddImages> takeOddImages(std::vector<Frame>& frames, const std::string& modality) {
    std::vector<OddImages> taken = takeOtherUnits(frames, modality);
    const auto takeThose = [&](const std::vector<bool>& odd, const char* attribute, std::string_view key) {
        const auto count = static_cast<std::size_t>(std::ranges::count(odd, true));
        if (count > 0 && count < frames.size())
            taken.push_back(take(frames, odd, {attribute, "not usable"}, key));
    };
    const auto marked = [&](const std::function<bool(const Frame&)>& isOdd) {
        std::vector<bool> odd;
        for (const Frame& frame : frames) odd.push_back(isOdd(frame));
        return odd;
    };
    const std::vector<bool> unreadable = marked([](const Frame& f) { return !isReadable(f); });
    if (2 * static_cast<std::size_t>(std::ranges::count(unreadable, true)) < frames.size())
        takeThose(unreadable, "TransferSyntaxUID", key::kOddEncoding);
    if (std::ranges::any_of(frames, [](const Frame& f) { return hasRescale(f) && isComplete(f); })) {
        const UsualRescale usual = usualOf(frames);
        const bool mayLack = areOfAnotherKind(frames, modality);
        takeThose(marked([&](const Frame& f) {
                      return !(mayLack && hasNoRescale(f)) && isOddRescale(f, usual, modality);
                  }),
                  "RescaleIntercept", key::kOddRescale);
        takeThose(marked([&](const Frame& f) {
                      return hasRescale(f) && isComplete(f) && (*f.slope > 0.0) != usual.positive;
                  }),
                  "RescaleSlope", key::kOddRescale);
    }
    takeThose(oddPositions(frames), "ImagePositionPatient", key::kOddPosition);
    return taken;
}

std::optional<Message> imagesWithoutPosition(const std::vector<Frame>& frames) {
    std::vector<const Frame*> unplaced;
    const Frame* placed = nullptr;
    for (const Frame& frame : frames) {
        if (frame.positionMm) {
            placed = &frame;
        } else {
            unplaced.push_back(&frame);
        }
    }
    if (placed == nullptr || unplaced.empty() || unplaced.size() * kOneOddOf > frames.size()) return {};
    // Captures and reports among the slices have another size or kind, and need no position.
    std::erase_if(unplaced, [&](const Frame* frame) {
        return frame->instance->sopClassUid != placed->instance->sopClassUid ||
               frame->instance->columns != placed->instance->columns ||
               frame->instance->rows != placed->instance->rows;
    });
    if (unplaced.empty()) return {};
    return message(key::kOddPosition,
                   {{"count", std::int64_t(unplaced.size())}, {"numbers", describeNumbers(unplaced)}});
}

Text describeNumbers(const std::vector<const Frame*>& frames) {
    constexpr std::size_t kMostCharacters = 100;
    std::vector<std::pair<int, int>> numbers;  // of the image, of its frame from 1 (0: single-frame)
    bool unnamed = false;
    for (const Frame* frame : frames) {
        const auto& number = frame->instance->instanceNumber;
        unnamed = unnamed || !number;
        if (number) numbers.emplace_back(*number, frame->instance->multiFrame ? frame->number + 1 : 0);
    }
    std::ranges::sort(numbers);
    std::string list;
    const auto add = [&](std::string_view text) { list += (list.empty() ? "" : ", ") + std::string(text); };
    for (std::size_t n = 0; n < numbers.size();) {
        if (list.size() > kMostCharacters) {
            add("…");
            return Text::verbatim(list);
        }
        const auto [image, frame] = numbers[n];
        std::size_t end = n + 1;
        while (frame == 0 && end < numbers.size() && numbers[end] == std::pair(image + int(end - n), 0))
            ++end;
        add(frame > 0     ? fmt::format("{}:{}", image, frame)
            : end - n > 1 ? fmt::format("{}-{}", image, numbers[end - 1].first)
                          : fmt::format("{}", image));
        n = end;
    }
    Text said = Text::verbatim(list);
    return unnamed ? Text::joined({std::move(said), Text("without a number")}, ", ") : said;
}

Text describeNumbers(const Stack& stack, const std::vector<std::size_t>& frames) {
    std::vector<const Frame*> named;
    for (const std::size_t frame : frames) named.push_back(&stack.frames[frame]);
    return describeNumbers(named);
}

}  // namespace macula::dicom
