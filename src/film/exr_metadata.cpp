#include "film/exr_metadata.h"

#include <OpenEXR/ImfStringAttribute.h>

#include "film/exr_attributes.h"

namespace emulsion {

void write_metadata(const FilmMetadata& metadata, Imf::Header& header) {
    for_each_metadata_field(metadata, [&](const char* name, const auto& value) {
        header.insert(name, Imf::StringAttribute(attribute_text(value)));
    });
}

FilmMetadata read_metadata(const Imf::Header& header, std::vector<std::string>& notes) {
    FilmMetadata metadata;
    for_each_metadata_field(metadata, [&](const char* name, auto& value) {
        const auto* attribute = header.findTypedAttribute<Imf::StringAttribute>(name);
        if (!attribute || parse_attribute(attribute->value(), value)) return;
        notes.push_back(std::string(name) + " is \"" + attribute->value() + "\", expected a whole number: left out");
    });
    return metadata;
}

}  // namespace emulsion
