// The data elements of one header with their values, in flat arrays: no pointer, no recursion, and no memory
// beyond that of the file itself.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dicom/read/dictionary.h"
#include "dicom/read/tags.h"

namespace macula::dicom {

struct Element {
    Tag tag{};
    Vr vr = 0;  // as in the file; 0 when it gives none
    bool bigEndian = false;
    bool isSequence = false;
    bool hasValue = false;     // false for values too large to be kept, and for the pixel data
    std::uint32_t length = 0;  // bytes of the value, or items of the sequence
    std::uint32_t first = 0;   // where the value begins, or the number of the first item
};

// The caller fills it in the order of the file, closes every sequence and item that it opened, and calls
// finish() before any query.
class ElementTree {
  public:
    using ItemNumber = std::uint32_t;
    static constexpr ItemNumber kNone = 0xFFFFFFFF;

    ElementTree() { openItem(0); }
    // `offset` is where the item begins in the file; the tree does not keep offsets beyond 4 GiB.
    void openItem(std::uint64_t offset);
    void closeItem();
    void openSequence(const Element& element);
    void closeSequence();
    void add(const Element& element) { openElements_.push_back(element); }
    // Adds `element` and returns room for its value, which the caller fills at once.
    std::span<unsigned char> addValue(Element element);
    // Closes what is still open.
    void finish();

    // The approximate memory of the tree.
    std::size_t bytes() const {
        return values_.size() + (elements_.size() + openElements_.size()) * sizeof(Element) +
               (items_.size() + closedItems_.size()) * sizeof(Item);
    }

    ItemNumber root() const { return root_; }
    // The item that contains `item`; kNone for the root.
    ItemNumber parent(ItemNumber item) const { return items_[item].parent; }
    // The offset at which the item begins in the file; 0 for the root, and when it is not known.
    std::uint32_t offset(ItemNumber item) const { return items_[item].offset; }
    std::span<const Element> elements(ItemNumber item) const {
        return {elements_.data() + items_[item].first, items_[item].count};  // sorted by tag
    }
    const Element* find(ItemNumber item, Tag tag) const;  // the first if there are several; null when none
    // Elements of the item whose tag an earlier one has; no file should have any (PS3.5 7.1).
    std::vector<const Element*> repeated(ItemNumber item) const;
    std::string_view value(const Element& element) const {
        return element.hasValue ? std::string_view(values_).substr(element.first, element.length)
                                : std::string_view();
    }

  private:
    struct Item {
        std::uint32_t first = 0;  // index in elements_
        std::uint32_t count = 0;
        ItemNumber parent = kNone;
        std::uint32_t offset = 0;  // in the file
    };
    struct OpenItem {
        std::size_t firstElement = 0;  // in openElements_
        std::uint32_t offset = 0;
    };
    struct OpenSequence {
        Element element;
        std::size_t firstItem = 0;  // index in closedItems_
    };

    ItemNumber place(const Item& item);

    std::string values_;
    std::vector<Element> elements_;
    std::vector<std::uint32_t> repeated_;  // in elements_, ascending
    std::vector<Item> items_;
    ItemNumber root_ = kNone;

    // The elements and items that are still open. The root is the first open item.
    std::vector<Element> openElements_;
    std::vector<OpenItem> openItems_;
    std::vector<Item> closedItems_;  // items of sequences that are still open
    std::vector<OpenSequence> openSequences_;
};

}  // namespace macula::dicom
