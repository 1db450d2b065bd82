#include "scene/presentation/softcopy_on_slices.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include "dicom/messages/messages.h"
#include "study/open/found_volumes.h"

namespace macula::scene {

namespace {

constexpr double kSameNumber = 1e-6;  // relative, of slopes and intercepts that are decimal strings

bool isSame(double a, double b) {
    return std::abs(a - b) <= kSameNumber * std::max({std::abs(a), std::abs(b), 1.0});
}

bool refersTo(const dicom::ReferencedFrames& image, const dicom::Frame& frame) {
    return image.sopInstanceUid == frame.instance->sopInstanceUid && image.holds(frame.number);
}

// Whether a part of the object applies to the frame: a part that names no images applies to all of the
// object.
bool isOf(const std::vector<dicom::ReferencedFrames>& images, const dicom::Frame& frame) {
    return images.empty() ||
           std::ranges::any_of(images, [&](const auto& image) { return refersTo(image, frame); });
}

class Showing {
  public:
    Showing(const dicom::SoftcopyState& said, const dicom::Stack& stack, const Volume& volume,
            bool isLowBright, SliceState usual)
        : said_(said), stack_(stack), volume_(volume), isLowBright_(isLowBright) {
        shown_.slices = std::move(usual);
    }

    Result<SoftcopyOnSlices> show(const std::string& where) {
        findImages();
        if (images_.empty())
            return Error{ErrorCode::inputNotUsable, Text("The presentation state is of other images."), where,
                         Text("Open the series of these images, or choose another presentation state.")};
        for (const auto& what : said_.leftOut)
            shown_.notes.push_back(
                dicom::message(dicom::key::kPresentationLeftOut, {{"what", what}}).sentence);
        if (images_.size() < stack_.frames.size())
            note(Text("It is of some of the images alone; the others are shown in the same way."));
        showWindow();
        // The object's polarity replaces that of the images (PS3.3 C.11.6), which slices have by default.
        shown_.slices.isInverted = said_.isInverse != isLowBright_;
        showPlace();
        return std::move(shown_);
    }

  private:
    void note(Text sentence) { shown_.notes.push_back(std::move(sentence)); }
    const dicom::Frame& first() const { return *images_.front(); }

    // The position of an image, and of a frame in it, among those that the object names. If it names an image
    // without frames, they count in their own order.
    using Order = std::pair<std::size_t, std::size_t>;

    void findImages() {
        std::multimap<std::string_view, std::size_t> wanted;
        for (std::size_t i = 0; i < said_.images.size(); ++i)
            wanted.emplace(said_.images[i].sopInstanceUid, i);
        Order least{said_.images.size(), 0};
        for (const dicom::Frame& frame : stack_.frames) {
            std::optional<Order> named;
            const auto [from, to] = wanted.equal_range(frame.instance->sopInstanceUid);
            for (auto at = from; at != to && !named; ++at) {
                const std::vector<int>& numbers = said_.images[at->second].numbers;
                const auto number = std::ranges::find(numbers, frame.number + 1);
                if (numbers.empty()) {
                    named = Order(at->second, std::size_t(frame.number));
                } else if (number != numbers.end()) {
                    named = Order(at->second, std::size_t(number - numbers.begin()));
                }
            }
            if (!named) continue;
            images_.push_back(&frame);
            if (*named >= least) continue;
            // The front is the first frame that the object names, not the lowest slice.
            least = *named;
            std::swap(images_.front(), images_.back());
        }
    }

    // Whether the object's windows refer to the values of the volume.
    bool hasValuesOfVolume() const {
        if (said_.hasModalityTable || volume_.unit() == Unit::suvBodyWeight) return false;
        return std::ranges::all_of(images_, [&](const dicom::Frame* frame) {
            return frame->modalityLut == nullptr && !frame->modalityLutInvalid && !frame->rescaleInvalid &&
                   !frame->realWorld && isSame(said_.slope, frame->slope.value_or(1.0)) &&
                   isSame(said_.intercept, frame->intercept.value_or(0.0));
        });
    }

    void showWindow() {
        const auto meant = std::ranges::find_if(
            said_.windows, [&](const dicom::SoftcopyWindow& window) { return isOf(window.images, first()); });
        if (meant == said_.windows.end()) {
            if (!said_.windows.empty()) note(Text("It has no window for its first image here."));
            return;
        }
        if (!meant->window)
            return note(Text("Its window is a table of values (VOI LUT), which is not shown."));
        if (!hasValuesOfVolume())
            return note(Text("Its window is of other values than those of the volume, and is not shown."));
        shown_.slices.window = meant->window;
        if (std::ranges::any_of(said_.windows, [&](const dicom::SoftcopyWindow& other) {
                return other.window != meant->window;
            }))
            note(Text("It has several windows; that of its first image is shown."));
    }

