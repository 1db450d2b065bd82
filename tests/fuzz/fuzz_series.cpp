// Any frames, built from the bytes, as a series: whatever they say of themselves, the stacks are a partition
// of them, what is called a volume can be one, and their order does not matter.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "base/check.h"
#include "base/log.h"
#include "dicom/best_volume.h"
#include "dicom/split/split.h"

namespace macula::dicom {
namespace {

// Takes values off the front; zeros when there are no more.
class Bytes {
  public:
    Bytes(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

    bool empty() const { return left_ == 0; }
    template <class T>
    T take() {
        T value{};
        const std::size_t bytes = std::min(sizeof(T), left_);
        std::memcpy(&value, data_, bytes);
        data_ += bytes;
        left_ -= bytes;
        return value;
    }
    template <class T, std::size_t N>
    const T& oneOf(const T (&choices)[N]) {
        return choices[take<std::uint8_t>() % N];
    }

  private:
    const std::uint8_t* data_;
    std::size_t left_;
};

constexpr const char* kValues[] = {"",
                                   "0",
                                   "1",
                                   "2",
                                   "3",
                                   "1.00001",
                                   "-1",
                                   "1e308",
                                   "nan",
                                   "101500",
                                   "101501.5",
                                   "ORIGINAL\\PRIMARY\\AXIAL",
                                   "1\\0\\0\\0\\1\\0",
                                   "MAGNITUDE",
                                   "2.25.7",
                                   "B30f"};
constexpr double kSpacings[] = {1.0, 0.7, 2.5, 5.0, 1e-3, 1e-9, 1e6, 0.0, -1.0};
constexpr double kPi = 3.14159265358979;

glm::dvec3 takeVector(Bytes& bytes) {
    glm::dvec3 vector;
    for (int i = 0; i < 3; ++i) vector[i] = bytes.take<double>();
    return vector;
}

// Of what the frames have in common, and what the next one is.
struct Builder {
    Bytes bytes;
    std::string modality;
    ImagePlane plane;
    glm::dvec3 stepMm{0, 0, 1};
    Instance shared;
    std::vector<std::string> attributes;

    Builder(const std::uint8_t* data, std::size_t size)
        : bytes(data, size), attributes(splitRules().attributes.size()) {
        static constexpr const char* kModalities[] = {"CT", "MR", "PT", "NM", ""};
        modality = bytes.oneOf(kModalities);
        turn();
        plane.columnSpacingMm = plane.rowSpacingMm = bytes.oneOf(kSpacings);
        stepMm = bytes.oneOf(kSpacings) * plane.normal();
        stepMm.y += 0.1 * bytes.take<std::int8_t>();  // a tilted gantry
        shared.columns = shared.rows = 16;
        shared.photometricInterpretation = "MONOCHROME2";
        shared.transferSyntaxUid = "1.2.840.10008.1.2.1";
        shared.format = CellFormat{};
    }

    void turn() {
        const double angle = bytes.take<std::uint8_t>() * kPi / 32;
        const double tilt = bytes.take<std::uint8_t>() * kPi / 32;
        plane.rowDirection = {std::cos(angle), std::sin(angle), 0};
        plane.columnDirection = {-std::sin(angle) * std::cos(tilt), std::cos(angle) * std::cos(tilt),
                                 std::sin(tilt)};
    }

    void changeInstance() {
        switch (bytes.take<std::uint8_t>() % 8) {
            case 0:
                shared.columns = bytes.take<std::int16_t>();
                break;
            case 1:
                shared.rows = bytes.take<std::int16_t>();
                break;
            case 2:
                shared.photometricInterpretation = (bytes.take<std::uint8_t>() & 1u) ? "RGB" : "MONOCHROME1";
                break;
            case 3:
                shared.format.reset();
                break;
            case 4:
                shared.transferSyntaxUid =
                    (bytes.take<std::uint8_t>() & 1u) ? "1.2.3" : "1.2.840.10008.1.2.4.90";
                break;
            case 5:
                shared.samplesPerPixel = bytes.take<std::int8_t>();
                break;
            case 6:
                shared.strayBytes = shared.lossy = true;
                break;
            default:
                shared.multiFrame = !shared.multiFrame;
        }
    }

