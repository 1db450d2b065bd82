#include "study/open/phases.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "base/parsing.h"
#include "dicom/read/date_time.h"
#include "study/open/stack_label_text.h"

namespace macula::study {

namespace {

constexpr std::size_t kLeastSeries = 3;  // fewer may differ in anything

bool haveSameGrid(const dicom::Stack& a, const dicom::Stack& b) {
    if (a.columns != b.columns || a.rows != b.rows || a.slices.size() != b.slices.size()) return false;
    constexpr double kRounding = 1e-3;
    for (int column = 0; column < 4; ++column)
        if (!(glm::length((*a.worldFromVoxel)[column] - (*b.worldFromVoxel)[column]) < kRounding))
            return false;
    return true;
}

// The attribute that tells phases apart is the last one that a series was split by.
const dicom::StackLabel* phaseLabel(const dicom::Stack& stack) {
    return stack.splitBy.empty() ? nullptr : &stack.splitBy.back();
}

bool haveSameOtherLabels(const dicom::Stack& a, const dicom::Stack& b) {
    if (a.splitBy.size() != b.splitBy.size() || a.splitBy.empty()) return false;
    return a.splitBy.back().attribute == b.splitBy.back().attribute &&
           std::equal(a.splitBy.begin(), a.splitBy.end() - 1, b.splitBy.begin());
}

// Values of dates and times may have an offset, and no date.
std::optional<double> timeMs(const dicom::StackLabel& label) {
    constexpr std::array<std::string_view, 2> kInMs{"TriggerTime", "FrameReferenceTime"};
    if (std::ranges::find(kInMs, label.attribute) != kInMs.end()) return finiteNumber(label.value);
    if (!label.attribute.ends_with("Time")) return std::nullopt;
    const auto moment = dicom::momentOf(label.value);
    return moment ? std::optional(moment->seconds * 1000.0) : std::nullopt;
}

// All times, from the first; none if one is missing, or they do not rise.
void setTimes(std::vector<Phase>& phases, const std::vector<std::optional<double>>& atMs) {
    for (std::size_t i = 0; i < phases.size(); ++i)
        if (!atMs[i] || (i > 0 && !(*atMs[i] > *atMs[i - 1]))) return;
    for (std::size_t i = 0; i < phases.size(); ++i) phases[i].atMs = *atMs[i] - *atMs[0];
}

std::vector<Phase> ofOneSeries(const FoundVolumes& found, std::size_t volume) {
    const auto& volumes = found.volumes();
    const FoundVolume& chosen = volumes[volume];
    if (chosen.stack->phases < 2) return {};
    std::vector<std::size_t> members;
    for (std::size_t i = 0; i < volumes.size(); ++i)
        if (volumes[i].series == chosen.series && volumes[i].stack->phases == chosen.stack->phases &&
            haveSameOtherLabels(*volumes[i].stack, *chosen.stack) &&
            haveSameGrid(*volumes[i].stack, *chosen.stack))
            members.push_back(i);
    std::ranges::stable_sort(members, {}, [&](std::size_t i) { return volumes[i].stack->phase; });
    std::vector<Phase> phases;
    std::vector<std::optional<double>> atMs;
    for (const std::size_t i : members) {
        const dicom::StackLabel& label = *phaseLabel(*volumes[i].stack);
        phases.push_back({.volume = i, .label = textOf(label), .atMs = {}});
        atMs.push_back(timeMs(label));
    }
    setTimes(phases, atMs);
    return phases;
}

// A description without its last number, and that number.
struct Numbered {
    std::string words;
    double number = 0.0;
};

std::optional<Numbered> numbered(const std::string& description) {
    const auto isDigit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
    const auto last = std::find_if(description.rbegin(), description.rend(), isDigit).base();
    auto first = last;
    while (first != description.begin() && isDigit(*(first - 1))) --first;
    if (first == last || last - first > 6) return std::nullopt;
    return Numbered{
        .words = std::string(description.begin(), first) + '#' + std::string(last, description.end()),
        .number = finiteNumber(std::string(first, last)).value_or(0.0)};
}

bool namesAPhase(const std::string& description) {
    std::string lower;
    for (const char c : description) lower += char(std::tolower(static_cast<unsigned char>(c)));
    constexpr std::array<std::string_view, 5> kWords{"%", "phase", "gated", "4d", "resp"};
    return std::ranges::any_of(kWords,
                               [&](std::string_view word) { return lower.find(word) != std::string::npos; });
}

std::vector<Phase> ofSeveralSeries(const FoundVolumes& found, std::size_t volume) {
    const auto& volumes = found.volumes();
    const FoundVolume& chosen = volumes[volume];
    const auto usual = numbered(chosen.series->description);
    if (!usual || !namesAPhase(chosen.series->description)) return {};
    std::vector<std::pair<double, std::size_t>> members;
    for (std::size_t i = 0; i < volumes.size(); ++i) {
        const FoundVolume& other = volumes[i];
        const auto named = numbered(other.series->description);
        if (other.study != chosen.study || !named || named->words != usual->words ||
            other.series->modality != chosen.series->modality || !haveSameGrid(*other.stack, *chosen.stack))
            continue;
        // Two volumes of one number are no phases.
        if (std::ranges::find(members, named->number, &std::pair<double, std::size_t>::first) !=
            members.end())
            return {};
        members.emplace_back(named->number, i);
    }
    if (members.size() < kLeastSeries) return {};
    std::ranges::sort(members);
    std::vector<Phase> phases;
    for (const auto& member : members)
        phases.push_back({.volume = member.second,
                          .label = Text::verbatim(volumes[member.second].series->description),
                          .atMs = {}});
    return phases;
}

}  // namespace

std::vector<Phase> phasesOf(const FoundVolumes& found, std::size_t volume) {
    if (volume >= found.volumes().size() || !found.volumes()[volume].stack->worldFromVoxel) return {};
    std::vector<Phase> phases = ofOneSeries(found, volume);
    if (phases.size() < 2) phases = ofSeveralSeries(found, volume);
    return phases.size() < 2 ? std::vector<Phase>() : phases;
}

std::vector<Phase> phasesOf(const OpenedStudy& study) {
    if (study.found) return phasesOf(*study.found, study.volumeIndex);
    if (!study.ofFile) return {};
    const VolumesOfFile& of = *study.ofFile;
    std::vector<Phase> phases;
    std::vector<std::optional<double>> atMs;
    for (std::size_t volume = 0; volume < of.count; ++volume) {
        phases.push_back({.volume = volume, .label = labelOf(of, volume), .atMs = {}});
        atMs.push_back(of.axis.isOfTimes() ? of.axis.at(volume) : std::nullopt);
    }
    setTimes(phases, atMs);
    return phases;
}

PhaseSource phaseSourceOf(const OpenedStudy& study) {
    return {.found = study.found, .file = study.ofFile};
}

Result<OpenedStudy> openPhase(const PhaseSource& source, std::size_t volume, Progress& progress) {
    return source.found ? openFoundVolume(source.found, volume, progress)
                        : openVolumeOfFile(source.file, volume, progress);
}

}  // namespace macula::study
