#include "dicom/pixels/odd_slices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace macula::dicom {

namespace {

// A reading that makes a slice differ this many times less explains why it is odd. A factor of two is chance;
// a wrong byte order or sign makes hundreds.
constexpr double kFarLess = 4.0;
constexpr std::array kReadings{SliceFault::otherSign, SliceFault::swappedBytes};

double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

// The mean difference; NaN where hardly any sample has a value in both.
double distance(std::span<const float> a, std::span<const float> b) {
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const float d = std::abs(a[i] - b[i]);
        if (!std::isfinite(d)) continue;
        sum += double{d};
        ++count;
    }
    constexpr std::size_t kLeastOf = 8;
    return count * kLeastOf < a.size() || count == 0 ? std::numeric_limits<double>::quiet_NaN()
                                                     : sum / static_cast<double>(count);
}

// The raw value of a cell, read with the other sign or byte order.
int readAs(SliceFault fault, const CellFormat& format, int raw) {
    const int whole = 1 << format.bitsStored;
    if (fault == SliceFault::otherSign) {
        if (format.isSigned) return raw < 0 ? raw + whole : raw;
        return raw >= whole / 2 ? raw - whole : raw;
    }
    const auto cell = static_cast<unsigned>(raw) & 0xFFFFu;
    const unsigned swapped = (cell << 8 | cell >> 8) & 0xFFFFu;
    return format.isSigned ? static_cast<std::int16_t>(swapped) : static_cast<int>(swapped);
}

// The samples as they would be with that reading; empty if it is impossible, or changes nothing.
std::vector<float> readAs(SliceFault fault, const SliceIntensity& intensity, std::span<const float> samples) {
    const CellFormat& format = intensity.format;
    if (intensity.modalityLut || !isNarrow(format)) return {};
    if (fault == SliceFault::swappedBytes && format.bitsStored != 16) return {};
    std::vector<float> values(samples.begin(), samples.end());
    bool differs = false;
    for (float& value : values) {
        if (std::isnan(value)) continue;
        const auto raw =
            static_cast<int>(std::lround((double{value} - intensity.intercept) / intensity.slope));
        const int other = readAs(fault, format, raw);
        differs = differs || other != raw;
        value = static_cast<float>(intensity.slope * other + intensity.intercept);
    }
    if (!differs) values.clear();
    return values;
}

// The index from which on all samples have the same value, or none.
std::size_t tailOf(std::span<const float> samples) {
    std::size_t begin = samples.size();
    const auto isLast = [&](float value) {
        return value == samples.back() || (std::isnan(value) && std::isnan(samples.back()));
    };
    while (begin > 0 && isLast(samples[begin - 1])) --begin;
    return samples.size() - begin;
}

class OddSlices {
  public:
    OddSlices(std::span<const std::size_t> slices, const SliceSamples& samples,
              std::span<const SliceIntensity> intensities)
        : slices_(slices), samples_(samples), intensities_(intensities) {
        for (std::size_t i = 0; i + 1 < slices.size(); ++i) steps_.push_back(distance(at(i), at(i + 1)));
        std::vector<double> known;
        std::ranges::copy_if(steps_, std::back_inserter(known), [](double d) { return std::isfinite(d); });
        typical_ = median(std::move(known));
        faults_.resize(slices.size());
    }

    std::vector<OddSlice> find() {
        findBlank();
        findReadOtherwise();
        findUnlike();
        std::vector<OddSlice> odd;
        for (std::size_t i = 0; i < faults_.size(); ++i) {
            if (faults_[i]) odd.push_back({slices_[i], *faults_[i]});
        }
        return odd;
    }

  private:
    std::span<const float> at(std::size_t i) const { return samples_[slices_[i]]; }
    // Whether values jump from slice `i` to the next one.
    bool isJump(std::size_t i) const { return !(steps_[i] <= kFarLess * typical_); }
    // The most slices, in a row or in all, that may be wrong by accident.
    std::size_t few() const { return std::max<std::size_t>(2, slices_.size() / 10); }