    void changePlane() {
        switch (bytes.take<std::uint8_t>() % 6) {
            case 0:
                turn();
                break;
            case 1:
                plane.columnSpacingMm = bytes.take<double>();
                break;
            case 2:
                plane.rowSpacingMm = bytes.oneOf(kSpacings);
                break;
            case 3:
                plane.rowDirection = takeVector(bytes);
                break;
            case 4:
                plane.columnDirection = takeVector(bytes);
                break;
            default:
                stepMm = takeVector(bytes);
        }
    }

    void fill(Frame& frame, unsigned flags) {
        const double place = bytes.take<std::int8_t>();
        frame.positionMm = flags & 1u ? takeVector(bytes) : plane.positionMm + place * stepMm;
        frame.hasOrientation = true;
        frame.spacingSource = static_cast<PixelSpacingSource>(1 + (flags >> 1 & 1u));
        frame.plane = plane;
        frame.plane->positionMm = *frame.positionMm;
        frame.slope = 1.0;
        frame.intercept = -1024.0;
        frame.imageType = {"ORIGINAL", "PRIMARY", flags & 64u ? "AXIAL" : "OTHER"};
        if (flags & 2u) {
            const auto missing = bytes.take<std::uint8_t>();
            if (missing & 1u) frame.plane.reset();
            if (missing & 2u) frame.positionMm.reset();
            if (missing & 4u) frame.hasOrientation = false;
            if (missing & 8u) frame.slope.reset();
            if (missing & 16u) frame.rescaleInvalid = true;
            if (missing & 32u) frame.imageType = {"DERIVED", "SECONDARY", "LOCALIZER"};
            if (missing & 64u) frame.sliceLocation = bytes.take<double>();
            if (!frame.positionMm || !frame.hasOrientation) frame.plane.reset();
        }
        frame.attributes = attributes;
    }

