// What tells the images of a series apart, as data: rules/split.json, which says how to read it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dicom/read/dataset.h"

namespace macula::dicom {

struct Attribute {
    // A time is that of a date and a time of day, or of the latter; a source that holds a date alone is
    // passed over, and the offset of the image's time zone stands at its end (PS3.5 6.2, DT; 0008,0201).
    enum class Kind { text, number, numbers, time, contains };
    // Where a frame's value is: in its data set; at its place in a list with a value for each frame of the
    // file (PS3.3 C.7.6.6.1.1); among the frame's indices by dimension (C.7.6.17): see frame_lists.h.
    enum class Reading { value, list, dimensions };

    // Where the attribute may be; `before` is put in front of the value where there is one: the date before a
    // time. `within`: in the first item of that sequence. `bias`: the value is the first number without it,
    // where that is not less; 0 where there is none.
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
    std::string value;  // contains: what is looked for among the values
    Reading reading = Reading::value;

    bool operator==(const Attribute&) const = default;
};

struct SplitRules {
    struct Hard {
        std::size_t attribute;  // in `attributes`
        std::string message;    // key of the message that tells of a separation
    };
    struct Soft {
        enum class Step { silent, once, always };

        std::size_t attribute;
        std::string modality;  // empty: any
        bool evenToo = false;  // separates interleaved images also when they make an even volume together
        bool interleavable =
            false;  // MR slices that do not overlap are not separated: they are acquired interleaved
        Step step = Step::silent;  // which changes along a stack are warned of
    };
    struct Phase {
        enum class By { value, rank };

        std::size_t attribute;
        By by = By::value;
        bool first = false;    // says what it is: asked before the soft attributes
        bool assumed = false;  // no property of the image, only the best that is left
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
// `attributes`. `frame` is the data set of one frame; what is in lists is left empty.
std::vector<std::string> readAttributes(const SplitRules& rules, const Dataset& frame);

// Whether two values of an attribute are the same, within its tolerance.
bool sameValue(const Attribute& attribute, std::string_view a, std::string_view b);

// Nothing when the text is no number, or the first of several is none.
std::optional<double> numberOf(std::string_view text);

}  // namespace macula::dicom