    // Whether both neighbours have an image where slice `i` has one value, and resemble each other more than
    // they resemble slice `i`.
    bool isBlankBetween(std::size_t below, std::size_t i, std::size_t above, std::size_t tail) const {
        const auto part = [&](std::size_t of) { return at(of).last(tail); };
        const float blank = at(i).back();
        const auto isFull = [&](std::size_t of) {
            constexpr std::size_t kLeastOf = 4;
            const auto same = std::ranges::count_if(
                part(of), [&](float value) { return value == blank || std::isnan(value); });
            return kLeastOf * (tail - static_cast<std::size_t>(same)) >= tail;
        };
        if (!isFull(below) || !isFull(above)) return false;
        // A slice that is padding only in part was not scanned there.
        if (std::isnan(blank)) return tail == at(i).size();
        const double apart = std::min(distance(part(below), part(i)), distance(part(i), part(above)));
        // A part may be blank where the patient ends: then the neighbours have little there.
        const double least = tail == at(i).size() ? 2.0 : kFarLess;
        return least * distance(part(below), part(above)) < apart;
    }

    void findBlank() {
        std::vector<std::size_t> tails;
        for (std::size_t i = 0; i < slices_.size(); ++i) tails.push_back(at(i).empty() ? 0 : tailOf(at(i)));
        for (std::size_t i = 1; i + 1 < slices_.size(); ++i) {
            const std::size_t size = at(i).size();
            constexpr std::size_t kLeastOf = 8;
            if (kLeastOf * tails[i] < size || tails[i] == 0) continue;
            const auto isShorter = [&](std::size_t j) { return tails[j] + size / kLeastOf <= tails[i]; };
            std::size_t below = i;
            while (below > 0 && i - below <= few() && !isShorter(below)) --below;
            std::size_t above = i;
            while (above + 1 < slices_.size() && above - i <= few() && !isShorter(above)) ++above;
            if (!isShorter(below) || !isShorter(above) || above - below - 1 > few()) continue;
            if (isBlankBetween(below, i, above, tails[i])) faults_[i] = SliceFault::blank;
        }
    }

    // The slices that may be read wrongly: those next to a jump, or with another sign than most.
    std::vector<bool> suspects() const {
        std::vector<bool> suspect(slices_.size(), false);
        std::size_t isSigned = 0;
        for (const std::size_t slice : slices_) isSigned += intensities_[slice].format.isSigned ? 1 : 0;
        const bool mostAreSigned = 2 * isSigned > slices_.size();
        for (std::size_t i = 0; i < slices_.size(); ++i)
            suspect[i] = intensities_[slices_[i]].format.isSigned != mostAreSigned;
        for (std::size_t i = 0; i < steps_.size(); ++i) {
            if (isJump(i)) suspect[i] = suspect[i + 1] = true;
        }
        return suspect;
    }

    void findReadOtherwise() {
        const std::vector<bool> suspect = suspects();
        for (std::size_t i = 0; i < slices_.size(); ++i) {
            if (!suspect[i] || faults_[i]) continue;
            std::vector<std::size_t> beside;
            for (std::size_t j = i; j-- > 0;) {
                if (suspect[j]) continue;
                beside.push_back(j);
                break;
            }
            for (std::size_t j = i + 1; j < slices_.size(); ++j) {
                if (suspect[j]) continue;
                beside.push_back(j);
                break;
            }
            for (const SliceFault reading : kReadings) {
                const std::vector<float> other = readAs(reading, intensities_[slices_[i]], at(i));
                if (other.empty()) continue;
                const bool fits = std::ranges::all_of(beside, [&](std::size_t j) {
                    return kFarLess * distance(other, at(j)) < distance(at(i), at(j));
                });
                if (fits && !beside.empty()) faults_[i] = reading;
            }
        }
    }

    // Finds one or two slices between neighbours that resemble each other more than they resemble these.
    void findUnlike() {
        if (!(typical_ > 0.0)) return;
        std::vector<std::size_t> unlike;
        for (std::size_t run = 1; run <= 2; ++run) {
            for (std::size_t below = 0; below + run + 1 < slices_.size(); ++below) {
                const std::size_t above = below + run + 1;
                if (!isJump(below) || !isJump(above - 1) || faults_[below] || faults_[above]) continue;
                const double across = distance(at(below), at(above));
                if (!(across > 0.0 && across <= static_cast<double>(run + 1) * typical_)) continue;
                for (std::size_t i = below + 1; i < above; ++i) {
                    const double apart = std::min(distance(at(below), at(i)), distance(at(i), at(above)));
                    if (!faults_[i] && apart > kFarLess * std::max(across, typical_)) unlike.push_back(i);
                }
            }
        }
        std::ranges::sort(unlike);
        unlike.erase(std::unique(unlike.begin(), unlike.end()), unlike.end());
        if (unlike.size() > few()) return;
        for (const std::size_t i : unlike) faults_[i] = SliceFault::unlike;
    }

