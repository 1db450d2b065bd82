// Lesions that were measured in several studies of a patient: their sizes, the sums of these, and the
// category that RECIST 1.1 gives to the sums (Eisenhauer et al., Eur J Cancer 2009; 45: 228–247).
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/text.h"
#include "slices/measurement.h"

namespace macula::scene {

// One study of the patient, and what was measured on it.
struct FollowedExam {
    std::string date;  // YYYYMMDD
    std::vector<slices::Measurement> measurements;
};

// In one exam.
struct LesionSize {
    enum class Is { measured, gone, missing };
    Is is = Is::missing;
    double mm = 0.0;  // of the axis that counts; 0 if gone

    bool operator==(const LesionSize&) const = default;
};

struct FollowedLesion {
    std::string label;              // as it was first spelt
    bool isNode = false;            // its short axis counts
    bool isNew = false;             // not in the baseline exam: in no sum
    std::vector<LesionSize> sizes;  // of each exam
};

// What the sizes of the lesions of the baseline exam alone give.
enum class Response {
    baseline,  // the exam that others are compared with
    before,    // earlier than that: not compared
    complete,  // CR: all lesions are gone, and the short axes of nodes below 10 mm
    partial,   // PR: the sum is smaller than at baseline by 30 % or more
    stable,    // SD: none of the others
    // PD: the sum is larger than the smallest before by 20 % or more, and by 5 mm or more; or a lesion is
    // back after all were gone
    progress,
    unknown  // NE: a lesion of the baseline was neither measured nor called gone
};

struct ExamSum {
    std::optional<double> sumMm;         // nothing where a lesion of the baseline is missing
    std::optional<double> nadirMm;       // the smallest sum from the baseline to the exam before
    std::optional<double> fromBaseline;  // the change as a part: -0.3 is 30 % less; nothing: not defined
    std::optional<double> fromNadir;
    Response response = Response::unknown;
};

struct FollowUp {
    std::vector<std::string> dates;       // of the exams, YYYYMMDD
    std::size_t baseline = 0;             // index of the exam
    std::vector<FollowedLesion> lesions;  // those of the baseline first, then by the exam that first has them
    std::vector<ExamSum> sums;            // of each exam
    std::vector<Text> notes;              // sentences: what was assumed, and what is not as RECIST wants it
};

// A lesion and the index of an exam.
using GoneLesions = std::set<std::pair<std::string, std::size_t>>;  // labels as keyOfLesion has them

// Labels that differ only in capital letters and in blanks at their ends name one lesion.
std::string keyOfLesion(std::string_view label);

// `exams` are in the order of their dates. Lesions are both axes, and plain distances, with a label; of
// several with one label in an exam the longest counts, of nodes the longest short axis. A lesion is a node
// if it is called one in any exam. `gone` says which lesions that were not measured are gone: their size is
// 0. `baseline` is the index of an exam; at most kMostFollowedLesions lesions.
inline constexpr std::size_t kMostFollowedLesions = 500;
FollowUp followUp(std::span<const FollowedExam> exams, std::size_t baseline, const GoneLesions& gone = {});

// "CR", "PR", "SD", "PD", "NE"; empty for the baseline and what is before it.
std::string_view nameOf(Response response);

// RFC 4180: a line for each lesion with its axis and its size in mm in each exam, then lines with the sum,
// both changes in percent, the category, and how many new lesions there are. Nothing is in a field that is
// not known; a lesion that is gone has 0.
std::string toCsv(const FollowUp& table);

}  // namespace macula::scene