    std::vector<Frame> frames() {
        constexpr std::size_t kMost = 100;
        std::vector<Frame> frames;
        std::shared_ptr<const Instance> instance;
        while (!bytes.empty() && frames.size() < kMost) {
            const unsigned flags = bytes.take<std::uint8_t>();
            if (flags & 4u) changeInstance();
            if (flags & 8u) changePlane();
            if (flags & 16u) {
                const std::size_t which = bytes.take<std::uint8_t>() % attributes.size();
                attributes[which] = bytes.oneOf(kValues);
            }
            const bool sameFile = (flags & 32u) && instance;
            if (!sameFile) {
                auto next = std::make_shared<Instance>(shared);
                const int number = bytes.take<std::int8_t>();
                if (number != -1) next->instanceNumber = number;
                const std::size_t uid = flags & 128u ? bytes.take<std::uint8_t>() : 1000 + frames.size();
                if (uid > 0) next->sopInstanceUid = fmt::format("2.25.{}", uid);
                instance = std::move(next);
            }
            Frame frame{.instance = instance, .number = sameFile ? frames.back().number + 1 : 0};
            fill(frame, flags);
            frames.push_back(std::move(frame));
        }
        return frames;
    }
};

// What every stack has to be.
void checkStack(const Stack& stack) {
    MACULA_CHECK(!stack.frames.empty());
    MACULA_CHECK(stack.phase >= 0 && stack.phase < stack.phases);
    if (!stack.canBeVolume()) {
        MACULA_CHECK(stack.whyNoVolume() != nullptr);
        return;
    }
    MACULA_CHECK(stack.worldFromVoxel && isInvertibleAffine(*stack.worldFromVoxel));
    MACULA_CHECK(stack.spacingMm.has_value());
    for (int axis = 0; axis < 3; ++axis) {
        MACULA_CHECK(std::isfinite((*stack.spacingMm)[axis]) && (*stack.spacingMm)[axis] > 0.0);
    }
    MACULA_CHECK(stack.slices.size() >= 2);
    MACULA_CHECK_LE(stack.slices.size(), 4 * stack.frames.size() + 1);
    MACULA_CHECK(stack.slices.front() == SliceSource{});
    MACULA_CHECK_EQ(stack.slices.back().below, stack.frames.size() - 1);
    double last = -1.0;
    for (const SliceSource& slice : stack.slices) {
        MACULA_CHECK_LT(slice.above, stack.frames.size());
        MACULA_CHECK(slice.above == slice.below + (slice.interpolated() ? 1 : 0));
        MACULA_CHECK(slice.weight >= 0.0 && slice.weight < 1.0);
        const double at = double(slice.below) + slice.weight;
        MACULA_CHECK(at >= last);  // NaN too fails
        last = at;
    }
    for (const Frame& frame : stack.frames) {
        MACULA_CHECK(frame.plane && isUsable(*frame.plane));
        MACULA_CHECK(frame.instance->columns == stack.columns && frame.instance->rows == stack.rows);
        MACULA_CHECK(frame.instance->format && frame.instance->samplesPerPixel == 1);
    }
}

using Identity = std::tuple<int, std::string, int>;  // as splitSeries orders frames

Identity identityOf(const Frame& frame) {
    return {frame.instance->instanceNumber.value_or(0), frame.instance->sopInstanceUid, frame.number};
}

void checkPartition(const std::vector<Frame>& frames, const Split& split) {
    std::map<Identity, int> count;
    for (const Frame& frame : frames) ++count[identityOf(frame)];
    for (const Stack& stack : split.stacks) {
        for (const Frame& frame : stack.frames) --count[identityOf(frame)];
    }
    for (const auto& [identity, left] : count) MACULA_CHECK_EQ(left, 0);
}

void checkSame(const Split& a, const Split& b) {
    MACULA_CHECK_EQ(a.stacks.size(), b.stacks.size());
    MACULA_CHECK_EQ(a.messages.size(), b.messages.size());
    for (std::size_t s = 0; s < a.stacks.size(); ++s) {
        const Stack& x = a.stacks[s];
        const Stack& y = b.stacks[s];
        MACULA_CHECK(x.splitBy == y.splitBy && x.phase == y.phase && x.phases == y.phases);
        MACULA_CHECK_EQ(x.frames.size(), y.frames.size());
        for (std::size_t i = 0; i < x.frames.size(); ++i) {
            MACULA_CHECK(identityOf(x.frames[i]) == identityOf(y.frames[i]));
        }
        MACULA_CHECK(x.slices == y.slices && x.canBeVolume() == y.canBeVolume());
        MACULA_CHECK_EQ(x.messages.size(), y.messages.size());
    }
}

void checkPlanes(const std::vector<Frame>& frames) {
    std::vector<StackedPlane> planes;
    for (const Frame& frame : frames) {
        if (frame.plane) planes.push_back({*frame.plane, frame.instance->instanceNumber.value_or(0)});
    }
    const StackGeometry geometry = stackPlanes(planes);
    const std::set<std::size_t> order(geometry.order.begin(), geometry.order.end());
    MACULA_CHECK_EQ(order.size(), planes.size());
    MACULA_CHECK(order.empty() || *order.rbegin() == planes.size() - 1);
    const bool isVolume = geometry.quality != StackGeometry::Quality::none;
    MACULA_CHECK_EQ(isVolume, geometry.worldFromVoxel.has_value());
    if (isVolume) {
        MACULA_CHECK(isInvertibleAffine(*geometry.worldFromVoxel) && std::isfinite(geometry.largestErrorMm));
    } else if (!planes.empty()) {
        MACULA_CHECK(!geometry.messages.empty());
    }
}

}  // namespace
}  // namespace macula::dicom

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace macula::dicom;
    macula::log::setLevel(macula::log::Level::off);
    Builder builder(data, size);
    std::vector<Frame> frames = builder.frames();
    checkPlanes(frames);
    Split split = splitSeries(frames, builder.modality, splitRules());
    for (const Stack& stack : split.stacks) checkStack(stack);
    checkPartition(frames, split);

    std::set<Identity> identities;
    for (const Frame& frame : frames) identities.insert(identityOf(frame));
    if (identities.size() == frames.size() && !frames.empty()) {
        std::reverse(frames.begin(), frames.end());
        std::rotate(frames.begin(), frames.begin() + static_cast<std::ptrdiff_t>(frames.size() / 3),
                    frames.end());
        checkSame(split, splitSeries(frames, builder.modality, splitRules()));
    }

    Series series;
    series.modality = builder.modality;
    series.stacks = std::move(split.stacks);
    const ChosenStack best = bestVolume(series);
    MACULA_CHECK_EQ(bool(best), series.canBeVolume());
    MACULA_CHECK(!best.why.empty() && (!best || best.stack->canBeVolume()));
    return 0;
}