    std::span<const std::size_t> slices_;
    const SliceSamples& samples_;
    std::span<const SliceIntensity> intensities_;
    std::vector<double> steps_;  // difference of each slice from the next
    double typical_ = 0.0;
    std::vector<std::optional<SliceFault>> faults_;
};

// How much neighbours in a row differ.
double roughness(std::span<const float> samples) {
    double sum = 0.0;
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const float d = std::abs(samples[i] - samples[i - 1]);
        if (i % SliceSamples::kRun != 0 && std::isfinite(d)) sum += double{d};
    }
    return sum;
}

bool sameRescale(const SliceIntensity& a, const SliceIntensity& b) {
    return a.slope == b.slope && a.intercept == b.intercept;
}

double medianDifference(std::span<const float> a, std::span<const float> b) {
    std::vector<double> differences;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (const float d = b[i] - a[i]; std::isfinite(d)) differences.push_back(double{d});
    }
    return median(std::move(differences));
}

// The samples of a slice with the rescale of another.
std::vector<float> withRescaleOf(const SliceIntensity& other, const SliceIntensity& own,
                                 std::span<const float> samples) {
    std::vector<float> values;
    for (const float value : samples) {
        const double raw = (double{value} - own.intercept) / own.slope;
        values.push_back(static_cast<float>(other.slope * raw + other.intercept));
    }
    return values;
}

}  // namespace

std::vector<OddSlice> findOddSlices(std::span<const std::size_t> slices, const SliceSamples& samples,
                                    std::span<const SliceIntensity> intensities) {
    constexpr std::size_t kLeastSlices = 4;  // fewer have no neighbours that agree
    if (slices.size() < kLeastSlices) return {};
    return OddSlices(slices, samples, intensities).find();
}

std::optional<SliceFault> findFaultOfAll(std::span<const std::size_t> slices, const SliceSamples& samples,
                                         std::span<const SliceIntensity> intensities) {
    constexpr std::size_t kLookedAt = 9;
    const std::size_t stride = std::max<std::size_t>(1, slices.size() / kLookedAt);
    for (const SliceFault reading : kReadings) {
        double asSaid = 0.0;
        double otherwise = 0.0;
        for (std::size_t i = 0; i < slices.size(); i += stride) {
            const std::span<const float> own = samples[slices[i]];
            const std::vector<float> other = readAs(reading, intensities[slices[i]], own);
            asSaid += roughness(own);
            otherwise += roughness(other.empty() ? own : std::span<const float>(other));
        }
        if (kFarLess * otherwise < asSaid) return reading;
    }
    return {};
}

std::vector<RescaleStep> findRescaleSteps(std::span<const std::size_t> slices, const SliceSamples& samples,
                                          std::span<const SliceIntensity> intensities) {
    const auto changes = [&](std::size_t i) {
        const SliceIntensity& before = intensities[slices[i - 1]];
        const SliceIntensity& here = intensities[slices[i]];
        return !before.modalityLut && !here.modalityLut && !sameRescale(before, here);
    };
    std::vector<std::size_t> places;
    for (std::size_t i = 1; i < slices.size(); ++i) {
        if (changes(i)) places.push_back(i);
    }
    // If each slice has its own rescale, as in PET, nothing shows how far values change anyway.
    if (places.empty() || 2 * places.size() > slices.size()) return {};
    std::vector<double> usual;
    for (std::size_t i = 1; i < slices.size(); ++i) {
        if (!changes(i))
            usual.push_back(std::abs(medianDifference(samples[slices[i - 1]], samples[slices[i]])));
    }
    const double typical = median(std::move(usual));
    std::vector<RescaleStep> steps;
    for (const std::size_t i : places) {
        const std::span<const float> below = samples[slices[i - 1]];
        const std::span<const float> own = samples[slices[i]];
        const std::vector<float> shared =
            withRescaleOf(intensities[slices[i - 1]], intensities[slices[i]], own);
        const double apart = distance(below, own);
        const double moved = std::abs(medianDifference(below, own));
        const bool isShift =
            moved > kFarLess * std::abs(medianDifference(below, shared)) && moved > kFarLess * typical;
        if (isShift || apart > kFarLess * distance(below, shared))
            steps.push_back({slices[i], isShift ? moved : apart});
    }
    return steps;
}

}  // namespace macula::dicom
