#include "dicom/split/missing_images.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <utility>

#include "dicom/read/media_directory.h"
#include "dicom/split/stack_ends.h"
#include "dicom/split/stack_numbering.h"

namespace macula::dicom {

namespace {

constexpr int kLocalizers = 2;  // usually one from the front and one from the side
constexpr int kHundred = 100;

// A stack that can be checked for missing images: a volume of files with one frame each.
struct Candidate {
    Series* series = nullptr;
    Stack* stack = nullptr;
    std::optional<StackNumbering> numbering;
};

// How many images seem to be missing, and by what evidence.
struct Claim {
    std::size_t count = 0;
    Text why;
    Severity severity = Severity::warning;
};

bool isOfSingleFrames(const Stack& stack) {
    return std::ranges::none_of(stack.frames, [](const Frame& f) {
        return f.instance->multiFrame || !f.instance->concatenationUid.empty();
    });
}

std::set<int> numbersOf(const Stack& stack) {
    std::set<int> numbers;
    for (const Frame& frame : stack.frames) {
        if (frame.instance->instanceNumber) numbers.insert(*frame.instance->instanceNumber);
    }
    return numbers;
}

std::set<int> numbersOf(const Series& series) {
    std::set<int> numbers;
    for (const Stack& stack : series.stacks) numbers.merge(numbersOf(stack));
    return numbers;
}

// The number of images of each acquisition, by AcquisitionNumber and ImagesInAcquisition.
using Acquisitions = std::map<std::pair<std::optional<int>, int>, std::size_t>;

Acquisitions acquisitionsOf(const Series& series) {
    Acquisitions acquisitions;
    std::set<const Instance*> seen;
    for (const Stack& stack : series.stacks) {
        for (const Frame& frame : stack.frames) {
            const Instance& instance = *frame.instance;
            if (instance.imagesInAcquisition && seen.insert(&instance).second)
                ++acquisitions[{instance.acquisitionNumber, *instance.imagesInAcquisition}];
        }
    }
    return acquisitions;
}

// The number of slices that stacks report as missing between others.
std::size_t gapsIn(const Series& series) {
    std::size_t missing = 0;
    for (const Stack& stack : series.stacks) {
        for (const Message& message : stack.messages) {
            if (message.key != key::kMissingSlices) continue;
            for (const TextArgument& argument : message.arguments) {
                const auto* value = std::get_if<std::int64_t>(&argument.value);
                if (argument.name == "missing" && value != nullptr)
                    missing += static_cast<std::size_t>(*value);
            }
        }
    }
    return missing;
}

class StudyImages {
  public:
    StudyImages(std::vector<Series>& series, const AbsentImages& absent) : series_(series), absent_(absent) {
        for (Series& s : series_) {
            numbers_.push_back(numbersOf(s));
            acquisitions_.push_back(acquisitionsOf(s));
            std::set<int>& ofVolumes = ofVolumes_.emplace_back();
            for (Stack& stack : s.stacks) {
                if (!stack.canBeVolume() || !isOfSingleFrames(stack)) continue;
                candidates_.push_back({&s, &stack, numberingOf(stack)});
                ofVolumes.merge(numbersOf(stack));
            }
        }
    }

    void report() {
        for (std::size_t s = 0; s < series_.size(); ++s) {
            const std::size_t byNumbers = reportNumbers(s);
            reportCounts(series_[s], byNumbers);
        }
    }

  private:
    std::size_t indexOf(const Series* series) const {
        return static_cast<std::size_t>(series - series_.data());
    }

    // Whether some file gives a number of images that is exactly the number in the series.
    static bool isSaidToBeComplete(const Series& series) {
        return std::ranges::any_of(series.stacks, [&](const Stack& stack) {
            return std::ranges::any_of(stack.frames, [&](const Frame& frame) {
                const Instance& instance = *frame.instance;
                return instance.seriesRelatedInstances == static_cast<int>(series.instances) ||
                       instance.imagesInAcquisition == static_cast<int>(series.instances);
            });
        });
    }

