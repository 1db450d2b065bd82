// The rules that separate the images of a series, from rules/split.json, which documents its format.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dicom/read/dataset.h"

namespace macula::dicom {

struct Attribute {
    // A time is a date with a time of day, or a time of day alone; a source that holds only a date is
    // skipped. The offset of the image's time zone is appended (PS3.5 6.2, DT; 0008,0201).
    enum class Kind { text, number, numbers, time, contains };
    // The place of a frame's value: its data set; a list with a value for each frame of the file (PS3.3
    // C.7.6.6.1.1); the frame's indices by dimension (C.7.6.17). See FrameLists.
    enum class Reading { value, list, dimensions };

    // A possible place of the attribute. `before` names an element whose text is put in front of the value:
    // the date before a time. `within`: in the first item of that sequence. `bias`: subtracted from the first
    // number, unless that is smaller; 0 means none.
    struct Source {
        std::optional<Tag> before;
        Tag tag;
        std::optional<Tag> within = {};
        double bias = 0.0;

        bool operator==(const Source&) const = default;
    };

    std::string name;  // DICOM keyword
    std::vector<Source> tags;
    Kind kind = Kind::text;
    double tolerance = 0.0;
    double relativeTolerance = 0.0;
    std::string value;  // contains: the value to look for
    Reading reading = Reading::value;

    bool operator==(const Attribute&) const = default;
};

struct SplitRules {
    struct Hard {
        std::size_t attribute;  // in `attributes`
        std::string message;    // key of the message about a separation
    };
    struct Soft {
        enum class Step { silent, once, always };

        std::size_t attribute;
        std::string modality;  // empty: any
        bool evenToo = false;  // separates interleaved images even when together they make an even volume
        bool interleavable =
            false;  // MR slices that do not overlap are not separated: they are acquired interleaved
        Step step = Step::silent;  // which changes along a stack give a warning
    };
    struct Phase {
        enum class By { value, rank };

        std::size_t attribute;
        By by = By::value;
        bool first = false;    // names its phase: tried before the soft attributes
        bool assumed = false;  // no property of the image, only a last resort
    };

    std::vector<Attribute> attributes;  // each once
    std::vector<Hard> hard;
    std::vector<Soft> soft;
    std::vector<std::size_t> runs;  // times, in `attributes`
    std::vector<Phase> phases;
};

// The rules of rules/split.json, built into the program.
const SplitRules& splitRules();

// The value of each attribute of the rules, as text ("" when the image does not have it), in the order of
// `attributes`. `frame` is the data set of one frame; attributes read from lists are left empty.
std::vector<std::string> readAttributes(const SplitRules& rules, const Dataset& frame);

// Whether two values of an attribute are the same, within its tolerance.
bool sameValue(const Attribute& attribute, std::string_view a, std::string_view b);

// The first number of the text; nothing when that is not a number.
std::optional<double> numberOf(std::string_view text);

}  // namespace macula::dicom
