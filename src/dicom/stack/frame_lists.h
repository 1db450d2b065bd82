// Lists of a multi-frame file with a value for each frame, outside of the frames' data sets, as in nuclear
// medicine (Frame Increment Pointer, PS3.3 C.7.6.6.1.1 and C.8.4.8); and indices by dimension (C.7.6.17).
#pragma once

#include <string>
#include <vector>

#include "dicom/read/dataset.h"
#include "dicom/stack/split_rules.h"

namespace macula::dicom {

class FrameLists {
  public:
    FrameLists(const SplitRules& rules, const Dataset& header);

    // Sets the attributes of the rules that the lists give for frame `number`, from 0, with data set `frame`.
    void apply(const Dataset& frame, int number, std::vector<std::string>& attributes) const;
    // Whether lists may have set this attribute. One shared by all frames separates nothing.
    bool mayHave(std::size_t attribute) const;

  private:
    struct List {
        std::size_t attribute;  // of the rules
        std::vector<double> values;
    };

    std::string indicesOf(const Dataset& frame) const;

    std::vector<List> lists_;
    std::vector<std::size_t> ofDimensions_;  // attributes of the rules
    std::vector<bool> isOfPlace_;            // for each dimension, whether it gives a place
};

}  // namespace macula::dicom
