// Fills in data sets and items of sequences. Only for the writers of DICOM objects.
#pragma once

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

#include "dicom/read/tags.h"

namespace macula::dicom {

// A data set or an item of one. Once something does not fit its VR, all fails: `ok` becomes false, and the
// object must not be written.
class ItemWriter {
  public:
    ItemWriter(DcmItem& item, bool& ok) : item_(&item), ok_(&ok) {}

    void text(const DcmTagKey& tag, const std::string& value) {
        note(item_->putAndInsertString(tag, value.c_str()));
    }
    void text(Tag tag, const std::string& value) { text(keyOf(tag), value); }
    void word(const DcmTagKey& tag, std::uint16_t value) { note(item_->putAndInsertUint16(tag, value)); }
    void word(Tag tag, std::uint16_t value) { word(keyOf(tag), value); }
    // The caller gives the VR, because the dictionary leaves open which VR of 16 bits it is.
    void words(const DcmTagKey& tag, DcmEVR vr, std::span<const std::uint16_t> values) {
        note(item_->putAndInsertUint16Array(DcmTag(tag, vr), values.data(), countOf(values)));
    }
    void words(Tag tag, DcmEVR vr, std::span<const std::uint16_t> values) { words(keyOf(tag), vr, values); }
    void longs(const DcmTagKey& tag, std::span<const std::uint32_t> values) {
        note(item_->putAndInsertUint32Array(tag, values.data(), countOf(values)));
    }
    void bytes(const DcmTagKey& tag, std::span<const std::uint8_t> values) {
        note(item_->putAndInsertUint8Array(DcmTag(tag, EVR_OB), values.data(), countOf(values)));
    }
    void bytes(Tag tag, std::span<const std::uint8_t> values) { bytes(keyOf(tag), values); }
    void floats(const DcmTagKey& tag, std::span<const float> values) {
        note(item_->putAndInsertFloat32Array(tag, values.data(), countOf(values)));
    }
    void numbers(const DcmTagKey& tag, std::initializer_list<double> values) {
        note(item_->putAndInsertFloat64Array(tag, std::data(values), countOf(values)));
    }
    void numbers(Tag tag, std::initializer_list<double> values) { numbers(keyOf(tag), values); }
    void tagName(const DcmTagKey& tag, const DcmTagKey& value) {  // VR AT
        note(item_->putAndInsertTagKey(tag, value));
    }
    void emptySequence(const DcmTagKey& tag) { note(item_->insertEmptyElement(tag)); }

    ItemWriter item(const DcmTagKey& sequence, std::size_t place) {
        DcmItem* made = nullptr;
        note(item_->findOrCreateSequenceItem(sequence, made, static_cast<long>(place)));
        return {made != nullptr ? *made : *item_, *ok_};
    }
    ItemWriter item(Tag sequence, std::size_t place) { return item(keyOf(sequence), place); }
    // The next of a sequence, in constant time: item() walks to its place.
    ItemWriter nextItem(const DcmTagKey& sequence) {
        DcmItem* made = nullptr;
        note(item_->findOrCreateSequenceItem(sequence, made, -2));
        return {made != nullptr ? *made : *item_, *ok_};
    }
    // For what has no method here.
    DcmItem& dcmtk() { return *item_; }
    void note(const OFCondition& done) { *ok_ = *ok_ && done.good(); }

  private:
    static DcmTagKey keyOf(Tag tag) { return {tag.group, tag.element}; }
    template <class Values>
    static unsigned long countOf(const Values& values) {
        return static_cast<unsigned long>(std::size(values));
    }

    DcmItem* item_;
    bool* ok_;
};

}  // namespace macula::dicom
