// The contents of a folder as rows to choose from: patients, their studies, series and volumes.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.h"
#include "study/documents/key_images.h"
#include "study/open/found_volumes.h"

namespace macula::study {

inline constexpr std::size_t kNoRow = static_cast<std::size_t>(-1);

// Texts are for the screen only, as those of Identity. They come from files: the view must show them as plain
// text.
struct StudyRow {
    enum class Kind {
        patient,
        study,
        series,
        stack,  // one of several stacks of a series
        presentation,
        document,  // one of several of a series
        leftOut,   // files that are in no other row, or why
    };

    // What a presentation state shows: a volume in 3D, or on slices; or images that are no volume.
    struct Presentation {
        std::filesystem::path file;
        std::size_t volume = 0;  // in FoundVolumes::volumes()
        bool isOfSlices = false;
        const dicom::Stack* images = nullptr;  // not null: these, and no volume
    };

    // A report, a plan, a selection of key images, a PDF (dicom/documents).
    struct Document {
        std::filesystem::path file;
        int patient = 0;  // Study::patient of its study
    };

    Kind kind = Kind::patient;
    std::size_t parent = kNoRow;
    std::vector<std::size_t> children = {};  // in the order shown

    Text title = {};
    std::vector<Text> details = {};  // lines; lengths have their unit
    // A sentence where a series or stack can be shown neither in 3D nor as images, or a presentation state
    // cannot be shown; otherwise empty.
    Text whyNot = {};
    std::vector<Text> messages = {};  // sentences, each with the advised action
    // The volume that the row opens, in FoundVolumes::volumes(): of a stack, or of a series with only one.
    std::optional<std::size_t> volume = {};
    std::optional<Presentation> presentation = {};  // what opening the row shows
    std::optional<Document> document = {};  // likewise: of a series with only one, or of a row of its own
    const dicom::Stack* images = nullptr;   // likewise: without a volume, planar_images.h
    // Its middle image is the thumbnail of the row. Owned by the FoundVolumes; null without an image.
    const dicom::Stack* picture = nullptr;
    std::string searched = {};  // foldedForSearch of title and facts, with that of the rows above
};

struct StudyTree {
    std::vector<StudyRow> rows;  // parents before children
    std::vector<std::size_t> top;
};

enum class Names {
    shown,
    hidden,  // "Patient 1"; no description or other text that may name somebody; dates of studies stay
};

// Patients and series in the order of the scan, studies and presentation states newest first, these below
// their series. Lists all series but those that dicom::key::kUidPerSlice asks about, which share one row.
// Files that were left out of the scan come last.
// `keys` are of the same FoundVolumes; null: nobody has looked for key images.
StudyTree studyTree(const FoundVolumes& found, Names names = Names::shown, const KeyImages* keys = nullptr);

// The rows to show for a search: those that hold all words, counting the words of the rows above them; all
// rows below these, and those above. If nothing was typed, all rows.
std::vector<bool> rowsThatMatch(const StudyTree& tree, std::string_view typed);

}  // namespace macula::study
