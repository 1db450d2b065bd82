#include "architecture/functions.h"

#include <algorithm>
#include <cctype>
#include <set>

namespace macula::test {
namespace {

bool isWord(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}
bool isSpace(char c) {
    return std::isspace(static_cast<unsigned char>(c)) != 0;
}

// The place behind a string or character that begins at `from`; of R"x(...)x" too.
std::size_t endOfLiteral(std::string_view text, std::size_t from) {
    if (text[from] == '"' && from > 0 && text[from - 1] == 'R') {
        const std::size_t open = text.find('(', from);
        if (open == std::string_view::npos) return text.size();
        const std::string close = ")" + std::string(text.substr(from + 1, open - from - 1)) + "\"";
        const std::size_t end = text.find(close, open);
        return end == std::string_view::npos ? text.size() : end + close.size();
    }
    for (std::size_t i = from + 1; i < text.size(); ++i) {
        if (text[i] == '\\')
            ++i;
        else if (text[i] == text[from])
            return i + 1;
    }
    return text.size();
}

// Whether a character begins at this quote: not in 1'000, but in 'a' and in U'a'.
bool beginsCharacter(std::string_view text, std::size_t at) {
    std::size_t word = at;
    while (word > 0 && isWord(text[word - 1])) --word;
    const std::string_view prefix = text.substr(word, at - word);
    return prefix.empty() || prefix == "L" || prefix == "u" || prefix == "U" || prefix == "u8";
}

// The place behind a directive that begins at `from`, and behind the lines that continue it.
std::size_t endOfDirective(std::string_view text, std::size_t from) {
    std::size_t end = text.find('\n', from);
    while (end != std::string_view::npos && text[end - 1] == '\\') end = text.find('\n', end + 1);
    return std::min(end, text.size());
}

// The same text with spaces instead of comments, literals and directives: lines stay where they are.
std::string codeAlone(std::string_view text) {
    std::string code(text);
    bool isLineStart = true;
    for (std::size_t i = 0; i < text.size();) {
        std::size_t end = i;
        if (text.substr(i, 2) == "//")
            end = std::min(text.find('\n', i), text.size());
        else if (text.substr(i, 2) == "/*")
            end = std::min(text.find("*/", i + 2), text.size() - 2) + 2;
        else if (text[i] == '"')
            end = endOfLiteral(text, i);
        else if (text[i] == '\'' && beginsCharacter(text, i))
            end = endOfLiteral(text, i);
        else if (text[i] == '#' && isLineStart)
            end = endOfDirective(text, i);
        if (end == i) {
            isLineStart = text[i] == '\n' || (isLineStart && isSpace(text[i]));
            ++i;
            continue;
        }
        for (; i < end; ++i)
            if (text[i] != '\n') code[i] = ' ';
    }
    return code;
}

std::vector<std::string> wordsOf(std::string_view text) {
    std::vector<std::string> words;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (!isWord(text[i])) continue;
        if (i == 0 || !isWord(text[i - 1])) words.emplace_back();
        words.back() += text[i];
    }
    return words;
}

// The name before the first parenthesis: "Image::create" of "Result<Image> Image::create(".
std::string nameBefore(std::string_view head, std::size_t parenthesis) {
    std::size_t end = parenthesis;
    while (end > 0 && isSpace(head[end - 1])) --end;
    std::size_t from = end;
    while (from > 0 && (isWord(head[from - 1]) || head[from - 1] == ':' || head[from - 1] == '~')) --from;
    const std::string name(head.substr(from, end - from));
    return name.empty() ? "operator" : name;
}

// Without the spaces and access specifiers before a declaration.
std::string_view declarationOf(std::string_view head) {
    while (true) {
        while (!head.empty() && isSpace(head.front())) head.remove_prefix(1);
        const std::size_t colon = head.find(':');
        const std::string word(head.substr(0, colon));
        if (colon == std::string_view::npos || (word != "public" && word != "protected" && word != "private"))
            return head;
        head.remove_prefix(colon + 1);
    }
}

// Without `template <...>`, whose defaults would look like those of a variable.
std::string_view withoutTemplate(std::string_view declaration) {
    if (!declaration.starts_with("template")) return declaration;
    int depth = 0;
    for (std::size_t i = 0; i < declaration.size(); ++i) {
        if (declaration[i] == '<') ++depth;
        if (declaration[i] == '>' && --depth == 0) return declarationOf(declaration.substr(i + 1));
    }
    return declaration;
}

enum class Opens { function, scope, value };

// What the brace after `head` opens, where no function is open. `head` is what stands between it and the last
// semicolon or brace.
Opens opens(std::string_view head) {
    head = withoutTemplate(declarationOf(head));
    const auto words = wordsOf(head);
    if (words.empty()) return Opens::value;
    const char last = head[head.find_last_not_of(" \t\r\n")];
    static const std::set<std::string> kScopes{"namespace", "inline", "struct", "class", "union", "extern"};
    const std::size_t parenthesis = head.find('(');
    const bool isOperator = std::ranges::find(words, "operator") != words.end();
    const std::size_t equals = head.find('=');
    if (!isOperator && (equals < parenthesis || head.find("= [") != std::string_view::npos))
        return Opens::value;
    if (kScopes.contains(words.front()) && last != ')' &&
        (words.front() != "inline" || (words.size() > 1 && words[1] == "namespace")))
        return Opens::scope;
    if (parenthesis == std::string_view::npos) return Opens::value;  // an enum, a block of GLSL, a variable
    if (last == ')' || last == '}' || last == '&') return Opens::function;
    static const std::set<std::string> kAfterParameters{"const", "noexcept", "override", "final", "mutable"};
    if (isWord(last) && kAfterParameters.contains(words.back())) return Opens::function;
    const bool hasResultBehind = head.find("->", head.rfind(')')) != std::string_view::npos;
    return hasResultBehind ? Opens::function : Opens::value;  // "a_" of `Name() : a_{1} {`
}

// "Image" of "class Image final : public Picture"; nothing of a namespace.
std::string classNameIn(std::string_view head) {
    const auto words = wordsOf(withoutTemplate(declarationOf(head)));
    if (words.size() < 2 || (words.front() != "class" && words.front() != "struct")) return {};
    std::size_t at = 1;
    if (words[at] == "alignas") at += 2;
    return at < words.size() ? words[at] : std::string();
}

class Scanner {
  public:
    explicit Scanner(std::string_view source) : code_(codeAlone(source)) {}