    // Whether another stack ends where this one does, at both ends, and is numbered from 0 or 1.
    bool coversWhatACompleteOneDoes(const Candidate& candidate) const {
        return std::ranges::any_of(candidates_, [&](const Candidate& other) {
            if (other.stack == candidate.stack || !other.numbering || other.numbering->lowest() > 1)
                return false;
            const auto reach = reachOfParallel(*candidate.stack, *other.stack);
            return reach && std::ranges::all_of(kStackEnds, [&](StackEnd end) {
                       return endsAlike(*candidate.stack, *other.stack, *reach, end);
                   });
        });
    }

    // Whether another stack of the series ends where this one does.
    bool othersEndHere(const Candidate& candidate, StackEnd end) const {
        return std::ranges::any_of(candidates_, [&](const Candidate& other) {
            if (other.stack == candidate.stack || other.series != candidate.series) return false;
            const auto reach = reachOfParallel(*candidate.stack, *other.stack);
            return reach && endsAlike(*candidate.stack, *other.stack, *reach, end);
        });
    }

    // Whether something explains that numbers begin after `before`, so that nothing is reported.
    bool isExplained(const Candidate& candidate, int before) const {
        constexpr int kThousand = 1000;
        for (std::size_t s = 0; s < series_.size(); ++s) {
            if (&series_[s] == candidate.series || numbers_[s].empty()) continue;
            // Numbers may continue those of another series, with those of localizers between.
            const int last = *numbers_[s].rbegin();
            if (last <= before && last >= before - kLocalizers) return true;
        }
        const int number = candidate.series->number.value_or(0);
        const bool isOfSeries = number > 1 && before % number == 0 &&
                                (before / number == kHundred || before / number == kThousand);
        return isOfSeries || (before >= kThousand && before % kHundred == 0) ||
               isSaidToBeComplete(*candidate.series) || coversWhatACompleteOneDoes(candidate);
    }

    std::optional<Claim> claimOfBeginning(const Candidate& candidate, int missing) const {
        const int lowest = candidate.numbering->lowest();
        const int before = lowest - 1;
        if (isExplained(candidate, before)) return {};
        // Other stacks of this size may have the numbers before, such as phases that were stored separately.
        const auto size = static_cast<int>(candidate.stack->frames.size());
        const bool isDoubtful =
            missing <= kLocalizers || before % kHundred == 0 || (before % size == 0 && before > size);
        return Claim{static_cast<std::size_t>(missing), Text("the image numbers begin at {}", lowest),
                     isDoubtful ? Severity::info : Severity::warning};
    }

    std::optional<Claim> claimOfNumbers(const Candidate& candidate, StackEnd end) const {
        const StackNumbering& numbering = *candidate.numbering;
        const int by = end == StackEnd::last ? numbering.step : -numbering.step;
        const int from = end == StackEnd::last ? numbering.last : numbering.first;
        const NumbersBeyond beyond = numbersBeyond(from, by, numbers_[indexOf(candidate.series)]);
        if (beyond.count == 0) return {};
        const bool isToVolume =
            beyond.another && ofVolumes_[indexOf(candidate.series)].contains(*beyond.another);
        // A localizer may be the first of all; a report may have any number above.
        if (beyond.toTheBeginning || (by < 0 && !isToVolume))
            return claimOfBeginning(candidate, beyond.count);
        if (!isToVolume || othersEndHere(candidate, end)) return {};
        return Claim{
            static_cast<std::size_t>(beyond.count),
            Text("the image numbers leave out {} to {}", std::min(from + by, from + by * beyond.count),
                 std::max(from + by, from + by * beyond.count))};
    }

    static void tellEnd(Stack& stack, StackEnd end, const Claim& claim) {
        tell(stack, message(key::kMissingAtEnds, claim.severity,
                            {{"count", std::int64_t(claim.count)},
                             {"side", sideBeyond(stack, end)},
                             {"evidence", claim.why}}));
    }

