#include "scene/followup/follow_up.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/check.h"
#include "base/csv.h"
#include "base/parsing.h"

namespace macula::scene {

namespace {

// Of RECIST 1.1.
constexpr double kPartial = 0.3;
constexpr double kProgress = 0.2;
constexpr double kProgressMm = 5.0;
constexpr double kNormalNodeMm = 10.0;
constexpr double kMeasurableMm = 10.0;
constexpr double kMeasurableNodeMm = 15.0;
constexpr std::size_t kMostTargets = 5;
constexpr double kRounding = 1e-9;

// What was measured of a lesion in one exam: the longest of each axis.
struct Found {
    std::string label;
    double longMm = 0.0;
    std::optional<double> shortMm;
    bool isNode = false;
    std::size_t times = 0;
};
using FoundByKey = std::map<std::string, Found>;

std::optional<Found> foundOf(const slices::Measurement& measurement) {
    Found found{.label = std::string(trimmed(measurement.label)), .times = 1};
    if (const auto* distance = std::get_if<slices::Distance>(&measurement.shape)) {
        found.longMm = slices::lengthMm(*distance);
    } else if (const auto* lesion = std::get_if<slices::Bidirectional>(&measurement.shape)) {
        const slices::Axes axes = slices::axesOf(*lesion);
        found.longMm = axes.longMm;
        found.shortMm = axes.shortMm;
        found.isNode = lesion->isNode;
    } else {
        return std::nullopt;
    }
    if (found.label.empty() || !std::isfinite(found.longMm)) return std::nullopt;
    return found;
}

FoundByKey foundIn(const FollowedExam& exam) {
    FoundByKey all;
    for (const slices::Measurement& measurement : exam.measurements) {
        const auto found = foundOf(measurement);
        if (!found) continue;
        const auto [at, isFirst] = all.try_emplace(keyOfLesion(found->label), *found);
        if (isFirst) continue;
        Found& kept = at->second;
        ++kept.times;
        kept.isNode |= found->isNode;
        kept.longMm = std::max(kept.longMm, found->longMm);
        if (found->shortMm) kept.shortMm = std::max(*found->shortMm, kept.shortMm.value_or(0.0));
    }
    return all;
}

// Found first after the baseline.
bool isAfterBaseline(const FollowedLesion& lesion, std::size_t baseline) {
    const auto isMeasured = [](const LesionSize& size) { return size.is == LesionSize::Is::measured; };
    const auto end = lesion.sizes.begin() + std::ptrdiff_t(baseline) + 1;
    return lesion.isNew && std::none_of(lesion.sizes.begin(), end, isMeasured);
}

// Makes the table from what was found in each exam.
class Maker {
  public:
    Maker(std::span<const FollowedExam> exams, std::size_t baseline, const GoneLesions& gone) : gone_(gone) {
        MACULA_CHECK(baseline < exams.size());
        table_.baseline = baseline;
        for (const FollowedExam& exam : exams) {
            table_.dates.push_back(exam.date);
            found_.push_back(foundIn(exam));
        }
    }

    FollowUp made() {
        addLesions(table_.baseline);
        for (std::size_t exam = 0; exam < found_.size(); ++exam) addLesions(exam);
        for (std::size_t exam = 0; exam < found_.size(); ++exam) table_.sums.push_back(sumOf(exam));
        addNotes();
        return std::move(table_);
    }

  private:
    void addLesions(std::size_t exam) {
        for (const auto& [key, found] : found_[exam]) {
            if (table_.lesions.size() == kMostFollowedLesions) return;
            if (!listed_.insert(key).second) continue;
            FollowedLesion lesion{.label = found.label, .isNew = exam != table_.baseline, .sizes = {}};
            for (const FoundByKey& each : found_)
                if (const auto at = each.find(key); at != each.end()) lesion.isNode |= at->second.isNode;
            for (std::size_t i = 0; i < found_.size(); ++i)
                lesion.sizes.push_back(sizeIn(i, key, lesion.isNode));
            table_.lesions.push_back(std::move(lesion));
        }
    }

