#include "dicom/loader.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

#include "base/available_memory.h"
#include "base/check.h"
#include "base/exceptions.h"
#include "base/parallel.h"
#include "dicom/pixels/alternation.h"
#include "dicom/pixels/cell_alignment.h"
#include "dicom/pixels/frame_decoder.h"
#include "dicom/pixels/image_checks.h"
#include "dicom/pixels/slice_sources.h"
#include "dicom/read/dataset.h"
#include "dicom/stack/split_rules.h"
#include "dicom/stack/value_unit.h"

namespace macula::dicom {

namespace {

constexpr std::size_t kCoarseStep = 4;
constexpr std::size_t kLeastForCoarse = 16;  // slices

Error notUsable(Text message, Text action = Text("Choose another series.")) {
    return {ErrorCode::inputNotUsable, std::move(message), {}, std::move(action)};
}

Result<void> check(const Stack& stack) {
    if (const Message* reason = stack.whyNoVolume()) return notUsable(reason->sentence, reason->action);
    if (stack.slices.empty() || !stack.worldFromVoxel) return notUsable(Text("This series is no volume."));
    if (std::min(stack.columns, stack.rows) < 1 || std::max(stack.columns, stack.rows) > kMostRows)
        return notUsable(Text("The images of this series have no usable size."));
    for (const Frame& frame : stack.frames) {
        const Instance& instance = *frame.instance;
        if (!instance.format || instance.columns != stack.columns || instance.rows != stack.rows)
            return notUsable(Text("The images of this series differ in size or in kind."));
    }
    for (const SliceSource& source : stack.slices)
        MACULA_CHECK(source.below < stack.frames.size() && source.above < stack.frames.size());
    return {};
}

// The position of each frame on the grid, in slices.
std::vector<double> placesOf(const Stack& stack) {
    const glm::dmat4 voxelFromWorld = glm::inverse(*stack.worldFromVoxel);
    std::vector<double> places;
    for (std::size_t f = 0; f < stack.frames.size(); ++f) {
        const auto& position = stack.frames[f].positionMm;
        places.push_back(position ? transformPoint(voxelFromWorld, *position).z : static_cast<double>(f));
    }
    for (std::size_t k = 0; k < stack.slices.size(); ++k) {
        if (!stack.slices[k].interpolated()) places[stack.slices[k].below] = static_cast<double>(k);
    }
    return places;
}

// Body Part Examined if all images agree; otherwise empty.
std::string bodyPartOf(const Stack& stack) {
    const std::vector<Attribute>& attributes = splitRules().attributes;
    const auto named = std::ranges::find(attributes, "BodyPartExamined", &Attribute::name);
    MACULA_CHECK(named != attributes.end());
    const auto at = std::size_t(named - attributes.begin());
    const auto partOf = [&](const Frame& frame) {
        return at < frame.attributes.size() ? frame.attributes[at] : std::string();
    };
    if (stack.frames.empty()) return {};
    std::string part = partOf(stack.frames.front());
    const bool isSame =
        std::ranges::all_of(stack.frames, [&](const Frame& frame) { return partOf(frame) == part; });
    return isSame ? part : std::string();
}

// The SUV factor of a stack whose values are Bq/mL, or SUV already.
std::optional<double> suvFactorOf(const Stack& stack) {
    const ValueUnit unit = valueUnit(stack.modality, stack.frames);
    const bool isSuv = unit.unit == Unit::other && unit.name == kGramsPerMillilitre;
    return isSuv || unit.unit == Unit::becquerelsPerMillilitre ? stack.suvFactor : std::nullopt;
}

// The window in SUV. LINEAR subtracts one stored step from the width (PS3.3 C.11.2.1.2.1), which SUV does not
// have, so it becomes LINEAR_EXACT.
DisplayWindow timesSuv(const DisplayWindow& window, double factor) {
    DisplayWindow scaled = window;
    const bool isLinear = window.function.empty() || window.function == "LINEAR";
    scaled.center = factor * (isLinear ? window.center - 0.5 : window.center);
    scaled.width = factor * (isLinear ? std::max(window.width - 1.0, 0.0) : window.width);
    if (isLinear) scaled.function = "LINEAR_EXACT";
    return scaled;
}

// The state of loading one stack.
class Loading {
  public:
    Loading(const Series& series, const Stack& stack, const LoadOptions& options)
        : series_(series),
          stack_(stack),
          suv_(options.inSuv ? suvFactorOf(stack) : std::nullopt),
          samples_(stack.columns, stack.rows, stack.frames.size()) {
        for (const Frame& frame : stack.frames) intensities_.push_back(sliceIntensity(frame));
        if (auto said = completePadding(intensities_)) assumptions_.push_back(*said);
        plan_ = planFromFormats(intensities_);
        places_ = placesOf(stack);
        ownSlice_.assign(stack.frames.size(), kNone);
        for (std::size_t k = 0; k < stack.slices.size(); ++k) {
            const SliceSource& source = stack.slices[k];
            if (!source.interpolated() && ownSlice_[source.below] == kNone) ownSlice_[source.below] = k;
        }
        loose_ = static_cast<std::size_t>(std::ranges::count(ownSlice_, kNone));
    }

