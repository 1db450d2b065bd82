// Reads the parts of a frame, each in a source of its own: where it lies, how its pixels become values, and
// what lists outside of its data set say of it.
#pragma once

#include <string>
#include <vector>

#include "dicom/read/dataset.h"
#include "dicom/stack/instance.h"
#include "dicom/stack/split_rules.h"

namespace macula::dicom {

// The distance of each frame along the normal, for objects with one position for all frames: those of dose
// and of nuclear medicine, which list the offsets, and those that only give the distance between slices.
struct FrameOffsets {
    std::vector<double> mm;  // one for each frame whose offset is known; empty for other objects
    bool isByOrder = false;  // only their order shows where frames after the first lie
};
FrameOffsets frameOffsets(const Dataset& header);

// Where the frame lies in the patient (PS3.3 C.7.6.2, C.7.6.16.2.3, C.7.6.16.2.4): fills in position,
// orientation and spacing. `header` is the file's top level, `dataset` the frame's.
void readPlane(const Dataset& header, const Dataset& dataset, double offsetMm, Frame& frame);

// How its pixels become values: fills in the fields for rescale (PS3.3 C.11.1), real world value mapping
// (C.7.6.16.2.11), modality LUT, padding (C.7.5.1.1.2), display windows (C.11.2). frame.instance must be set.
void readValues(const Dataset& dataset, Frame& frame);

// Lists of a multi-frame file with a value for each frame, outside of the frames' data sets, as in nuclear
// medicine (Frame Increment Pointer, PS3.3 C.7.6.6.1.1 and C.8.4.8); and indices by dimension (C.7.6.17).
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
