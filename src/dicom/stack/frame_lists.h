// What a multi-frame file says of its frames in lists, beside their own data sets: a value for each frame, as
// nuclear medicine does (Frame Increment Pointer, PS3.3 C.7.6.6.1.1 and C.8.4.8), and indices by dimension
// (C.7.6.17).
#pragma once

#include <string>
#include <vector>

#include "dicom/read/dataset.h"
#include "dicom/stack/split_rules.h"

namespace macula::dicom {

class FrameLists {
  public:
    FrameLists(const SplitRules& rules, const Dataset& header);

    // Sets what the lists say of frame `number`, from 0, whose data set is `frame`, in the attributes of the
    // rules.
    void apply(const Dataset& frame, int number, std::vector<std::string>& attributes) const;
    // Whether lists may have set this attribute. One that all frames of a file have in common tells nothing.
    bool mayHave(std::size_t attribute) const;

  private:
    struct List {
        std::size_t attribute;  // of the rules
        std::vector<double> values;
    };

    std::string indicesOf(const Dataset& frame) const;

    std::vector<List> lists_;
    std::vector<std::size_t> ofDimensions_;  // attributes of the rules
    std::vector<bool> isOfPlace_;            // of each dimension
};

}  // namespace macula::dicom