    // The peak memory: all decoded voxels, samples, and first the coarse volume, later the narrowed one.
    std::uint64_t bytesNeeded(const LoadOptions& options) const {
        const std::uint64_t cell = isFloat() ? sizeof(float) : sizeof(std::uint16_t);
        const std::uint64_t slices = stack_.slices.size();
        const std::uint64_t coarse = makesCoarse(options) ? slices / kCoarseStep + 1 : 0;
        const std::uint64_t narrow = plan_.steps ? slices : 0;
        return samples_.bytes() +
               std::uint64_t{sliceVoxels()} * std::max(cell * (slices + loose_ + coarse),
                                                       cell * slices + sizeof(std::uint16_t) * narrow);
    }

    Result<std::shared_ptr<const Volume>> run(Progress& progress, const LoadOptions& options);

  private:
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    bool makesCoarse(const LoadOptions& options) const {
        return options.onCoarse && stack_.slices.size() >= kLeastForCoarse;
    }
    // Whether the first slices of the stack are lost, so that slices of the volume have other numbers.
    bool isRenumbered() const { return usable_.first > 0; }
    bool isFloat() const { return plan_.format == VoxelFormat::float32; }
    UnitsFromStored inShownUnits(const UnitsFromStored& map) const {
        const double factor = suv_.value_or(1.0);
        return {.slope = factor * map.slope, .intercept = factor * map.intercept};
    }
    void toShownUnits(std::vector<float>& values) const {
        if (!suv_) return;
        for (float& value : values) value = static_cast<float>(*suv_ * double{value});
    }
    std::size_t sliceVoxels() const {
        return static_cast<std::size_t>(stack_.columns) * static_cast<std::size_t>(stack_.rows);
    }

    void allocate();
    std::vector<std::size_t> order(std::size_t& coarseCount) const;
    std::shared_ptr<const Volume> coarse(std::span<const std::size_t> frames,
                                         const FrameDecoder& decoder) const;
    template <class T>
    void makeSlice(const SliceSource& source, std::span<const std::span<T>> frames,
                   std::span<T> result) const;
    Result<void> drop(const FrameDecoder& decoder);
    template <class T>
    void finish(std::vector<T>& voxels, std::span<const std::span<T>> frames, Progress& progress);
    void tellAlternation();
    VolumeOptions describe(std::size_t first, std::size_t step, std::span<const SliceSource> slices) const;
    Result<Volume> make(Progress& progress);
    void say(Message message) {
        if (message.severity == Severity::warning) assumptions_.push_back(message.sentence);
        messages_.push_back(std::move(message));
    }

    const Series& series_;
    const Stack& stack_;
    const std::optional<double> suv_;  // SUV = factor * value; nothing: values stay as they are
    std::vector<SliceIntensity> intensities_;
    IntensityPlan plan_;
    std::vector<double> places_;
    std::vector<std::size_t> ownSlice_;  // the slice that each frame is; kNone for a frame that is no slice
    std::size_t loose_ = 0;              // frames that are not slices, but from which slices are interpolated

    std::vector<std::uint16_t> stored_;
    std::vector<std::uint16_t> looseStored_;
    std::vector<float> values_;
    std::vector<float> looseValues_;
    std::vector<std::span<std::uint16_t>> storedFrames_;
    std::vector<std::span<float>> valueFrames_;

