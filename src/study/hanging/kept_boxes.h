// What is kept of the boxes that a person left for a study: as JSON, without a UID or a text of a file.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "study/open/found_volumes.h"

namespace macula::study {

struct KeptBoxes {
    struct Box {
        std::string series;     // seriesDigest
        std::size_t stack = 0;  // of the series
        std::size_t place = 0;  // in Stack::frames

        bool operator==(const Box&) const = default;
    };
    int rows = 1;
    int columns = 1;
    bool isLinked = false;
    std::vector<std::optional<Box>> boxes;  // row by row; nothing: empty

    bool operator==(const KeptBoxes&) const = default;
};

// Stands for a series where it is kept.
std::string seriesDigest(const dicom::Series& series);

std::string toJson(const KeptBoxes& boxes);
// Nothing for text of another kind, or with values out of range.
std::optional<KeptBoxes> keptBoxesOf(std::string_view json);

// The stack with images that a box had, of the studies of that patient; null: it is not there any more.
const dicom::Stack* stackOf(const KeptBoxes::Box& box, const FoundVolumes& found, int patient);

}  // namespace macula::study
