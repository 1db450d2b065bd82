#include "dicom/write/item_writer.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <iterator>

namespace macula::dicom {

namespace {

constexpr long kNext = -2;  // of findOrCreateSequenceItem

DcmTagKey keyOf(Tag tag) {
    return {tag.group, tag.element};
}

template <class Values>
unsigned long countOf(const Values& values) {
    return static_cast<unsigned long>(std::size(values));
}

DcmEVR vrOf(ItemWriter::WordVr vr) {
    return vr == ItemWriter::WordVr::us ? EVR_US : EVR_OW;
}

}  // namespace

void ItemWriter::note(const OFCondition& done) {
    *ok_ = *ok_ && done.good();
}

void ItemWriter::text(const DcmTagKey& tag, const std::string& value) {
    note(item_->putAndInsertString(tag, value.c_str()));
}

void ItemWriter::text(Tag tag, const std::string& value) {
    text(keyOf(tag), value);
}

void ItemWriter::word(const DcmTagKey& tag, std::uint16_t value) {
    note(item_->putAndInsertUint16(tag, value));
}

void ItemWriter::word(Tag tag, std::uint16_t value) {
    word(keyOf(tag), value);
}

void ItemWriter::words(const DcmTagKey& tag, WordVr vr, std::span<const std::uint16_t> values) {
    note(item_->putAndInsertUint16Array(DcmTag(tag, vrOf(vr)), values.data(), countOf(values)));
}

void ItemWriter::words(Tag tag, WordVr vr, std::span<const std::uint16_t> values) {
    words(keyOf(tag), vr, values);
}

void ItemWriter::longs(const DcmTagKey& tag, std::span<const std::uint32_t> values) {
    note(item_->putAndInsertUint32Array(tag, values.data(), countOf(values)));
}

void ItemWriter::bytes(const DcmTagKey& tag, std::span<const std::uint8_t> values) {
    note(item_->putAndInsertUint8Array(DcmTag(tag, EVR_OB), values.data(), countOf(values)));
}

void ItemWriter::bytes(Tag tag, std::span<const std::uint8_t> values) {
    bytes(keyOf(tag), values);
}

void ItemWriter::floats(const DcmTagKey& tag, std::span<const float> values) {
    note(item_->putAndInsertFloat32Array(tag, values.data(), countOf(values)));
}

void ItemWriter::numbers(const DcmTagKey& tag, std::initializer_list<double> values) {
    note(item_->putAndInsertFloat64Array(tag, std::data(values), countOf(values)));
}

void ItemWriter::numbers(Tag tag, std::initializer_list<double> values) {
    numbers(keyOf(tag), values);
}

void ItemWriter::tagName(const DcmTagKey& tag, const DcmTagKey& value) {
    note(item_->putAndInsertTagKey(tag, value));
}

void ItemWriter::emptySequence(const DcmTagKey& tag) {
    note(item_->insertEmptyElement(tag));
}

ItemWriter ItemWriter::item(const DcmTagKey& sequence, std::size_t place) {
    DcmItem* made = nullptr;
    note(item_->findOrCreateSequenceItem(sequence, made, static_cast<long>(place)));
    return {made != nullptr ? *made : *item_, *ok_};
}

ItemWriter ItemWriter::item(Tag sequence, std::size_t place) {
    return item(keyOf(sequence), place);
}

ItemWriter ItemWriter::nextItem(const DcmTagKey& sequence) {
    DcmItem* made = nullptr;
    note(item_->findOrCreateSequenceItem(sequence, made, kNext));
    return {made != nullptr ? *made : *item_, *ok_};
}

}  // namespace macula::dicom
