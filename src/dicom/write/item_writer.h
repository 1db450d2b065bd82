// Fills in data sets and items of sequences. Only for the writers of DICOM objects.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>

#include "dicom/read/tags.h"

class DcmItem;  // of DCMTK
class DcmTagKey;
class OFCondition;

namespace macula::dicom {

// A data set or an item of one. Once something does not fit its VR, all fails: `ok` becomes false, and the
// object must not be written.
class ItemWriter {
  public:
    ItemWriter(DcmItem& item, bool& ok) : item_(&item), ok_(&ok) {}

    void text(const DcmTagKey& tag, const std::string& value);
    void text(Tag tag, const std::string& value);
    void word(const DcmTagKey& tag, std::uint16_t value);
    void word(Tag tag, std::uint16_t value);
    // The caller gives the VR, because the dictionary leaves open which VR of 16 bits it is.
    enum class WordVr { us, ow };
    void words(const DcmTagKey& tag, WordVr vr, std::span<const std::uint16_t> values);
    void words(Tag tag, WordVr vr, std::span<const std::uint16_t> values);
    void longs(const DcmTagKey& tag, std::span<const std::uint32_t> values);
    void bytes(const DcmTagKey& tag, std::span<const std::uint8_t> values);
    void bytes(Tag tag, std::span<const std::uint8_t> values);
    void floats(const DcmTagKey& tag, std::span<const float> values);
    void numbers(const DcmTagKey& tag, std::initializer_list<double> values);
    void numbers(Tag tag, std::initializer_list<double> values);
    void tagName(const DcmTagKey& tag, const DcmTagKey& value);  // VR AT
    void emptySequence(const DcmTagKey& tag);

    ItemWriter item(const DcmTagKey& sequence, std::size_t place);
    ItemWriter item(Tag sequence, std::size_t place);
    // The next of a sequence, in constant time: item() walks to its place.
    ItemWriter nextItem(const DcmTagKey& sequence);

    // For what has no method here.
    DcmItem& dcmtk() { return *item_; }
    void note(const OFCondition& done);

  private:
    DcmItem* item_;
    bool* ok_;
};

}  // namespace macula::dicom
