#include "pathtracer/ply_header.h"

#include <algorithm>
#include <array>
#include <charconv>

#include <fmt/format.h>

#include "core/error.h"
#include "pathtracer/scene_source.h"

namespace emulsion {

namespace {

struct TypeName {
    std::string_view name;
    PlyType type;
};
constexpr auto kTypes = std::to_array<TypeName>({{"char", PlyType::int8},
                                                 {"int8", PlyType::int8},
                                                 {"uchar", PlyType::uint8},
                                                 {"uint8", PlyType::uint8},
                                                 {"short", PlyType::int16},
                                                 {"int16", PlyType::int16},
                                                 {"ushort", PlyType::uint16},
                                                 {"uint16", PlyType::uint16},
                                                 {"int", PlyType::int32},
                                                 {"int32", PlyType::int32},
                                                 {"uint", PlyType::uint32},
                                                 {"uint32", PlyType::uint32},
                                                 {"float", PlyType::float32},
                                                 {"float32", PlyType::float32},
                                                 {"double", PlyType::float64},
                                                 {"float64", PlyType::float64}});

/// Longer lines are no header: a binary file of another kind may have none at all.
constexpr std::size_t kMostLineBytes = 4096;

/// Takes the header line by line, and each line word by word.
class HeaderLines {
  public:
    HeaderLines(const std::filesystem::path& path, std::string_view bytes) : path_(path), bytes_(bytes) {
        const std::size_t end = bytes.find_first_of("\r\n");
        if (bytes.substr(0, end) != "ply") fail(quote(bytes.substr(0, std::min(end, std::size_t{12}))), "\"ply\"");
        if (end != std::string_view::npos) line_end_ = bytes.substr(end, bytes.substr(end, 2) == "\r\n" ? 2 : 1);
        offset_ = 3 + line_end_.size();
    }

    void next_line() {
        ++line_;
        const std::size_t end =
            line_end_.empty() ? std::string_view::npos : bytes_.substr(0, most_end()).find(line_end_, offset_);
        if (end == std::string_view::npos) fail("the end of the file or a very long line", "a line of the header");
        words_ = bytes_.substr(offset_, end - offset_);
        offset_ = end + line_end_.size();
    }
    /// Empty at the end of the line.
    std::string_view next_word() noexcept {
        words_.remove_prefix(std::min(words_.find_first_not_of(" \t"), words_.size()));
        const std::string_view word = words_.substr(0, words_.find_first_of(" \t"));
        words_.remove_prefix(word.size());
        return word;
    }
    [[noreturn]] void fail(const std::string& found, const std::string& expected) const {
        throw IoError(path_, fmt::format("line {}: found {}, expected {}", line_, found, expected));
    }
    [[nodiscard]] std::size_t offset() const noexcept { return offset_; }

  private:
    [[nodiscard]] std::size_t most_end() const noexcept { return std::min(bytes_.size(), offset_ + kMostLineBytes); }

    const std::filesystem::path& path_;
    std::string_view bytes_, line_end_, words_;
    std::size_t offset_ = 0;
    int line_ = 1;
};

PlyFormat read_format(HeaderLines& lines) {
    const std::string_view format = lines.next_word(), version = lines.next_word();
    if (version != "1.0") lines.fail("version " + quote(version), "1.0");
    if (format == "ascii") return PlyFormat::ascii;
    if (format == "binary_little_endian") return PlyFormat::little_endian;
    if (format == "binary_big_endian") return PlyFormat::big_endian;
    lines.fail("the format " + quote(format), "ascii, binary_little_endian or binary_big_endian");
}

PlyType type_of(std::string_view word, const HeaderLines& lines) {
    const auto* const row = std::find_if(kTypes.begin(), kTypes.end(), [&](const auto& t) { return t.name == word; });
    if (row != kTypes.end()) return row->type;
    lines.fail("the type " + quote(word), "char, uchar, short, ushort, int, uint, float or double");
}

PlyElement read_element(HeaderLines& lines) {
    PlyElement element{std::string(lines.next_word()), 0, {}};
    const std::string_view count = lines.next_word();
    const auto [end, error] = std::from_chars(count.data(), count.data() + count.size(), element.count);
    if (error != std::errc{} || end != count.data() + count.size()) {
        lines.fail(quote(count) + " as the number of " + quote(element.name), "a whole number");
    }
    return element;
}

PlyProperty read_property(HeaderLines& lines) {
    PlyProperty property;
    std::string_view word = lines.next_word();
    if (word == "list") {
        property.count_type = type_of(lines.next_word(), lines);
        if (*property.count_type == PlyType::float32 || *property.count_type == PlyType::float64) {
            lines.fail("lists counted by fractions", "a count of a whole type");
        }
        word = lines.next_word();
    }
    property.type = type_of(word, lines);
    property.name = lines.next_word();
    if (property.name.empty()) lines.fail("a property without a name", "one");
    return property;
}

}  // namespace

std::size_t size_of(PlyType type) noexcept {
    switch (type) {
        case PlyType::int8:
        case PlyType::uint8:
            return 1;
        case PlyType::int16:
        case PlyType::uint16:
            return 2;
        case PlyType::int32:
        case PlyType::uint32:
        case PlyType::float32:
            return 4;
        default:
            return 8;
    }
}

PlyHeader read_ply_header(const std::filesystem::path& path, std::string_view bytes) {
    HeaderLines lines(path, bytes);
    PlyHeader header;
    bool has_format = false;
    while (true) {
        lines.next_line();
        const std::string_view keyword = lines.next_word();
        if (keyword == "end_header") break;
        if (keyword == "comment" || keyword == "obj_info" || keyword.empty()) continue;
        if (keyword == "format") {
            header.format = read_format(lines);
            has_format = true;
        } else if (keyword == "element") {
            header.elements.push_back(read_element(lines));
        } else if (keyword == "property" && !header.elements.empty()) {
            header.elements.back().properties.push_back(read_property(lines));
        } else {
            lines.fail(quote(keyword), "format, comment, element, property (of an element) or end_header");
        }
    }
    if (!has_format) lines.fail("the end of the header", "a format before it");
    header.body_offset = lines.offset();
    return header;
}

const PlyElement* find_element(const PlyHeader& header, std::string_view name) noexcept {
    const auto& all = header.elements;
    const auto found = std::find_if(all.begin(), all.end(), [&](const PlyElement& e) { return e.name == name; });
    return found == all.end() ? nullptr : &*found;
}

}  // namespace emulsion