    std::vector<Function> run(bool& isBalanced) {
        for (at_ = 0; at_ < code_.size(); ++at_) {
            const char c = code_[at_];
            if (c == '(') ++parentheses_;
            if (c == ')') --parentheses_;
            if (c == '{')
                open();
            else if (c == '}')
                close();
            else if (c == ';' && depthOfValues_ == 0 && parentheses_ == 0)
                beginHead();
            if (c == '\n') ++line_;
        }
        isBalanced = balanced_ && open_.empty();
        return std::move(functions_);
    }

    const std::vector<Class>& classes() const { return classes_; }

  private:
    void beginHead() { head_ = at_ + 1; }

    std::string_view head() const { return std::string_view(code_).substr(head_, at_ - head_); }

    void open() {
        Opens kind = Opens::value;
        if (!isInFunction() && depthOfValues_ == 0 && parentheses_ == 0) kind = opens(head());
        if (kind == Opens::function) beginFunction();
        if (kind == Opens::value) ++depthOfValues_;
        scopes_.push_back({kind == Opens::scope ? classNameIn(head()) : std::string(), line_});
        open_.push_back(kind);
        if (kind != Opens::value) beginHead();
    }

    void close() {
        if (open_.empty()) {
            balanced_ = false;
            return;
        }
        const Opens kind = open_.back();
        open_.pop_back();
        if (const Class& scope = scopes_.back(); !scope.name.empty())
            classes_.push_back({scope.name, line_ - scope.lines + 1});
        scopes_.pop_back();
        if (kind == Opens::value) --depthOfValues_;
        if (kind == Opens::function) functions_.back().lines = line_ - functions_.back().line + 1;
        // An initializer list and a default value go on behind their braces: `a_{1}, b_{2} {`.
        if (kind != Opens::value) beginHead();
    }

    bool isInFunction() const { return std::ranges::find(open_, Opens::function) != open_.end(); }

    void beginFunction() {
        const std::string_view text = declarationOf(head());
        const int linesAfter = static_cast<int>(std::count(text.begin(), text.end(), '\n'));
        functions_.push_back({nameBefore(text, text.find('(')), line_ - linesAfter, 0});
    }

    std::string code_;
    std::size_t at_ = 0;
    std::size_t head_ = 0;  // where what stands before the next brace begins
    int line_ = 1;
    int parentheses_ = 0;
    int depthOfValues_ = 0;
    bool balanced_ = true;
    std::vector<Opens> open_;
    std::vector<Class> scopes_;  // of each of these; the name only of a class, with the line of its brace
    std::vector<Function> functions_;
    std::vector<Class> classes_;
};

}  // namespace

std::vector<Function> functionsOf(std::string_view source, bool& isBalanced) {
    return Scanner(source).run(isBalanced);
}

std::vector<Class> classesOf(std::string_view source) {
    Scanner scanner(source);
    bool isBalanced = false;
    scanner.run(isBalanced);
    return scanner.classes();
}

}  // namespace macula::test
