#include "net/dimse/command.h"

#include "net/dimse/elements.h"

namespace macula::net {

namespace {

constexpr std::uint16_t kWithoutDataset = 0x0101;

// Elements of group 0000, in ascending order.
class CommandWriter {
  public:
    void number(std::uint16_t element, std::optional<std::uint16_t> value) {
        if (!value) return;
        begin(element, 2);
        little(*value, 2);
    }
    void text(std::uint16_t element, std::string value, char padding) {
        if (value.empty()) return;
        if (value.size() % 2 != 0) value += padding;
        begin(element, value.size());
        bytes_.insert(bytes_.end(), value.begin(), value.end());
    }
    std::vector<unsigned char> withGroupLength() const {
        CommandWriter all;
        all.begin(0x0000, 4);
        all.little(bytes_.size(), 4);
        all.bytes_.insert(all.bytes_.end(), bytes_.begin(), bytes_.end());
        return all.bytes_;
    }

  private:
    void begin(std::uint16_t element, std::size_t length) {
        little(0x0000, 2);
        little(element, 2);
        little(length, 4);
    }
    void little(std::size_t value, int count) {
        for (int i = 0; i < count; ++i) bytes_.push_back(static_cast<unsigned char>(value >> (8 * i)));
    }
    std::vector<unsigned char> bytes_;
};

std::optional<std::uint16_t> wordOf(std::span<const unsigned char> value) {
    if (value.size() != 2) return {};
    return static_cast<std::uint16_t>(value[0] | value[1] << 8);
}

void takeElement(Command& command, const Element& element, std::optional<std::uint16_t>& datasetType) {
    if (element.tag >> 16 != 0) return;
    switch (element.tag & 0xffffu) {
        case 0x0002:
            command.sopClassUid = textOf(element);
            break;
        case 0x0003:
            command.requestedClassUid = textOf(element);
            break;
        case 0x0100:
            command.field = static_cast<CommandField>(wordOf(element.value).value_or(0));
            break;
        case 0x0110:
            command.messageId = wordOf(element.value);
            break;
        case 0x0120:
            command.respondsTo = wordOf(element.value);
            break;
        case 0x0600:
            command.moveDestination = textOf(element);
            break;
        case 0x0700:
            command.priority = wordOf(element.value);
            break;
        case 0x0800:
            datasetType = wordOf(element.value);
            break;
        case 0x0900:
            command.status = wordOf(element.value);
            break;
        case 0x1000:
            command.sopInstanceUid = textOf(element);
            break;
        case 0x1001:
            command.requestedInstanceUid = textOf(element);
            break;
        case 0x1002:
            command.eventType = wordOf(element.value);
            break;
        case 0x1008:
            command.actionType = wordOf(element.value);
            break;
        case 0x1020:
            command.remaining = wordOf(element.value);
            break;
        case 0x1021:
            command.completed = wordOf(element.value);
            break;
        case 0x1022:
            command.failed = wordOf(element.value);
            break;
        case 0x1023:
            command.withWarning = wordOf(element.value);
            break;
        default:
            break;
    }
}

}  // namespace

std::vector<unsigned char> bytesOf(const Command& command) {
    CommandWriter writer;
    writer.text(0x0002, command.sopClassUid, '\0');
    writer.text(0x0003, command.requestedClassUid, '\0');
    writer.number(0x0100, static_cast<std::uint16_t>(command.field));
    writer.number(0x0110, command.messageId);
    writer.number(0x0120, command.respondsTo);
    writer.text(0x0600, command.moveDestination, ' ');
    writer.number(0x0700, command.priority);
    writer.number(0x0800, command.hasDataset ? std::uint16_t{0x0001} : kWithoutDataset);
    writer.number(0x0900, command.status);
    writer.text(0x1000, command.sopInstanceUid, '\0');
    writer.text(0x1001, command.requestedInstanceUid, '\0');
    writer.number(0x1002, command.eventType);
    writer.number(0x1008, command.actionType);
    writer.number(0x1020, command.remaining);
    writer.number(0x1021, command.completed);
    writer.number(0x1022, command.failed);
    writer.number(0x1023, command.withWarning);
    return writer.withGroupLength();
}

std::optional<Command> commandOf(std::span<const unsigned char> bytes) {
    Command command;
    std::optional<std::uint16_t> datasetType;
    const bool isWhole = forEachElement(bytes, Encoding::implicitLittle, [&](const Element& element) {
        takeElement(command, element, datasetType);
        return true;
    });
    if (!isWhole || command.field == CommandField::none || !datasetType) return {};
    command.hasDataset = *datasetType != kWithoutDataset;
    return command;
}

}  // namespace macula::net