    void showPlace() {
        const dicom::Frame& image = first();
        if (!image.plane)
            return note(Text("Where its images lie is not known: the slices stay where they are."));
        shown_.slices.asAcquired = true;
        shown_.slices.turn.reset();
        const dicom::ImagePlane& plane = *image.plane;
        const auto placeMm = [&](const glm::dvec2& pixel) {
            return plane.positionMm + plane.rowDirection * (pixel.x * plane.columnSpacingMm) +
                   plane.columnDirection * (pixel.y * plane.rowSpacingMm);
        };
        const glm::dvec2 size(image.instance->columns, image.instance->rows);
        shown_.slices.crosshairMm = placeMm(0.5 * (size - 1.0));
        // Whole turns change nothing.
        if (said_.isFlipped || said_.rotationDeg % 360 != 0)
            return note(Text(
                "It turns or mirrors its images, which slices here never do: its part of the image is not "
                "shown."));
        const auto meant = std::ranges::find_if(
            said_.areas, [&](const dicom::DisplayedArea& area) { return isOf(area.images, first()); });
        if (meant == said_.areas.end()) return;
        if (meant->size == dicom::DisplayedSize::trueSize)
            note(Text("It asks for the true size on the screen, which is not shown: slices fit their pane."));
        if (meant->size == dicom::DisplayedSize::magnified)
            note(Text("It asks for a fixed magnification, which is not shown: slices fit their pane."));
        const glm::dvec2 low(meant->topLeft);
        const glm::dvec2 high(meant->bottomRight);
        if (low.x <= 1.0 && low.y <= 1.0 && high.x >= size.x && high.y >= size.y) return;
        const glm::dvec3 centre = placeMm(0.5 * (low + high) - 1.0);
        const Box box = volume_.worldBox();
        if (glm::any(glm::lessThan(centre, box.low)) || glm::any(glm::greaterThan(centre, box.high)))
            return note(Text("Its part of the image lies beside the volume, and is not shown."));
        shown_.slices.crosshairMm = centre;
        shown_.area = areaOf(plane, centre, high - low + 1.0);
    }

    // The size of the displayed part of the image along the axes of the pane, which run along those of the
    // image.
    SliceArea areaOf(const dicom::ImagePlane& plane, const glm::dvec3& centreMm,
                     const glm::dvec2& pixels) const {
        const slices::SlicePlane pane = slices::acquiredPlane(volume_, centreMm);
        const glm::dvec3 alongMm = plane.rowDirection * (pixels.x * plane.columnSpacingMm);
        const glm::dvec3 acrossMm = plane.columnDirection * (pixels.y * plane.rowSpacingMm);
        const auto reach = [&](const glm::dvec3& axis) {
            return std::abs(glm::dot(alongMm, axis)) + std::abs(glm::dot(acrossMm, axis));
        };
        return {.orientation = slices::acquiredOrientation(volume_),
                .centreMm = centreMm,
                .sizeMm = {reach(pane.right), reach(pane.down)}};
    }

    const dicom::SoftcopyState& said_;
    const dicom::Stack& stack_;
    const Volume& volume_;
    const bool isLowBright_;
    // The images that are in the volume; the first that the object names is at the front.
    std::vector<const dicom::Frame*> images_;
    SoftcopyOnSlices shown_;
};

}  // namespace

Result<SoftcopyOnSlices> softcopyOn(const dicom::SoftcopyState& said, const dicom::Stack& stack,
                                    const Volume& volume, bool isLowBright, SliceState usual,
                                    const std::string& where) {
    return Showing(said, stack, volume, isLowBright, std::move(usual)).show(where);
}

Result<SoftcopyOnSlices> openSoftcopy(const std::filesystem::path& path, const study::OpenedStudy& study,
                                      SliceState usual) {
    if (!study.volume || !study.found)
        return Error{ErrorCode::usage,
                     Text("No DICOM study is open."),
                     {},
                     Text("Open the series of the presentation state first.")};
    MACULA_TRY(const dicom::SoftcopyState said, dicom::readSoftcopyState(path));
    return softcopyOn(said, *study.found->volumes().at(study.volumeIndex).stack, *study.volume,
                      study.isLowBright, std::move(usual), path.string());
}

}  // namespace macula::scene