    // Returns how many images are missing by the numbers of all stacks of the series.
    std::size_t reportNumbers(std::size_t s) {
        std::size_t missing = 0;
        for (Candidate& candidate : candidates_) {
            if (candidate.series != &series_[s] || !candidate.numbering) continue;
            for (const StackEnd end : kStackEnds) {
                const auto claim = claimOfNumbers(candidate, end);
                if (!claim) continue;
                tellEnd(*candidate.stack, end, *claim);
                missing += claim->count;
            }
        }
        return missing;
    }

    // The images that ImagesInAcquisition claims beyond those present. Some writers count the images of one
    // series, others those of all series made from the acquisition.
    std::optional<Claim> claimOfAcquisitions(const Series& series) const {
        Claim claim;
        int said = 0;
        bool mayBeSeveral = false;
        for (const auto& [acquisition, images] : acquisitions_[indexOf(&series)]) {
            const auto expected = static_cast<std::size_t>(std::max(acquisition.second, 0));
            std::size_t ofAll = 0;
            bool isWholeElsewhere = false;
            for (const Acquisitions& others : acquisitions_) {
                const auto found = others.find(acquisition);
                if (found == others.end()) continue;
                ofAll += found->second;
                isWholeElsewhere = isWholeElsewhere || found->second >= expected;
            }
            const std::size_t there = isWholeElsewhere ? images : ofAll;
            if (there >= expected) continue;
            constexpr std::size_t kReconstructions = 3;
            mayBeSeveral = mayBeSeveral || (expected % images == 0 && expected / images >= kReconstructions);
            claim.count += expected - there;
            said = acquisition.second;
        }
        if (claim.count == 0) return {};
        claim.why = Text("the images say that their acquisition has {} (ImagesInAcquisition)", said);
        if (mayBeSeveral) claim.severity = Severity::info;
        return claim;
    }

    static std::optional<Claim> claimOfSeriesCount(const Series& series) {
        const std::size_t there = series.instances + series.objects.size();
        std::size_t said = 0;
        for (const Stack& stack : series.stacks) {
            for (const Frame& frame : stack.frames)
                said = std::max(said, static_cast<std::size_t>(
                                          std::max(frame.instance->seriesRelatedInstances.value_or(0), 0)));
        }
        if (said <= there) return {};
        return Claim{said - there, Text("the images say that the series has {} "
                                        "(NumberOfSeriesRelatedInstances)",
                                        said)};
    }

    // PET gives the number of slices of a volume (PS3.3 C.8.9.1); gaps are reported elsewhere.
    static std::optional<Claim> claimOfSlices(const Candidate& candidate) {
        int said = 0;
        for (const Frame& frame : candidate.stack->frames)
            said = std::max(said, frame.instance->slicesOfVolume.value_or(0));
        const auto there = static_cast<int>(candidate.stack->frames.size());
        if (candidate.stack->modality != "PT" || said <= there) return {};
        return Claim{static_cast<std::size_t>(said - there),
                     Text("the images say that a volume has {} slices (NumberOfSlices)", said)};
    }

    std::optional<Claim> claimOfDirectory(const Series& series) const {
        const auto found = absent_.find(series.seriesInstanceUid);
        if (found == absent_.end() || found->second.empty()) return {};
        return Claim{found->second.size(), Text("the directory of the medium (DICOMDIR) lists them")};
    }

    // Reports the ends at which images that the directory of the medium lists are missing, by their numbers;
    // false unless each number lies beyond an end.
    bool reportListed(const Candidate& only) {
        const auto& numbers = absent_.at(only.series->seriesInstanceUid);
        std::array<std::size_t, 2> beyond{};
        for (const std::optional<int>& number : numbers) {
            if (!number) return false;
            if (*number < only.numbering->lowest()) {
                ++beyond[only.numbering->lowestIsFirst() ? 0 : 1];
            } else if (*number > only.numbering->highest()) {
                ++beyond[only.numbering->lowestIsFirst() ? 1 : 0];
            } else {
                return false;
            }
        }
        for (std::size_t e = 0; e < kStackEnds.size(); ++e) {
            if (beyond[e] == 0) continue;
            tellEnd(*only.stack, kStackEnds[e],
                    {beyond[e], Text("the directory of the medium (DICOMDIR) lists them")});
        }
        return true;
    }