    SliceSamples samples_;  // one entry for each frame
    UsableSlices usable_;
    std::vector<Text> assumptions_;
    std::vector<Message> messages_;
};

// The target of each frame: the slice that it is, or a buffer of its own.
template <class T>
std::vector<std::span<T>> spansOf(std::vector<T>& voxels, std::vector<T>& loose, std::size_t sliceVoxels,
                                  std::span<const std::size_t> ownSlice, std::size_t none) {
    std::vector<std::span<T>> frames;
    std::size_t next = 0;
    for (const std::size_t k : ownSlice) {
        frames.push_back(k == none ? std::span(loose).subspan(next++ * sliceVoxels, sliceVoxels)
                                   : std::span(voxels).subspan(k * sliceVoxels, sliceVoxels));
    }
    return frames;
}

void Loading::allocate() {
    const std::size_t voxels = sliceVoxels() * stack_.slices.size();
    if (isFloat()) {
        values_.resize(voxels);
        looseValues_.resize(sliceVoxels() * loose_);
        valueFrames_ = spansOf(values_, looseValues_, sliceVoxels(), ownSlice_, kNone);
    } else {
        stored_.resize(voxels);
        looseStored_.resize(sliceVoxels() * loose_);
        storedFrames_ = spansOf(stored_, looseStored_, sliceVoxels(), ownSlice_, kNone);
    }
}

// The order of decoding. Frames that every fourth slice needs come first. Within both groups, frames of one
// file keep their order, because a deflated file can only be read forward.
std::vector<std::size_t> Loading::order(std::size_t& coarseCount) const {
    std::vector<bool> first(stack_.frames.size(), false);
    for (std::size_t k = 0; k < stack_.slices.size(); k += kCoarseStep)
        first[stack_.slices[k].below] = first[stack_.slices[k].above] = true;
    std::map<const Instance*, std::size_t> files;
    for (const Frame& frame : stack_.frames) files.try_emplace(frame.instance.get(), files.size());
    std::vector<std::size_t> order(stack_.frames.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t f) {
        const Frame& frame = stack_.frames[f];
        return std::tuple(!first[f], files[frame.instance.get()], frame.number);
    });
    coarseCount = static_cast<std::size_t>(std::ranges::count(first, true));
    return order;
}

template <class T>
void Loading::makeSlice(const SliceSource& source, std::span<const std::span<T>> frames,
                        std::span<T> result) const {
    const std::span<const T> below = frames[source.below];
    if (!source.interpolated()) {
        std::ranges::copy(below, result.begin());
    } else if constexpr (std::is_same_v<T, float>) {
        blend(below, frames[source.above], source.weight, result);
    } else {
        blend(below, frames[source.above], source.weight, plan_.padding, result);
    }
}

VolumeOptions Loading::describe(std::size_t first, std::size_t step,
                                std::span<const SliceSource> slices) const {
    glm::dmat4 affine = *stack_.worldFromVoxel;
    affine[3] = affine * glm::dvec4(0.0, 0.0, static_cast<double>(first), 1.0);
    affine[2] *= static_cast<double>(step);
    const ValueUnit unit = valueUnit(stack_.modality, stack_.frames);
    // Windows of the file apply to rescaled values, not to those of a real world value mapping.
    const Frame& middle = stack_.frames[stack_.frames.size() / 2];
    VolumeOptions options{.size = {stack_.columns, stack_.rows, static_cast<int>(slices.size())},
                          .worldFromVoxel = affine,
                          .unit = unit.unit,
                          .modality = stack_.modality,
                          .provenance = {.studyInstanceUid = series_.studyInstanceUid,
                                         .seriesInstanceUid = series_.seriesInstanceUid,
                                         .description = series_.description,
                                         .assumptions = series_.assumptions,
                                         .messages = messages_,
                                         .interpolatedSlices = interpolatedRanges(slices),
                                         .isCalibrated = stack_.isCalibrated},
                          .unitName = unit.name,
                          .windows = middle.realWorld ? std::vector<DisplayWindow>() : middle.windows,
                          .bodyPart = bodyPartOf(stack_)};
    auto& assumptions = options.provenance.assumptions;
    std::ranges::remove_copy_if(
        stack_.assumptions, std::back_inserter(assumptions), [&](const auto& sentence) {
            return isRenumbered() && std::ranges::any_of(stack_.messages, [&](const Message& m) {
                       return m.key == key::kGapInterpolated && m.sentence == sentence;
                   });
        });
    assumptions.insert(assumptions.end(), assumptions_.begin(), assumptions_.end());
    if (!isFloat()) {
        options.unitsFromStored = inShownUnits(plan_.unitsFromStored);
        options.padding = plan_.padding;
    }
    if (suv_) {
        options.unit = Unit::suvBodyWeight;
        options.unitName.clear();
        for (DisplayWindow& window : options.windows) window = timesSuv(window, *suv_);
    }
    return options;
}

// A coarse volume from those of `frames` that could be decoded; null when there are too few. Reads the state
// of no other frame.
std::shared_ptr<const Volume> Loading::coarse(std::span<const std::size_t> frames,
                                              const FrameDecoder& decoder) const {
    std::vector<bool> usable(stack_.frames.size(), false);
    for (const std::size_t f : frames) usable[f] = decoder.state(f) == FrameState::decoded;
    const UsableSlices all = withoutFrames(stack_.slices, places_, usable);
    const std::size_t first = (all.first + kCoarseStep - 1) / kCoarseStep * kCoarseStep;
    std::vector<SliceSource> slices;
    for (std::size_t k = first; k < all.first + all.slices.size(); k += kCoarseStep)
        slices.push_back(all.slices[k - all.first]);
    if (slices.size() < 2) return nullptr;

    const std::size_t count = sliceVoxels();
    const auto filled = [&]<class T>(const std::vector<std::span<T>>& from) {
        std::vector<T> voxels(count * slices.size());
        for (std::size_t k = 0; k < slices.size(); ++k)
            makeSlice<T>(slices[k], from, std::span(voxels).subspan(k * count, count));
        return voxels;
    };
    VolumeOptions options = describe(first, kCoarseStep, slices);
    const auto made = [&] {
        if (!isFloat()) return Volume::create(std::move(options), filled(storedFrames_));
        std::vector<float> values = filled(valueFrames_);
        toShownUnits(values);
        return Volume::createFloat(std::move(options), std::move(values));
    };
    auto volume = made();
    if (!volume) return nullptr;
    return std::make_shared<const Volume>(std::move(*volume));
}

// Removes frames that could not be decoded or are wrong, and adds messages on them.
Result<void> Loading::drop(const FrameDecoder& decoder) {
    const std::size_t count = stack_.frames.size();
    std::vector<bool> usable(count);
    for (std::size_t f = 0; f < count; ++f) usable[f] = decoder.state(f) == FrameState::decoded;
    for (Message& told : checkImages(stack_, intensities_, decoder, samples_, usable)) say(std::move(told));
    std::size_t notFinite = 0;
    for (std::size_t f = 0; f < count; ++f) notFinite += usable[f] ? decoder.notFinite(f) : 0;
    if (notFinite > 0) say(message(key::kNonFiniteValues, {{"count", std::int64_t(notFinite)}}));
    const auto good = static_cast<std::size_t>(std::ranges::count(usable, true));
    if (good == count) {
        usable_ = {.first = 0, .slices = stack_.slices};
        return {};
    }
    Error error = decoder.failure().value_or(notUsable(
        Text("The values of these cannot be what the images say."), Text("Export the series again.")));
    error.message = Text("{} of the {} images cannot be decoded. {}", count - good, count, error.message);
    if (good < 2 || 2 * good < count) return error;
    usable_ = withoutFrames(stack_.slices, places_, usable);
    if (usable_.slices.size() < 2) return error;

    constexpr std::pair<FrameState, std::string_view> kKinds[]{
        {FrameState::cutOff, key::kTruncatedFile},
        {FrameState::damaged, key::kDamagedFile},
        {FrameState::unreadable, key::kUnreadableFile}};
    for (const auto& [state, key] : kKinds) {
        std::int64_t frames = 0;
        for (std::size_t f = 0; f < count; ++f) frames += decoder.state(f) == state ? 1 : 0;
        if (frames > 0) say(message(key, {{"count", frames}}));
    }
    if (const std::size_t lost = stack_.slices.size() - usable_.slices.size(); lost > 0) {
        const double spacingMm = glm::length(glm::dvec3((*stack_.worldFromVoxel)[2]));
        say(message(key::kMissingSlices, {{"missing", std::int64_t(lost)},
                                          {"total", std::int64_t(stack_.slices.size())},
                                          {"spacingMm", spacingMm}}));
    }
    // Reports only slices that were not interpolated before, unless slices were renumbered.
    std::vector<SliceSource> added = usable_.slices;
    for (std::size_t k = 0; k < added.size(); ++k) {
        const SliceSource& before = stack_.slices[usable_.first + k];
        if (before.interpolated() && !isRenumbered()) added[k] = {};
    }
    std::int64_t interpolated = 0;
    const std::vector<SliceRange> ranges = interpolatedRanges(added);
    for (const SliceRange& range : ranges) interpolated += range.last - range.first + 1;
    if (interpolated > 0) {
        say(message(key::kGapInterpolated,
                    {{"count", interpolated}, {"slices", macula::dicom::describe(ranges)}}));
    }
    return {};
}

// Interpolates the slices that have no frame, and cuts off the ends that are lost.
template <class T>
void Loading::finish(std::vector<T>& voxels, std::span<const std::span<T>> frames, Progress& progress) {
    const std::size_t count = sliceVoxels();
    parallelFor(
        usable_.slices.size(),
        [&](std::size_t i) {
            const std::size_t k = usable_.first + i;
            const SliceSource& source = usable_.slices[i];
            if (!source.interpolated() && ownSlice_[source.below] == k) return;
            makeSlice<T>(source, frames, std::span(voxels).subspan(k * count, count));
        },
        progress.token());
    if (usable_.first > 0)
        voxels.erase(voxels.begin(), voxels.begin() + static_cast<std::ptrdiff_t>(usable_.first * count));
    voxels.resize(usable_.slices.size() * count);
}

// Warns if slices alternate in the longest run without an interpolated slice.
void Loading::tellAlternation() {
    std::vector<std::span<const float>> longest;
    std::vector<std::span<const float>> run;
    for (const SliceSource& source : usable_.slices) {
        if (source.interpolated()) {
            run.clear();
        } else {
            run.push_back(samples_[source.below]);
        }
        if (run.size() > longest.size()) longest = run;
    }
    if (alternates(longest) || noiseAlternates(longest)) say(message(key::kAlternatingValues));
}

Result<Volume> Loading::make(Progress& progress) {
    VolumeOptions options = describe(usable_.first, 1, usable_.slices);
    if (!isFloat()) return Volume::create(std::move(options), std::move(stored_));
    if (plan_.steps) {
        if (auto narrow = narrowed(values_, *plan_.steps, progress.token())) {
            options.unitsFromStored = inShownUnits(narrow->unitsFromStored);
            options.padding = narrow->padding;
            return Volume::create(std::move(options), std::move(narrow->voxels));
        }
    }
    toShownUnits(values_);
    return Volume::createFloat(std::move(options), std::move(values_));
}

Result<std::shared_ptr<const Volume>> Loading::run(Progress& progress, const LoadOptions& options) {
    progress.beginStage(Text("Decoding {} slices", stack_.frames.size()), stack_.frames.size());
    if (const std::size_t moved = alignCells(stack_, intensities_, progress.token()); moved > 0) {
        say(message(key::kBitsMisplaced,
                    {{"count", std::int64_t(moved)}, {"total", std::int64_t(stack_.frames.size())}}));
    }
    allocate();
    std::vector<FrameDecoder::Target> targets(stack_.frames.size());
    for (std::size_t f = 0; f < targets.size(); ++f) {
        if (isFloat()) {
            targets[f].values = valueFrames_[f];
        } else {
            targets[f].stored = storedFrames_[f];
        }
    }
    FrameDecoder decoder(stack_, intensities_, plan_, targets, &samples_);
    std::size_t coarseCount = 0;
    const std::vector<std::size_t> frames = order(coarseCount);
    std::function<void()> onFirst;
    if (makesCoarse(options)) {
        onFirst = [&] {
            try {
                if (auto volume = coarse(std::span(frames).first(coarseCount), decoder))
                    options.onCoarse(std::move(volume));
            } catch (const CheckFailure&) {
                throw;       // a bug in Macula, not a fault of the file
            } catch (...) {  // no memory, or no more threads
                // Then the whole volume is the first to be shown, or reports the error.
            }
        };
    }
    MACULA_TRY_VOID(decoder.run(frames, coarseCount, onFirst, progress));
    MACULA_TRY_VOID(drop(decoder));
    if (isFloat()) {
        finish<float>(values_, valueFrames_, progress);
    } else {
        finish<std::uint16_t>(stored_, storedFrames_, progress);
    }
    if (!progress.cancelled()) tellAlternation();
    looseStored_ = {};
    looseValues_ = {};
    if (progress.cancelled()) return Error{ErrorCode::cancelled, Text("Loading was cancelled."), {}, {}};
    MACULA_TRY(Volume volume, make(progress));
    if (progress.cancelled()) return Error{ErrorCode::cancelled, Text("Loading was cancelled."), {}, {}};
    return std::shared_ptr<const Volume>(std::make_shared<Volume>(std::move(volume)));
}

}  // namespace

Result<std::shared_ptr<const Volume>> loadVolume(const Series& series, const Stack& stack, Progress& progress,
                                                 const LoadOptions& options) {
    std::uint64_t bytes = 0;
    try {
        MACULA_TRY_VOID(check(stack));
        Loading loading(series, stack, options);
        bytes = loading.bytesNeeded(options);
        if (const auto available = availableMemory(); available && bytes > *available)
            return notEnoughMemory(bytes, *available);
        return loading.run(progress, options);
    } catch (const std::bad_alloc&) {
        return notEnoughMemory(bytes, availableMemory());
    } catch (const std::exception& thrown) {
        return errorOf(thrown, Text("load this series"));
    }
}

}  // namespace macula::dicom