    LesionSize sizeIn(std::size_t exam, const std::string& key, bool isNode) {
        const auto at = found_[exam].find(key);
        if (at == found_[exam].end()) {
            const bool isGone = gone_.contains({key, exam});
            return {.is = isGone ? LesionSize::Is::gone : LesionSize::Is::missing};
        }
        const Found& found = at->second;
        if (found.times > 1) ++repeated_;
        if (!isNode) return {.is = LesionSize::Is::measured, .mm = found.longMm};
        if (!found.isNode) ++nodesByOthers_;
        if (found.shortMm) return {.is = LesionSize::Is::measured, .mm = *found.shortMm};
        ++nodesWithoutShortAxis_;
        return {};
    }

    ExamSum sumOf(std::size_t exam) const {
        ExamSum sum;
        sum.sumMm = totalOf(exam);
        const std::size_t baseline = table_.baseline;
        if (exam <= baseline) {
            sum.response = exam == baseline ? Response::baseline : Response::before;
            return sum;
        }
        for (std::size_t before = baseline; before < exam; ++before)
            if (const auto mm = table_.sums[before].sumMm)
                sum.nadirMm = std::min(*mm, sum.nadirMm.value_or(*mm));
        const auto& first = table_.sums[baseline].sumMm;
        if (!sum.sumMm || !first || !sum.nadirMm) return sum;
        const auto change = [&](double from) {
            return from > 0.0 ? std::optional((*sum.sumMm - from) / from) : std::nullopt;
        };
        sum.fromBaseline = change(*first);
        sum.fromNadir = change(*sum.nadirMm);
        sum.response = responseOf(sum, exam);
        return sum;
    }

    std::optional<double> totalOf(std::size_t exam) const {
        double total = 0.0;
        bool hasOne = false;
        for (const FollowedLesion& lesion : table_.lesions) {
            if (lesion.isNew) continue;
            hasOne = true;
            if (lesion.sizes[exam].is == LesionSize::Is::missing) return std::nullopt;
            total += lesion.sizes[exam].mm;
        }
        return hasOne ? std::optional(total) : std::nullopt;
    }

    Response responseOf(const ExamSum& sum, std::size_t exam) const {
        const bool isNormal = std::ranges::all_of(table_.lesions, [&](const FollowedLesion& lesion) {
            const double mm = lesion.sizes[exam].mm;
            return lesion.isNew || (lesion.isNode ? mm < kNormalNodeMm : mm == 0.0);
        });
        if (isNormal) return Response::complete;
        const auto wasComplete = [](const ExamSum& before) { return before.response == Response::complete; };
        const bool isBack = std::ranges::any_of(table_.lesions, [&](const FollowedLesion& lesion) {
            return !lesion.isNew && !lesion.isNode && lesion.sizes[exam].mm > 0.0;
        });
        if (isBack && std::ranges::any_of(table_.sums, wasComplete)) return Response::progress;
        const double moreMm = *sum.sumMm - *sum.nadirMm;
        const bool isLarger = !sum.fromNadir || *sum.fromNadir >= kProgress - kRounding;
        if (isLarger && moreMm >= kProgressMm - kRounding) return Response::progress;
        if (sum.fromBaseline && *sum.fromBaseline <= -kPartial + kRounding) return Response::partial;
        return Response::stable;
    }

    void addNotes() {
        const auto say = [this](std::size_t count, Text sentence) {
            if (count > 0) table_.notes.push_back(std::move(sentence));
        };
        std::size_t targets = 0, small = 0, isNew = 0, isOld = 0;
        for (const FollowedLesion& lesion : table_.lesions) {
            if (lesion.isNew) {
                ++(isAfterBaseline(lesion, table_.baseline) ? isNew : isOld);
                continue;
            }
            ++targets;
            const LesionSize& first = lesion.sizes[table_.baseline];
            const double leastMm = lesion.isNode ? kMeasurableNodeMm : kMeasurableMm;
            if (first.is == LesionSize::Is::measured && first.mm < leastMm) ++small;
        }
        say(isNew,
            Text("Lesions that were not measured at the baseline, and are in no sum: {}. A new lesion is "
                 "progressive disease whatever its size.",
                 isNew));
        say(isOld,
            Text("Lesions that were measured before the baseline and not at it are in no sum: {}.", isOld));
        say(repeated_, Text("A label stands at several measurements of one study: the longest counts."));
        say(nodesByOthers_,
            Text(
                "A lesion is called a lymph node in one study and not in another: it counts as one in all."));
        say(nodesWithoutShortAxis_, Text("A lymph node was measured with a distance, which has no short "
                                         "axis: it counts as not measured."));
        say(small,
            Text("RECIST 1.1 calls lesions below 10 mm, and lymph nodes below 15 mm, not measurable: at the "
                 "baseline these are {}.",
                 small));
        say(targets > kMostTargets ? targets : 0,
            Text("RECIST 1.1 follows at most five lesions, two in an organ; here are {}.", targets));
    }