    // Reports missing images by counts, without those that numbers have reported already, and without gaps.
    void reportCounts(Series& series, std::size_t byNumbers) {
        std::vector<Candidate*> own;
        for (Candidate& candidate : candidates_) {
            if (candidate.series == &series) own.push_back(&candidate);
        }
        const auto listed = claimOfDirectory(series);
        if (own.empty() && !listed) return;
        const bool isOne = own.size() == 1 && own.front()->numbering;
        if (listed && isOne && byNumbers == 0 && gapsIn(series) == 0 && reportListed(*own.front())) return;
        std::optional<Claim> claim = listed;
        const auto ofSlices = own.size() == 1 ? claimOfSlices(*own.front()) : std::nullopt;
        for (const auto& other : {claimOfSeriesCount(series), claimOfAcquisitions(series), ofSlices}) {
            if (other && (!claim || other->count > claim->count)) claim = other;
        }
        if (!claim) return;
        const std::size_t known = byNumbers + gapsIn(series) + series.filesLeftOut;
        if (claim->count <= known) return;
        claim->count -= known;
        // All images from the first number on are present, so the missing ones come after the last.
        if (isOne && (own.front()->numbering->lowest() <= 1 || byNumbers > 0)) {
            const bool up = own.front()->numbering->lowestIsFirst();
            tellEnd(*own.front()->stack, up ? StackEnd::last : StackEnd::first, *claim);
            return;
        }
        tell(series, message(key::kMissingImages, claim->severity,
                             {{"count", std::int64_t(claim->count)}, {"evidence", claim->why}}));
    }

    std::vector<Series>& series_;
    const AbsentImages& absent_;
    std::vector<std::set<int>> numbers_;      // image numbers of each series
    std::vector<std::set<int>> ofVolumes_;    // image numbers of the candidates of each series
    std::vector<Acquisitions> acquisitions_;  // of each series
    std::vector<Candidate> candidates_;
};

std::size_t objectsOf(const Series& series) {
    return series.instances + series.objects.size() + series.filesLeftOut;
}

}  // namespace

std::optional<Message> studyShortfall(const std::vector<Series>& series) {
    std::size_t there = 0;
    int said = 0;
    for (const Series& s : series) {
        there += objectsOf(s);
        for (const Stack& stack : s.stacks) {
            for (const Frame& frame : stack.frames)
                said = std::max(said, frame.instance->studyRelatedInstances.value_or(0));
        }
    }
    if (said <= 0 || static_cast<std::size_t>(said) <= there) return {};
    return message(key::kStudyIncomplete, {{"count", std::int64_t(there)}, {"total", std::int64_t(said)}});
}

void reportMissingImages(std::vector<Series>& series, const AbsentImages& absent) {
    StudyImages(series, absent).report();
}

ListedFiles compareWithDirectories(std::span<const std::filesystem::path> directories,
                                   std::span<const Examination> found) {
    ListedFiles result;
    if (directories.empty()) return result;
    std::set<std::string_view> uids;
    for (const Examination& file : found) uids.insert(file.sopInstanceUid);
    for (const std::filesystem::path& path : directories) {
        const auto directory = readMediaDirectory(path);
        if (!directory) {
            ++result.unreadable;
            continue;
        }
        result.outside += directory->outside;
        for (const ListedFile& listed : directory->missing) {
            if (!listed.sopInstanceUid.empty() && uids.contains(listed.sopInstanceUid)) continue;
            ++result.missing;
            if (!listed.seriesInstanceUid.empty())
                result.absent[listed.seriesInstanceUid].push_back(listed.instanceNumber);
        }
    }
    return result;
}

}  // namespace macula::dicom
