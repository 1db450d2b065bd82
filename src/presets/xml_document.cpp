#include "presets/xml_document.h"

#include <algorithm>

namespace macula::presets {

namespace {

constexpr int kMaxDepth = 64;

// Whether an element is nested too deep, without recursion.
bool isTooDeep(pugi::xml_node root) {
    int depth = 0;
    pugi::xml_node node = root.first_child();
    while (node) {
        if (depth > kMaxDepth) return true;
        if (node.first_child()) {
            node = node.first_child();
            ++depth;
            continue;
        }
        while (node && node != root && !node.next_sibling()) {
            node = node.parent();
            --depth;
        }
        if (!node || node == root) return false;
        node = node.next_sibling();
    }
    return false;
}

}  // namespace

Result<XmlDocument> XmlDocument::parse(std::string_view text, const std::string& where) {
    const auto fail = [&](Text message, Text hint) {
        return Error{ErrorCode::inputNotUsable, std::move(message), where, std::move(hint)};
    };
    // Works in any encoding of the file: UTF-16 only has a zero beside each letter.
    std::string letters;
    std::copy_if(text.begin(), text.end(), std::back_inserter(letters), [](char c) { return c != '\0'; });
    if (letters.find("<!ENTITY") != std::string::npos) {
        return fail(Text("The XML file declares entities, which no preset needs."),
                    Text("Remove the DOCTYPE from the file, or take another one."));
    }
    XmlDocument result;
    const pugi::xml_parse_result parsed = result.document_->load_buffer(text.data(), text.size());
    if (parsed.status == pugi::status_no_document_element)
        return fail(Text("The file holds no XML element."), Text("Check that it is complete."));
    if (!parsed) {
        const auto end = text.begin() + std::clamp<std::ptrdiff_t>(parsed.offset, 0, std::ssize(text));
        return fail(Text("The file is no valid XML around line {}.", 1 + std::count(text.begin(), end, '\n')),
                    Text("Check that it is complete, and look for a missing bracket or quote there."));
    }
    if (isTooDeep(result.root())) {
        return fail(Text("The XML file is nested too deeply."),
                    Text("Give a file that is nested at most {} deep.", kMaxDepth));
    }
    return result;
}

}  // namespace macula::presets
