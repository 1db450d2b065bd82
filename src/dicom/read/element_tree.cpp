#include "dicom/read/element_tree.h"

#include <algorithm>
#include <limits>

#include "base/check.h"

namespace macula::dicom {

namespace {

bool before(const Element& a, const Element& b) {
    return a.tag.key() < b.tag.key();
}

}  // namespace

void ElementTree::openItem(std::uint64_t offset) {
    const bool isKnown = offset <= std::numeric_limits<std::uint32_t>::max();
    openItems_.push_back({openElements_.size(), isKnown ? static_cast<std::uint32_t>(offset) : 0});
}

void ElementTree::closeItem() {
    MACULA_CHECK(!openItems_.empty());
    const auto begin = openElements_.begin() + static_cast<std::ptrdiff_t>(openItems_.back().firstElement);
    if (!std::is_sorted(begin, openElements_.end(), before))
        std::stable_sort(begin, openElements_.end(), before);
    const Item item{.first = static_cast<std::uint32_t>(elements_.size()),
                    .count = static_cast<std::uint32_t>(openElements_.end() - begin),
                    .offset = openItems_.back().offset};
    elements_.insert(elements_.end(), begin, openElements_.end());
    for (std::size_t i = item.first + std::size_t{1}; i < elements_.size(); ++i) {
        if (elements_[i].tag == elements_[i - 1].tag) repeated_.push_back(static_cast<std::uint32_t>(i));
    }
    openElements_.erase(begin, openElements_.end());
    openItems_.pop_back();
    if (openSequences_.empty()) {
        root_ = place(item);
    } else {
        closedItems_.push_back(item);
    }
}

void ElementTree::openSequence(const Element& element) {
    openSequences_.push_back({element, closedItems_.size()});
}

void ElementTree::closeSequence() {
    MACULA_CHECK(!openSequences_.empty());
    auto [element, firstItem] = openSequences_.back();
    openSequences_.pop_back();
    element.isSequence = true;
    element.hasValue = false;
    element.first = static_cast<std::uint32_t>(items_.size());
    element.length = static_cast<std::uint32_t>(closedItems_.size() - firstItem);
    for (std::size_t i = firstItem; i < closedItems_.size(); ++i) place(closedItems_[i]);
    closedItems_.resize(firstItem);
    add(element);
}

ElementTree::ItemNumber ElementTree::place(const Item& item) {
    const auto number = static_cast<ItemNumber>(items_.size());
    items_.push_back(item);
    for (const Element& element : elements(number)) {
        if (!element.isSequence) continue;
        for (std::uint32_t i = 0; i < element.length; ++i) items_[element.first + i].parent = number;
    }
    return number;
}

std::span<unsigned char> ElementTree::addValue(Element element) {
    element.hasValue = true;
    element.first = static_cast<std::uint32_t>(values_.size());
    values_.resize(values_.size() + element.length);
    add(element);
    return {reinterpret_cast<unsigned char*>(values_.data()) + element.first, element.length};
}

void ElementTree::finish() {
    while (!openItems_.empty()) {
        // Either an item of the innermost sequence is open, or that sequence is between two items.
        if (openItems_.size() <= openSequences_.size()) closeSequence();
        closeItem();
    }
}

std::vector<const Element*> ElementTree::repeated(ItemNumber item) const {
    const Item& range = items_[item];
    std::vector<const Element*> found;
    for (auto at = std::ranges::lower_bound(repeated_, range.first);
         at != repeated_.end() && *at < range.first + range.count; ++at)
        found.push_back(&elements_[*at]);
    return found;
}

const Element* ElementTree::find(ItemNumber item, Tag tag) const {
    const auto all = elements(item);
    const auto at = std::lower_bound(all.begin(), all.end(), Element{.tag = tag}, before);
    return at != all.end() && at->tag == tag ? &*at : nullptr;
}

}  // namespace macula::dicom
