#include "dicom/pixels/frame_decoder.h"

#include <algorithm>
#include <atomic>
#include <mutex>

#include "base/check.h"
#include "base/parallel.h"
#include "dicom/pixels/pixels.h"
#include "dicom/read/random_file.h"

namespace macula::dicom {

struct FrameDecoder::Worker {
    const Instance* instance = nullptr;  // the file that `reader` has open
    std::optional<PixelReader> reader;
    std::optional<Error> openError;
    std::vector<std::uint16_t> cells;
    std::vector<double> numbers;
};

FrameDecoder::FrameDecoder(const Stack& stack, std::span<const SliceIntensity> intensities,
                           const IntensityPlan& plan, std::span<const Target> targets, SliceSamples* samples)
    : stack_(stack),
      intensities_(intensities),
      plan_(plan),
      targets_(targets),
      samples_(samples),
      states_(stack.frames.size(), FrameState::waiting),
      errors_(stack.frames.size()),
      beyondStoredBits_(stack.frames.size()),
      notFinite_(stack.frames.size()) {}

Error FrameDecoder::decode(std::size_t f, Worker& worker, const CancelToken& cancel) {
    const Frame& frame = stack_.frames[f];
    const Instance& instance = *frame.instance;
    const SliceIntensity& intensity = intensities_[f];
    if (worker.instance != &instance) {
        worker.instance = &instance;
        worker.reader.reset();
        worker.openError.reset();
        auto opened = PixelReader::open(instance.file,
                                        {.transferSyntaxUid = instance.transferSyntaxUid,
                                         .columns = instance.columns,
                                         .rows = instance.rows,
                                         .frames = instance.frames,
                                         .format = intensity.format},
                                        cancel);
        if (opened) {
            worker.reader.emplace(std::move(*opened));
        } else {
            worker.openError = opened.error();
        }
    }
    if (worker.openError) {
        states_[f] = RandomFile(instance.file).isOpen() ? FrameState::damaged : FrameState::unreadable;
        return *worker.openError;
    }

    const std::size_t count =
        static_cast<std::size_t>(instance.columns) * static_cast<std::size_t>(instance.rows);
    const bool inFloat = plan_.format == VoxelFormat::float32;
    const auto failed = [&](const Result<void>& result) {
        if (result) return false;
        states_[f] = worker.reader->isCutOff(frame.number) ? FrameState::cutOff : FrameState::damaged;
        return true;
    };
    if (!isNarrow(intensity.format)) {
        worker.numbers.resize(count);
        const auto read = worker.reader->readNumbers(frame.number, worker.numbers);
        if (failed(read)) return read.error();
        notFinite_[f] = applyIntensity(intensity, worker.numbers, targets_[f].values);
    } else {
        if (inFloat) worker.cells.resize(count);
        const std::span<std::uint16_t> cells = inFloat ? std::span(worker.cells) : targets_[f].stored;
        const auto read = worker.reader->read(frame.number, cells);
        if (failed(read)) return read.error();
        beyondStoredBits_[f] =
            dicom::cellsBeyondStoredBits(intensity.format, intensity.padding, cells, instance.overlayBits);
        unpackCells(intensity.format, intensity.padding, cells);
        if (inFloat) {
            applyIntensity(intensity, cells, targets_[f].values);
        } else {
            applyMap(plan_.slices[f], cells);
        }
    }
    if (samples_ != nullptr && inFloat) samples_->take(f, targets_[f].values);
    if (samples_ != nullptr && !inFloat)
        samples_->take(f, targets_[f].stored, plan_.unitsFromStored, plan_.padding);
    states_[f] = FrameState::decoded;
    return {};
}

Result<void> FrameDecoder::run(std::span<const std::size_t> order, std::size_t count,
                               const std::function<void()>& onFirst, Progress& progress) {
    std::atomic<std::size_t> next{0};
    std::atomic<std::size_t> waiting{std::min(count, order.size())};
    std::atomic<bool> outOfMemory{false};
    const auto work = [&](std::size_t) {
        Worker worker;
        for (;;) {
            const std::size_t i = next++;
            if (i >= order.size() || progress.cancelled() || outOfMemory) return;
            const std::size_t f = order[i];
            try {
                errors_[f] = decode(f, worker, progress.token());
            } catch (const CheckFailure&) {
                throw;       // a bug in Macula, not a fault of the file
            } catch (...) {  // the decoders throw nothing else
                outOfMemory = true;
            }
            if (states_[f] != FrameState::decoded && errors_[f].code == ErrorCode::outOfMemory)
                outOfMemory = true;
            // The last decrement makes visible to this thread what all others wrote.
            if (i < count && --waiting == 0 && onFirst && !outOfMemory && !progress.cancelled()) onFirst();
            progress.advance();
        }
    };
    parallelFor(std::min(coreCount(), order.size()), work);
    if (progress.cancelled()) return Error{ErrorCode::cancelled, Text("Loading was cancelled."), {}, {}};
    if (outOfMemory) {
        return Error{ErrorCode::outOfMemory,
                     Text("There is not enough memory to decode the slices."),
                     {},
                     Text("Close other programs, or choose a smaller series.")};
    }
    return {};
}

std::optional<Error> FrameDecoder::failure() const {
    const auto failed = std::find_if(states_.begin(), states_.end(),
                                     [](FrameState state) { return state != FrameState::decoded; });
    if (failed == states_.end()) return {};
    return errors_[static_cast<std::size_t>(failed - states_.begin())];
}

}  // namespace macula::dicom
