// What a folder holds, as rows that a person picks from: patients, their studies, series and volumes.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "study/open/found_volumes.h"

namespace macula::app {

inline constexpr std::size_t kNoRow = static_cast<std::size_t>(-1);

// Texts are for the screen only, as those of Identity. They come from files: what shows them keeps them from
// steering it.
struct StudyRow {
    enum class Kind {
        patient,
        study,
        series,
        stack,  // of a series that has several
        presentation,
        leftOut,  // files that are in none of the others, or why
    };

    // What a presentation state shows: a volume in 3D, or on slices.
    struct Presentation {
        std::filesystem::path file;
        std::size_t volume = 0;  // in FoundVolumes::volumes()
        bool isOfSlices = false;
    };

    Kind kind = Kind::patient;
    std::size_t parent = kNoRow;
    std::vector<std::size_t> children = {};  // in the order shown

    std::string title = {};
    std::string titleOfFile = {};           // its end, of text of a file: it is in no language of ours
    std::vector<std::string> details = {};  // lines; lengths have their unit
    std::size_t detailOfFile = kNoRow;      // the line of `details` that is such text
    // A sentence where a series or stack has no volume, or a presentation state cannot be shown; else empty.
    std::string whyNot = {};
    std::vector<std::string> messages = {};  // sentences, each with what to do
    // What opening the row opens, in FoundVolumes::volumes(): of a stack, and of a series that has one
    // volume.
    std::optional<std::size_t> volume = {};
    std::optional<Presentation> presentation = {};  // what opening the row shows
    // Whose middle image stands for the row; the FoundVolumes own it. Null where there is no image.
    const dicom::Stack* picture = nullptr;
    std::string searched = {};  // foldedForSearch, with that of the rows above
};

struct StudyTree {
    std::vector<StudyRow> rows;  // parents before children
    std::vector<std::size_t> top;
};

enum class Names {
    shown,
    hidden,  // "Patient 1"; no description or other text that may name somebody; dates of studies stay
};

// Patients as in the scan, their newest study first, series as in the scan; presentation states below theirs,
// the newest first. All series are listed, but for
// those that dicom::key::kUidPerSlice asks about, which are one row; what was left out of the scan comes
// last.
StudyTree studyTree(const FoundVolumes& found, Names names = Names::shown);

// Which rows are shown for what was typed: those that have all words, be it with the rows above them; what
// is below these; and what is above. All of them when no word was typed.
std::vector<bool> rowsThatMatch(const StudyTree& tree, std::string_view typed);

}  // namespace macula::app