    const GoneLesions& gone_;
    std::vector<FoundByKey> found_;  // of each exam
    std::set<std::string> listed_;
    std::size_t repeated_ = 0, nodesByOthers_ = 0, nodesWithoutShortAxis_ = 0;
    FollowUp table_;
};

std::string mmText(std::optional<double> mm) {
    return mm ? fmt::format("{:.3f}", *mm) : std::string();
}

std::string percentText(std::optional<double> part) {
    constexpr double kPercent = 100.0;
    return part ? fmt::format("{:.1f}", kPercent * *part) : std::string();
}

}  // namespace

std::string keyOfLesion(std::string_view label) {
    return lowerCase(std::string(trimmed(label)));
}

FollowUp followUp(std::span<const FollowedExam> exams, std::size_t baseline, const GoneLesions& gone) {
    return Maker(exams, baseline, gone).made();
}

std::string_view nameOf(Response response) {
    switch (response) {
        case Response::baseline:
        case Response::before:
            return "";
        case Response::complete:
            return "CR";
        case Response::partial:
            return "PR";
        case Response::stable:
            return "SD";
        case Response::progress:
            return "PD";
        case Response::unknown:
            return "NE";
    }
    return "";
}

std::string toCsv(const FollowUp& table) {
    std::string csv = "lesion,axis,at_baseline";
    for (const std::string& date : table.dates) csv += fmt::format(",{}_mm", csvWords(date));
    csv += "\r\n";
    for (const FollowedLesion& lesion : table.lesions) {
        csv += fmt::format("{},{},{}", csvWords(lesion.label), lesion.isNode ? "short (node)" : "long",
                           lesion.isNew ? "no" : "yes");
        for (const LesionSize& size : lesion.sizes)
            csv += ',' + (size.is == LesionSize::Is::missing ? std::string() : mmText(size.mm));
        csv += "\r\n";
    }
    const auto line = [&](std::string_view name, const auto& textOf) {
        csv += fmt::format("{},,", name);
        for (const ExamSum& sum : table.sums) csv += ',' + std::string(textOf(sum));
        csv += "\r\n";
    };
    line("sum_mm", [](const ExamSum& sum) { return mmText(sum.sumMm); });
    line("nadir_before_mm", [](const ExamSum& sum) { return mmText(sum.nadirMm); });
    line("change_from_baseline_percent", [](const ExamSum& sum) { return percentText(sum.fromBaseline); });
    line("change_from_nadir_percent", [](const ExamSum& sum) { return percentText(sum.fromNadir); });
    std::string fresh = "new_lesions,,";
    for (std::size_t exam = 0; exam < table.sums.size(); ++exam) {
        const auto count = std::ranges::count_if(table.lesions, [&](const FollowedLesion& lesion) {
            return isAfterBaseline(lesion, table.baseline) &&
                   lesion.sizes[exam].is == LesionSize::Is::measured;
        });
        fresh += exam > table.baseline ? fmt::format(",{}", count) : std::string(",");
    }
    line("recist_1_1_of_these_numbers", [](const ExamSum& sum) {
        return sum.response == Response::baseline ? std::string("baseline")
                                                  : std::string(nameOf(sum.response));
    });
    return csv + fresh + "\r\n";
}

}  // namespace macula::scene
